#include "engine/gpu/performance_counters.h"

#include "engine/error.h"

namespace nacre::gpu {

bool hasPerformanceCounters(const vk::raii::PhysicalDevice& device) {
    if (!hasExtension(device, VK_KHR_PERFORMANCE_QUERY_EXTENSION_NAME)) return false;
    VkPhysicalDevicePerformanceQueryFeaturesKHR counters{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PERFORMANCE_QUERY_FEATURES_KHR, nullptr, false, false};
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &counters, {}};
    device.getDispatcher()->vkGetPhysicalDeviceFeatures2(*device, &features);
    return counters.performanceCounterQueryPools;
}

ByteCounters::ByteCounters(const Device& device) : device_(device) {
    const vk::raii::PhysicalDevice& physical = device.physical();
    const auto enumerate = physical.getDispatcher()->vkEnumeratePhysicalDeviceQueueFamilyPerformanceQueryCountersKHR;
    std::uint32_t count = 0;
    enumerate(*physical, device.queueFamily(), &count, nullptr, nullptr);
    std::vector<VkPerformanceCounterKHR> counters(count,
                                                  {VK_STRUCTURE_TYPE_PERFORMANCE_COUNTER_KHR, {}, {}, {}, {}, {}});
    std::vector<VkPerformanceCounterDescriptionKHR> texts(
        count, {VK_STRUCTURE_TYPE_PERFORMANCE_COUNTER_DESCRIPTION_KHR, {}, {}, {}, {}, {}});
    enumerate(*physical, device.queueFamily(), &count, counters.data(), texts.data());
    for (std::uint32_t i = 0; i < count; ++i)
        if (counters[i].unit == VK_PERFORMANCE_COUNTER_UNIT_BYTES_KHR)
            counters_.push_back({i, counters[i].storage, texts[i].name, texts[i].category, texts[i].description});
    constexpr std::uint64_t kSecond = 1'000'000'000;
    const VkAcquireProfilingLockInfoKHR lock{VK_STRUCTURE_TYPE_ACQUIRE_PROFILING_LOCK_INFO_KHR, nullptr, 0, kSecond};
    if (device->getDispatcher()->vkAcquireProfilingLockKHR(**device, &lock) != VK_SUCCESS)
        throw Error("cannot count bytes", device.caps().deviceName, "its counters are in use");
}

ByteCounters::~ByteCounters() { device_->getDispatcher()->vkReleaseProfilingLockKHR(**device_); }

vk::raii::QueryPool ByteCounters::makePool(const ByteCounter& counter) const {
    const VkQueryPoolPerformanceCreateInfoKHR chosen{VK_STRUCTURE_TYPE_QUERY_POOL_PERFORMANCE_CREATE_INFO_KHR, nullptr,
                                                     device_.queueFamily(), 1, &counter.index};
    const vk::raii::PhysicalDevice& physical = device_.physical();
    std::uint32_t runs = 0;
    physical.getDispatcher()->vkGetPhysicalDeviceQueueFamilyPerformanceQueryPassesKHR(*physical, &chosen, &runs);
    if (runs != 1) return nullptr;
    vk::QueryPoolCreateInfo info({}, vk::QueryType::ePerformanceQueryKHR, 1);
    info.pNext = &chosen;
    return {*device_, info};
}

std::optional<std::uint64_t> ByteCounters::readResult(const vk::raii::QueryPool& pool,
                                                      const ByteCounter& counter) const {
    VkPerformanceCounterResultKHR result{};
    if (device_->getDispatcher()->vkGetQueryPoolResults(**device_, *pool, 0, 1, sizeof(result), &result, sizeof(result),
                                                        0) != VK_SUCCESS)
        return {};
    switch (counter.storage) {
        case VK_PERFORMANCE_COUNTER_STORAGE_INT32_KHR:
            return static_cast<std::uint64_t>(result.int32);
        case VK_PERFORMANCE_COUNTER_STORAGE_INT64_KHR:
            return static_cast<std::uint64_t>(result.int64);
        case VK_PERFORMANCE_COUNTER_STORAGE_UINT32_KHR:
            return result.uint32;
        case VK_PERFORMANCE_COUNTER_STORAGE_UINT64_KHR:
            return result.uint64;
        case VK_PERFORMANCE_COUNTER_STORAGE_FLOAT32_KHR:
            return static_cast<std::uint64_t>(result.float32);
        case VK_PERFORMANCE_COUNTER_STORAGE_FLOAT64_KHR:
            return static_cast<std::uint64_t>(result.float64);
        default:
            return {};
    }
}

}  // namespace nacre::gpu
