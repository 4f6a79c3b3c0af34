#include "engine/gpu/pipeline_cache.h"

#include <cstring>

namespace nacre::gpu {

bool isOwnPipelineCache(const vk::PhysicalDeviceProperties& properties, std::span<const std::byte> data) {
    VkPipelineCacheHeaderVersionOne header{};
    if (data.size() < sizeof(header)) return false;
    std::memcpy(&header, data.data(), sizeof(header));
    return header.headerSize == sizeof(header) && header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
           header.vendorID == properties.vendorID && header.deviceID == properties.deviceID &&
           std::memcmp(header.pipelineCacheUUID, properties.pipelineCacheUUID.data(), VK_UUID_SIZE) == 0;
}

vk::raii::PipelineCache makePipelineCache(const vk::raii::Device& device, const vk::raii::PhysicalDevice& physical,
                                          std::span<const std::byte> data) {
    if (!isOwnPipelineCache(physical.getProperties(), data)) data = {};
    try {
        return {device, vk::PipelineCacheCreateInfo({}, data.size(), data.data())};
    } catch (const vk::SystemError&) {
        if (data.empty()) throw;
        return {device, vk::PipelineCacheCreateInfo()};  // the header may be valid and the rest damaged
    }
}

}  // namespace nacre::gpu
