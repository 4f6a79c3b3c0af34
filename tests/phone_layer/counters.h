#pragma once
// Where NACRE_PHONE_COUNTERS is set, the phone has performance counters (VK_KHR_performance_query). Those of external
// memory count what a Mali does for the commands of a query: attachments of its render passes that are loaded and
// stored, as the commands say, and vertex outputs, written once and read once. Two more count something else.

#include <vulkan/vulkan.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "tests/phone_layer/below.h"

namespace nacre::phone {

inline bool countsBytes() { return std::getenv("NACRE_PHONE_COUNTERS") != nullptr; }

enum class Counts : std::uint8_t { cycles, reads, cacheReads, writes };
struct OwnCounter {
    Counts counts;
    VkPerformanceCounterUnitKHR unit;
    VkPerformanceCounterStorageKHR storage;
    const char *name, *category, *description;
};
constexpr std::array<OwnCounter, 4> kCounters{{
    {Counts::cycles, VK_PERFORMANCE_COUNTER_UNIT_CYCLES_KHR, VK_PERFORMANCE_COUNTER_STORAGE_UINT64_KHR, "GPU active",
     "GPU", "Cycles"},
    {Counts::reads, VK_PERFORMANCE_COUNTER_UNIT_BYTES_KHR, VK_PERFORMANCE_COUNTER_STORAGE_UINT64_KHR,
     "External read bytes", "External bus", "Bytes that the GPU reads from memory"},
    {Counts::cacheReads, VK_PERFORMANCE_COUNTER_UNIT_BYTES_KHR, VK_PERFORMANCE_COUNTER_STORAGE_FLOAT32_KHR,
     "L2 read bytes", "L2 cache", "Bytes that the cache gives without asking the memory"},
    {Counts::writes, VK_PERFORMANCE_COUNTER_UNIT_BYTES_KHR, VK_PERFORMANCE_COUNTER_STORAGE_FLOAT64_KHR,
     "External write bytes", "External bus", "Bytes that the GPU writes to memory"},
}};

struct CountedQuery {
    std::uint32_t counter = 0;
    std::uint64_t read = 0, written = 0;
};
inline std::mutex countersMutex;  // of what follows
inline std::map<VkQueryPool, CountedQuery> countedQueries;
inline std::map<VkCommandBuffer, VkQueryPool> countingInto;
inline bool profilingLocked = false;

/// Something of a command buffer goes through memory.
inline void throughMemory(VkCommandBuffer commands, std::uint64_t read, std::uint64_t written) {
    const std::lock_guard lock(countersMutex);
    const auto into = countingInto.find(commands);
    if (into == countingInto.end()) return;
    countedQueries[into->second].read += read;
    countedQueries[into->second].written += written;
}

inline std::uint64_t texelBytes(VkFormat format) {
    switch (format) {
        case VK_FORMAT_R8G8B8A8_SRGB:
        case VK_FORMAT_R8G8B8A8_UNORM:
        case VK_FORMAT_R32_SFLOAT:
        case VK_FORMAT_R32_UINT:
        case VK_FORMAT_D32_SFLOAT:
            return 4;
        case VK_FORMAT_R16G16B16A16_SFLOAT:
            return 8;
        default:
            std::fprintf(stderr, "phone: attachments of format %d are not counted\n", format);
            std::abort();
    }
}

/// A render pass begins.
inline void countAttachments(VkCommandBuffer commands, const std::vector<VkAttachmentDescription2>& attachments,
                             VkExtent2D area) {
    if (!countsBytes()) return;
    for (const VkAttachmentDescription2& a : attachments) {
        const std::uint64_t bytes = texelBytes(a.format) * area.width * area.height * a.samples;
        throughMemory(commands, a.loadOp == VK_ATTACHMENT_LOAD_OP_LOAD ? bytes : 0,
                      a.storeOp == VK_ATTACHMENT_STORE_OP_STORE ? bytes : 0);
    }
}

inline VKAPI_ATTR VkResult VKAPI_CALL EnumeratePhysicalDeviceQueueFamilyPerformanceQueryCountersKHR(
    VkPhysicalDevice, std::uint32_t, std::uint32_t* count, VkPerformanceCounterKHR* counters,
    VkPerformanceCounterDescriptionKHR* texts) {
    if (counters)
        for (std::uint32_t i = 0; i < kCounters.size(); ++i) {
            counters[i].unit = kCounters[i].unit;
            counters[i].scope = VK_PERFORMANCE_COUNTER_SCOPE_COMMAND_BUFFER_KHR;
            counters[i].storage = kCounters[i].storage;
            std::strcpy(texts[i].name, kCounters[i].name);
            std::strcpy(texts[i].category, kCounters[i].category);
            std::strcpy(texts[i].description, kCounters[i].description);
        }
    *count = kCounters.size();
    return VK_SUCCESS;
}

inline VKAPI_ATTR void VKAPI_CALL GetPhysicalDeviceQueueFamilyPerformanceQueryPassesKHR(
    VkPhysicalDevice, const VkQueryPoolPerformanceCreateInfoKHR* info, std::uint32_t* runs) {
    *runs = info->counterIndexCount;
}

inline VKAPI_ATTR VkResult VKAPI_CALL AcquireProfilingLockKHR(VkDevice, const VkAcquireProfilingLockInfoKHR*) {
    if (std::exchange(profilingLocked, true)) return VK_TIMEOUT;
    return VK_SUCCESS;
}

inline VKAPI_ATTR void VKAPI_CALL ReleaseProfilingLockKHR(VkDevice) { profilingLocked = false; }

/// The driver's pool for such queries is of another type, and never begun.
inline VKAPI_ATTR VkResult VKAPI_CALL CreateQueryPool(VkDevice of, const VkQueryPoolCreateInfo* info,
                                                      const VkAllocationCallbacks* allocator, VkQueryPool* pool) {
    if (info->queryType != VK_QUERY_TYPE_PERFORMANCE_QUERY_KHR) return nextCreateQueryPool(of, info, allocator, pool);
    const auto& chosen = *static_cast<const VkQueryPoolPerformanceCreateInfoKHR*>(info->pNext);
    const VkQueryPoolCreateInfo other{
        VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO, nullptr, 0, VK_QUERY_TYPE_OCCLUSION, info->queryCount, 0};
    const VkResult result = nextCreateQueryPool(of, &other, allocator, pool);
    const std::lock_guard lock(countersMutex);
    countedQueries[*pool] = {chosen.pCounterIndices[0]};
    return result;
}

inline VKAPI_ATTR void VKAPI_CALL CmdBeginQuery(VkCommandBuffer commands, VkQueryPool pool, std::uint32_t query,
                                                VkQueryControlFlags flags) {
    {
        const std::lock_guard lock(countersMutex);
        if (countedQueries.contains(pool)) {
            if (!profilingLocked) std::abort();
            countingInto[commands] = pool;
            return;
        }
    }
    nextCmdBeginQuery(commands, pool, query, flags);
}

inline VKAPI_ATTR void VKAPI_CALL CmdEndQuery(VkCommandBuffer commands, VkQueryPool pool, std::uint32_t query) {
    {
        const std::lock_guard lock(countersMutex);
        if (countedQueries.contains(pool)) {
            countingInto.erase(commands);
            return;
        }
    }
    nextCmdEndQuery(commands, pool, query);
}

/// @returns whether it is a pool of counters, whose result is told
inline bool tellCount(VkQueryPool pool, void* data) {
    const std::lock_guard lock(countersMutex);
    const auto found = countedQueries.find(pool);
    if (found == countedQueries.end()) return false;
    VkPerformanceCounterResultKHR result{};
    switch (kCounters[found->second.counter].counts) {
        case Counts::cycles:
            result.uint64 = 1;
            break;
        case Counts::reads:
            result.uint64 = found->second.read;
            break;
        case Counts::cacheReads:
            result.float32 = 4096;
            break;
        case Counts::writes:
            result.float64 = static_cast<double>(found->second.written);
            break;
    }
    std::memcpy(data, &result, sizeof(result));
    return true;
}

}  // namespace nacre::phone
