#include <cstring>

#include "tests/android_host/vulkan_state.h"

namespace nacre::test {
namespace {

/// The few functions that a copy takes.
struct Functions {
    template <typename Function>
    Function get(const char* name) const {
        return reinterpret_cast<Function>(record.procedure(device, name));
    }
    const DeviceRecord& record;
    VkDevice device;
};
#define NACRE_GET(name) functions.get<PFN_##name>(#name)

struct Buffer {
    VkBuffer handle = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
};

Buffer makeBuffer(const Functions& functions, VkDeviceSize bytes) {
    Buffer buffer;
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes;
    info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    NACRE_GET(vkCreateBuffer)(functions.device, &info, nullptr, &buffer.handle);
    VkMemoryRequirements needs{};
    NACRE_GET(vkGetBufferMemoryRequirements)(functions.device, buffer.handle, &needs);
    VkPhysicalDeviceMemoryProperties memory{};
    reinterpret_cast<PFN_vkGetPhysicalDeviceMemoryProperties>(loaderFunction(
        functions.record.instance, "vkGetPhysicalDeviceMemoryProperties"))(functions.record.physical, &memory);
    constexpr VkMemoryPropertyFlags kWanted =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    VkMemoryAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocate.allocationSize = needs.size;
    for (std::uint32_t i = memory.memoryTypeCount; i-- > 0;)
        if ((needs.memoryTypeBits >> i & 1) && (memory.memoryTypes[i].propertyFlags & kWanted) == kWanted)
            allocate.memoryTypeIndex = i;
    NACRE_GET(vkAllocateMemory)(functions.device, &allocate, nullptr, &buffer.memory);
    NACRE_GET(vkBindBufferMemory)(functions.device, buffer.handle, buffer.memory, 0);
    return buffer;
}

void recordCopy(const Functions& functions, VkCommandBuffer commands, VkImage image, VkExtent2D extent,
                VkBuffer buffer) {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
    barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    const auto change = NACRE_GET(vkCmdPipelineBarrier);
    constexpr auto kAll = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    change(commands, kAll, kAll, 0, 0, nullptr, 0, nullptr, 1, &barrier);
    VkBufferImageCopy copy{};
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageExtent = {extent.width, extent.height, 1};
    NACRE_GET(vkCmdCopyImageToBuffer)(commands, image, barrier.newLayout, buffer, 1, &copy);
    std::swap(barrier.oldLayout, barrier.newLayout);
    std::swap(barrier.srcAccessMask, barrier.dstAccessMask);
    barrier.dstAccessMask = 0;
    change(commands, kAll, kAll, 0, 0, nullptr, 0, nullptr, 1, &barrier);
}

}  // namespace

std::vector<std::uint8_t> readBack(const DeviceRecord& device, VkDevice handle, VkQueue queue, VkImage image,
                                   VkExtent2D extent, const VkPresentInfoKHR& wait) {
    const Functions functions{device, handle};
    std::vector<std::uint8_t> texels(std::size_t{4} * extent.width * extent.height);
    const Buffer buffer = makeBuffer(functions, texels.size());
    VkCommandPoolCreateInfo poolInfo{};
    poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    poolInfo.queueFamilyIndex = device.queueFamily;
    VkCommandPool pool = VK_NULL_HANDLE;
    NACRE_GET(vkCreateCommandPool)(handle, &poolInfo, nullptr, &pool);
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = pool;
    allocate.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    NACRE_GET(vkAllocateCommandBuffers)(handle, &allocate, &commands);
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    NACRE_GET(vkBeginCommandBuffer)(commands, &begin);
    recordCopy(functions, commands, image, extent, buffer.handle);
    NACRE_GET(vkEndCommandBuffer)(commands);
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    const std::vector<VkPipelineStageFlags> stages(wait.waitSemaphoreCount, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT);
    submit.waitSemaphoreCount = wait.waitSemaphoreCount;
    submit.pWaitSemaphores = wait.pWaitSemaphores;
    submit.pWaitDstStageMask = stages.data();
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    NACRE_GET(vkQueueSubmit)(queue, 1, &submit, VK_NULL_HANDLE);
    NACRE_GET(vkQueueWaitIdle)(queue);
    void* mapped = nullptr;
    if (NACRE_GET(vkMapMemory)(handle, buffer.memory, 0, VK_WHOLE_SIZE, 0, &mapped) == VK_SUCCESS)
        std::memcpy(texels.data(), mapped, texels.size());
    NACRE_GET(vkDestroyCommandPool)(handle, pool, nullptr);
    NACRE_GET(vkDestroyBuffer)(handle, buffer.handle, nullptr);
    NACRE_GET(vkFreeMemory)(handle, buffer.memory, nullptr);
    return texels;
}

/// ROTATE_90 means that the content of the image was turned clockwise by 90 degrees; and so on.
WindowPicture upright(const std::vector<std::uint8_t>& texels, const SwapchainRecord& swapchain) {
    const std::uint32_t w = swapchain.extent.width, h = swapchain.extent.height;
    const bool sideways = swapchain.quarterTurns % 2 != 0;
    WindowPicture picture{sideways ? h : w, sideways ? w : h, {}};
    picture.rgb.resize(std::size_t{3} * w * h);
    const bool blueFirst = swapchain.format == VK_FORMAT_B8G8R8A8_SRGB || swapchain.format == VK_FORMAT_B8G8R8A8_UNORM;
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            std::uint32_t column = x, row = y;
            if (swapchain.quarterTurns == 1) column = w - 1 - y, row = x;
            if (swapchain.quarterTurns == 2) column = w - 1 - x, row = h - 1 - y;
            if (swapchain.quarterTurns == 3) column = y, row = h - 1 - x;
            const std::uint8_t* from = &texels[std::size_t{4} * (std::size_t{row} * w + column)];
            std::uint8_t* to = &picture.rgb[std::size_t{3} * (std::size_t{y} * picture.width + x)];
            for (std::size_t c = 0; c < 3; ++c) to[c] = from[blueFirst ? 2 - c : c];
        }
    return picture;
}

}  // namespace nacre::test
