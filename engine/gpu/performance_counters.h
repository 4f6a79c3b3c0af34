#pragma once
// Counters of the device (VK_KHR_performance_query) that count bytes.

#include <optional>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "engine/gpu/device.h"

namespace nacre::gpu {

/// Whether the device has counters. Devices without a window enable them.
bool hasPerformanceCounters(const vk::raii::PhysicalDevice& device);

struct ByteCounter {
    std::uint32_t index = 0;
    VkPerformanceCounterStorageKHR storage{};
    std::string name, category, description;
};

/// Counts the bytes of submissions, with exclusive use of the counters.
class ByteCounters {
public:
    /// @throws Error if another program holds the counters
    explicit ByteCounters(const Device& device);
    ~ByteCounters();
    ByteCounters(const ByteCounters&) = delete;

    const std::vector<ByteCounter>& counters() const { return counters_; }

    /// Bytes of the recorded commands; none for a counter that takes several runs.
    template <typename Record>
    std::optional<std::uint64_t> count(const ByteCounter& counter, const Record& record) const {
        const vk::raii::QueryPool pool = makePool(counter);
        if (!*pool) return {};
        // A query needs its reset in other commands than those it counts. Its begin is the first of those, and its end
        // the last.
        device_.submitAndWait([&](CommandBuffer& c) { c->resetQueryPool(*pool, 0, 1); });
        device_.submitAndWait([&](CommandBuffer& c) {
            c->beginQuery(*pool, 0, {});
            record(c);
            c->endQuery(*pool, 0);
        });
        return readResult(pool, counter);
    }

private:
    /// Null for a counter that takes several runs.
    vk::raii::QueryPool makePool(const ByteCounter& counter) const;
    std::optional<std::uint64_t> readResult(const vk::raii::QueryPool& pool, const ByteCounter& counter) const;

    const Device& device_;
    std::vector<ByteCounter> counters_;
};

}  // namespace nacre::gpu
