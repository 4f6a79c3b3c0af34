#include "engine/gpu/region_counters.h"

#include <algorithm>
#include <cstring>

#include "engine/error.h"

namespace nacre::gpu {
namespace {

std::uint32_t roundUp(std::uint32_t value, std::uint32_t alignment) {
    const std::uint32_t a = std::max(alignment, 1u);
    return (value + a - 1) / a * a;
}

}  // namespace

bool hasRegionCounters(const vk::raii::PhysicalDevice& device, bool validate) {
    if (!hasExtension(device, VK_ARM_PERFORMANCE_COUNTERS_BY_REGION_EXTENSION_NAME) ||
        !hasExtension(device, VK_KHR_BUFFER_DEVICE_ADDRESS_EXTENSION_NAME))
        return false;
    if (validate && !validationKnows(VK_MAKE_API_VERSION(0, 1, 4, 331))) return false;
    VkPhysicalDevicePerformanceCountersByRegionFeaturesARM regions{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PERFORMANCE_COUNTERS_BY_REGION_FEATURES_ARM, nullptr, false};
    VkPhysicalDeviceBufferDeviceAddressFeatures addresses{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BUFFER_DEVICE_ADDRESS_FEATURES, &regions, false, false, false};
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &addresses, {}};
    device.getDispatcher()->vkGetPhysicalDeviceFeatures2(*device, &features);
    return regions.performanceCountersByRegion && addresses.bufferDeviceAddress;
}

RegionLayout layOut(const VkPhysicalDevicePerformanceCountersByRegionPropertiesARM& properties, graph::Extent area,
                    std::uint32_t counters) {
    const VkExtent2D region = properties.performanceCounterRegionSize;
    RegionLayout layout;
    layout.columns = (area.width + region.width - 1) / region.width;
    layout.rows = (area.height + region.height - 1) / region.height;
    layout.regionBytes =
        roundUp(counters * static_cast<std::uint32_t>(sizeof(std::uint32_t)), properties.regionAlignment);
    layout.rowBytes = roundUp(layout.columns * layout.regionBytes, properties.rowStrideAlignment);
    return layout;
}

RegionCounters::RegionCounters(const Device& device) : device_(device) {
    const vk::raii::PhysicalDevice& physical = device.physical();
    properties_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PERFORMANCE_COUNTERS_BY_REGION_PROPERTIES_ARM;
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &properties_, {}};
    physical.getDispatcher()->vkGetPhysicalDeviceProperties2(*physical, &properties);
    const VkExtent2D region = properties_.performanceCounterRegionSize;
    if (region.width == 0 || region.height == 0 || properties_.maxPerRegionPerformanceCounters == 0)
        throw Error("cannot count", device.caps().deviceName, "its regions have no size");
    atOnce_ = properties_.maxPerRegionPerformanceCounters;
    const auto enumerate = reinterpret_cast<PFN_vkEnumeratePhysicalDeviceQueueFamilyPerformanceCountersByRegionARM>(
        device.instance().getProcAddr("vkEnumeratePhysicalDeviceQueueFamilyPerformanceCountersByRegionARM"));
    if (!enumerate) throw Error("cannot count", device.caps().deviceName, "the driver does not name its counters");
    std::uint32_t count = 0;
    enumerate(*physical, device.queueFamily(), &count, nullptr, nullptr);
    std::vector<VkPerformanceCounterARM> counters(count, {VK_STRUCTURE_TYPE_PERFORMANCE_COUNTER_ARM, nullptr, 0});
    std::vector<VkPerformanceCounterDescriptionARM> texts(
        count, {VK_STRUCTURE_TYPE_PERFORMANCE_COUNTER_DESCRIPTION_ARM, nullptr, 0, {}});
    enumerate(*physical, device.queueFamily(), &count, counters.data(), texts.data());
    for (std::uint32_t i = 0; i < count; ++i) {
        ids_.push_back(counters[i].counterID);
        names_.emplace_back(texts[i].name);
    }
}

RegionCounters::Area RegionCounters::makeArea(RegionLayout layout, std::size_t parts) const {
    Area area;
    area.layout = layout;
    area.parts = parts;
    area.partBytes =
        roundUp(static_cast<std::uint32_t>(layout.bytes()), std::max(properties_.rowStrideAlignment, 256u));
    const vk::DeviceSize bytes = area.partBytes * parts;
    area.buffer =
        vk::raii::Buffer(*device_, vk::BufferCreateInfo({}, bytes, vk::BufferUsageFlagBits::eShaderDeviceAddress));
    device_.name(*area.buffer, "counters of regions");
    const vk::MemoryRequirements needs = area.buffer.getMemoryRequirements();
    constexpr auto kHost = vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
    const vk::PhysicalDeviceMemoryProperties types = device_.physical().getMemoryProperties();
    std::uint32_t type = 0;
    while (type < types.memoryTypeCount &&
           !((needs.memoryTypeBits >> type & 1) && (types.memoryTypes[type].propertyFlags & kHost) == kHost))
        ++type;
    if (type == types.memoryTypeCount)
        throw Error("cannot count", device_.caps().deviceName, "no memory that the host can see");
    const vk::MemoryAllocateFlagsInfo addressed(vk::MemoryAllocateFlagBits::eDeviceAddress);
    vk::MemoryAllocateInfo info(needs.size, type);
    info.pNext = &addressed;
    area.memory = vk::raii::DeviceMemory(*device_, info);
    area.buffer.bindMemory(*area.memory, 0);
    area.mapped = static_cast<std::byte*>(area.memory.mapMemory(0, VK_WHOLE_SIZE));
    std::memset(area.mapped, 0, bytes);  // subpasses that are merged write no part of their own
    return area;
}

const void* RegionCounters::begin(const graph::RenderPassPlan& pass, std::size_t subpasses) {
    const auto counters = static_cast<std::uint32_t>(counted_.size());
    const std::size_t parts = subpasses * std::max(pass.layers, 1u);
    areas_.push_back(makeArea(layOut(properties_, pass.extent, counters), parts));
    const Area& area = areas_.back();
    const VkBufferDeviceAddressInfo info{VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO, nullptr, *area.buffer};
    const VkDeviceAddress first = device_->getDispatcher()->vkGetBufferDeviceAddressKHR(**device_, &info);
    addresses_.clear();
    for (std::size_t i = 0; i < parts; ++i) addresses_.push_back(first + i * area.partBytes);
    link_ = {VK_STRUCTURE_TYPE_RENDER_PASS_PERFORMANCE_COUNTERS_BY_REGION_BEGIN_INFO_ARM,
             nullptr,
             static_cast<std::uint32_t>(parts),
             addresses_.data(),
             true,  // in turn: the same counts each time
             counters,
             counted_.data()};
    return &link_;
}

void RegionCounters::makeReadable(CommandBuffer& commands) {
    const vk::MemoryBarrier written(vk::AccessFlagBits::eMemoryWrite, vk::AccessFlagBits::eHostRead);
    commands->pipelineBarrier(vk::PipelineStageFlagBits::eColorAttachmentOutput, vk::PipelineStageFlagBits::eHost, {},
                              written, {}, {});
}

void RegionCounters::takeSums(std::vector<std::uint64_t>& sums) {
    const std::size_t first = sums.size();
    sums.resize(first + counted_.size());
    for (const Area& area : areas_)
        for (std::size_t part = 0; part < area.parts; ++part)
            for (std::uint32_t row = 0; row < area.layout.rows; ++row)
                for (std::uint32_t column = 0; column < area.layout.columns; ++column) {
                    const std::byte* at = area.mapped + part * area.partBytes +
                                          std::size_t{row} * area.layout.rowBytes +
                                          std::size_t{column} * area.layout.regionBytes;
                    for (std::size_t c = 0; c < counted_.size(); ++c) {
                        std::uint32_t value = 0;
                        std::memcpy(&value, at + c * sizeof(value), sizeof(value));
                        sums[first + c] += value;
                    }
                }
    areas_.clear();
}

}  // namespace nacre::gpu
