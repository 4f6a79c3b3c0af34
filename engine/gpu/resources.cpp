#include "engine/gpu/resources.h"

#include <algorithm>

#include "engine/error.h"

namespace nacre::gpu {

using Property = vk::MemoryPropertyFlagBits;

void checkBuffer(const Caps& caps, vk::DeviceSize size, const std::string& name) {
    if (size <= caps.maxBufferBytes) return;
    throw Error("too much for this device", caps.deviceName,
                name + " would take " + std::to_string((size >> 20) + 1) + " MB, and a buffer has " +
                    std::to_string(caps.maxBufferBytes >> 20) + " MB at most (draw fewer atoms, or a smaller picture)");
}

Buffer makeBuffer(const Device& device, vk::DeviceSize size, vk::BufferUsageFlags usage, Access access,
                  const std::string& name) {
    Buffer buffer;
    buffer.size = std::max<vk::DeviceSize>(size, 16);
    checkBuffer(device.caps(), buffer.size, name);
    buffer.handle = vk::raii::Buffer(*device, vk::BufferCreateInfo({}, buffer.size, usage));
    const auto requirements = buffer.handle.getMemoryRequirements();
    const auto coherent = Property::eHostVisible | Property::eHostCoherent;
    const auto cached = Property::eHostVisible | Property::eHostCached;
    // Every device has coherent memory that the host sees.
    HeldMemory held = access == Access::upload
                          ? device.allocate(requirements, {coherent | Property::eDeviceLocal, coherent}, name)
                          : device.allocate(requirements, {coherent | Property::eHostCached, cached, coherent}, name);
    buffer.coherent = static_cast<bool>(held.properties & Property::eHostCoherent);
    buffer.memory = Memory(device, std::move(held));
    buffer.handle.bindMemory(**buffer.memory, 0);
    buffer.mapped = buffer.memory.map();
    device.name(*buffer.handle, name);
    return buffer;
}

// The whole range: no rounding to nonCoherentAtomSize is needed.
void Buffer::invalidate() const {
    if (!coherent) (**memory.device()).invalidateMappedMemoryRanges(vk::MappedMemoryRange(**memory, 0, VK_WHOLE_SIZE));
}

void Buffer::flush() const {
    if (!coherent) (**memory.device()).flushMappedMemoryRanges(vk::MappedMemoryRange(**memory, 0, VK_WHOLE_SIZE));
}

Image makeImage(const Device& device, const graph::ImageDesc& desc, vk::ImageUsageFlags usage, bool transient,
                const std::string& name) {
    Image image;
    image.desc = desc;
    const auto format = static_cast<vk::Format>(desc.format);
    const bool solid = desc.depth > 1;
    image.handle =
        vk::raii::Image(*device, vk::ImageCreateInfo({}, solid ? vk::ImageType::e3D : vk::ImageType::e2D, format,
                                                     {desc.extent.width, desc.extent.height, desc.depth}, 1,
                                                     desc.layers, static_cast<vk::SampleCountFlagBits>(desc.samples),
                                                     vk::ImageTiling::eOptimal, usage));
    const auto requirements = image.handle.getMemoryRequirements();
    const vk::MemoryPropertyFlags lazy = transient ? Property::eLazilyAllocated : vk::MemoryPropertyFlagBits{};
    HeldMemory held = device.allocate(requirements, {Property::eDeviceLocal | lazy, Property::eDeviceLocal, {}}, name);
    image.lazy = static_cast<bool>(held.properties & Property::eLazilyAllocated);
    image.memory = Memory(device, std::move(held));
    image.handle.bindMemory(**image.memory, 0);
    const auto aspect =
        graph::isDepthFormat(desc.format) ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
    constexpr vk::ImageUsageFlags kViewed =
        vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eColorAttachment |
        vk::ImageUsageFlagBits::eDepthStencilAttachment | vk::ImageUsageFlagBits::eInputAttachment |
        vk::ImageUsageFlagBits::eFragmentDensityMapEXT;
    if (usage & kViewed)
        image.view =
            vk::raii::ImageView(*device, vk::ImageViewCreateInfo({}, *image.handle,
                                                                 solid             ? vk::ImageViewType::e3D
                                                                 : desc.layers > 1 ? vk::ImageViewType::e2DArray
                                                                                   : vk::ImageViewType::e2D,
                                                                 format, {}, {aspect, 0, 1, 0, desc.layers}));
    device.name(*image.handle, name);
    if (*image.view) device.name(*image.view, "view of " + name);
    return image;
}

vk::raii::BufferView makeTexelView(const Device& device, const Buffer& buffer, vk::Format format,
                                   const std::string& name) {
    vk::raii::BufferView view(*device, vk::BufferViewCreateInfo({}, *buffer.handle, format, 0, VK_WHOLE_SIZE));
    device.name(*view, name + ", texels");
    return view;
}

vk::raii::Sampler makeSampler(const Device& device, vk::Filter filter, const std::string& name) {
    constexpr auto kEdge = vk::SamplerAddressMode::eClampToEdge;
    vk::SamplerCreateInfo info({}, filter, filter, vk::SamplerMipmapMode::eNearest, kEdge, kEdge, kEdge);
    info.maxLod = VK_LOD_CLAMP_NONE;  // there is one mip level, and a clamp costs more on Mali
    vk::raii::Sampler sampler(*device, info);
    device.name(*sampler, name);
    return sampler;
}

}  // namespace nacre::gpu
