#pragma once
// The memory types of tile-based GPUs: one that the host sees coherently and does not cache, one that it caches and
// must invalidate, one that is lazily allocated. What the host may not see yet, it does not see here.

#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <set>
#include <vector>

#include "tests/phone_layer/below.h"
#include "tests/phone_layer/feedback.h"

namespace nacre::phone {

inline std::uint32_t cachedType = 0, lazyType = 0;  // indices of the memory types that are added

inline std::mutex memoryMutex;  // of what follows: several threads may have a device each

/// Memory that the host caches.
struct Cache {
    std::uint8_t* device = nullptr;
    std::vector<std::uint8_t> host;
    VkBuffer buffer = VK_NULL_HANDLE;
};
inline std::map<VkDeviceMemory, Cache> caches;
inline std::map<VkDeviceMemory, VkDeviceSize> lazies;  // bytes of what is lazily allocated
inline std::set<VkBuffer> toHost;  // a barrier was recorded that makes what is written to them available to the host
inline bool allToHost = false;     // or one of all memory

inline void addTypes(VkPhysicalDeviceMemoryProperties& p) {
    p.memoryTypes[0].propertyFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                     VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    cachedType = p.memoryTypeCount++;
    p.memoryTypes[cachedType] = {
        VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_CACHED_BIT,
        0};
    lazyType = p.memoryTypeCount++;
    p.memoryTypes[lazyType] = {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT, 0};
}

inline VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceMemoryProperties(VkPhysicalDevice of,
                                                                    VkPhysicalDeviceMemoryProperties* p) {
    nextGetPhysicalDeviceMemoryProperties(of, p);
    addTypes(*p);
}

inline VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceMemoryProperties2(VkPhysicalDevice of,
                                                                     VkPhysicalDeviceMemoryProperties2* p) {
    nextGetPhysicalDeviceMemoryProperties2(of, p);
    addTypes(p->memoryProperties);
}

inline VKAPI_ATTR void VKAPI_CALL GetImageMemoryRequirements(VkDevice of, VkImage image, VkMemoryRequirements* r) {
    nextGetImageMemoryRequirements(of, image, r);
    r->memoryTypeBits |= 1u << cachedType | 1u << lazyType;
}

inline VKAPI_ATTR void VKAPI_CALL GetBufferMemoryRequirements(VkDevice of, VkBuffer buffer, VkMemoryRequirements* r) {
    nextGetBufferMemoryRequirements(of, buffer, r);
    r->memoryTypeBits |= 1u << cachedType;
}

inline VKAPI_ATTR void VKAPI_CALL GetImageMemoryRequirements2(VkDevice of, const VkImageMemoryRequirementsInfo2* info,
                                                              VkMemoryRequirements2* r) {
    nextGetImageMemoryRequirements2(of, info, r);
    r->memoryRequirements.memoryTypeBits |= 1u << cachedType | 1u << lazyType;
}

inline VKAPI_ATTR VkResult VKAPI_CALL AllocateMemory(VkDevice of, const VkMemoryAllocateInfo* info,
                                                     const VkAllocationCallbacks* allocator, VkDeviceMemory* memory) {
    VkMemoryAllocateInfo real = *info;
    const bool cached = real.memoryTypeIndex == cachedType, lazy = real.memoryTypeIndex == lazyType;
    if (cached || lazy) real.memoryTypeIndex = 0;
    const VkResult result = nextAllocateMemory(of, &real, allocator, memory);
    const std::lock_guard lock(memoryMutex);
    if (result == VK_SUCCESS && cached)
        caches[*memory] = {nullptr, std::vector<std::uint8_t>(info->allocationSize), {}};
    if (result == VK_SUCCESS && lazy) lazies[*memory] = info->allocationSize;
    return result;
}

inline VKAPI_ATTR void VKAPI_CALL GetDeviceMemoryCommitment(VkDevice, VkDeviceMemory memory, VkDeviceSize* bytes) {
    const std::lock_guard lock(memoryMutex);
    if (!lazies.count(memory)) std::abort();  // only lazily allocated memory may be asked about
    *bytes = committed(lazies[memory]);
}

/// The host sees a copy of cached memory, which is brought up to date when it is flushed or invalidated.
inline VKAPI_ATTR VkResult VKAPI_CALL MapMemory(VkDevice of, VkDeviceMemory memory, VkDeviceSize offset,
                                                VkDeviceSize size, VkMemoryMapFlags flags, void** data) {
    const VkResult result = nextMapMemory(of, memory, offset, size, flags, data);
    const std::lock_guard lock(memoryMutex);
    const auto it = caches.find(memory);
    if (result != VK_SUCCESS || it == caches.end()) return result;
    if (offset != 0) std::abort();  // nobody does
    it->second.device = static_cast<std::uint8_t*>(*data);
    *data = it->second.host.data();
    return result;
}

inline VKAPI_ATTR void VKAPI_CALL FreeMemory(VkDevice of, VkDeviceMemory memory,
                                             const VkAllocationCallbacks* allocator) {
    const std::lock_guard lock(memoryMutex);
    caches.erase(memory);
    lazies.erase(memory);
    nextFreeMemory(of, memory, allocator);
}

inline VKAPI_ATTR VkResult VKAPI_CALL BindBufferMemory(VkDevice of, VkBuffer buffer, VkDeviceMemory memory,
                                                       VkDeviceSize offset) {
    const std::lock_guard lock(memoryMutex);
    if (const auto it = caches.find(memory); it != caches.end()) it->second.buffer = buffer;
    return nextBindBufferMemory(of, buffer, memory, offset);
}

inline VKAPI_ATTR VkResult VKAPI_CALL FlushMappedMemoryRanges(VkDevice of, std::uint32_t count,
                                                              const VkMappedMemoryRange* ranges) {
    const std::lock_guard lock(memoryMutex);
    for (std::uint32_t i = 0; i < count; ++i)
        if (const auto it = caches.find(ranges[i].memory); it != caches.end())
            std::copy(it->second.host.begin(), it->second.host.end(), it->second.device);
    return nextFlushMappedMemoryRanges(of, count, ranges);
}

/// Only what a barrier made available to the host is there to be seen.
inline VKAPI_ATTR VkResult VKAPI_CALL InvalidateMappedMemoryRanges(VkDevice of, std::uint32_t count,
                                                                   const VkMappedMemoryRange* ranges) {
    const std::lock_guard lock(memoryMutex);
    for (std::uint32_t i = 0; i < count; ++i)
        if (const auto it = caches.find(ranges[i].memory); it != caches.end()) {
            if (!toHost.count(it->second.buffer) && !allToHost) {
                std::fprintf(stderr, "phone: the host reads a buffer without a barrier to it\n");
                std::abort();
            }
            std::copy_n(it->second.device, it->second.host.size(), it->second.host.begin());
        }
    return nextInvalidateMappedMemoryRanges(of, count, ranges);
}

inline VKAPI_ATTR void VKAPI_CALL CmdPipelineBarrier(VkCommandBuffer commands, VkPipelineStageFlags from,
                                                     VkPipelineStageFlags to, VkDependencyFlags flags,
                                                     std::uint32_t memoryCount, const VkMemoryBarrier* memory,
                                                     std::uint32_t bufferCount, const VkBufferMemoryBarrier* buffers,
                                                     std::uint32_t imageCount, const VkImageMemoryBarrier* images) {
    if (to & VK_PIPELINE_STAGE_HOST_BIT) {
        const std::lock_guard lock(memoryMutex);
        for (std::uint32_t i = 0; i < memoryCount; ++i)
            allToHost = allToHost || (memory[i].dstAccessMask & VK_ACCESS_HOST_READ_BIT);
        for (std::uint32_t i = 0; i < bufferCount; ++i)
            if (buffers[i].dstAccessMask & VK_ACCESS_HOST_READ_BIT) toHost.insert(buffers[i].buffer);
    }
    nextCmdPipelineBarrier(commands, from, to, flags, memoryCount, memory, bufferCount, buffers, imageCount, images);
}

}  // namespace nacre::phone
