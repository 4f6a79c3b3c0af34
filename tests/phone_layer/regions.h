#pragma once
// Where NACRE_PHONE_REGIONS is set, the phone has counters of a render pass's regions
// (VK_ARM_performance_counters_by_region), two at once, whose values the test knows: counter c of region r has the
// value 1000 c + r. Subpasses are merged: the first one's part has the values, the others stay as they are. What lies
// between regions and rows is overwritten: nobody may take it for a value.

#include <vulkan/vulkan.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <vector>

#include "engine/gpu/performance_counters_by_region.h"
#include "tests/phone_layer/below.h"
#include "tests/phone_layer/feedback.h"

namespace nacre::phone {

inline bool countsRegions() { return std::getenv("NACRE_PHONE_REGIONS") != nullptr; }

constexpr std::array<const char*, 5> kRegionCounters{
    "Fragment active cycles", "Texture read beats from external memory", "Load/store read beats from external memory",
    "Load/store write beats to external memory", "L2 read bytes"};
constexpr std::uint32_t kFirstCounterId = 70;
constexpr VkExtent2D kRegion{48, 40};
constexpr std::uint32_t kCountersAtOnce = 2, kRegionAlignment = 64, kRowAlignment = 512;

inline std::mutex regionsMutex;  // guards the two maps below
inline std::map<VkDeviceAddress, std::pair<VkBuffer, VkDeviceSize>> addressedBuffers;
inline std::map<VkBuffer, VkDeviceSize> bufferSizes;

inline VKAPI_ATTR VkResult VKAPI_CALL EnumeratePhysicalDeviceQueueFamilyPerformanceCountersByRegionARM(
    VkPhysicalDevice, std::uint32_t, std::uint32_t* count, VkPerformanceCounterARM* counters,
    VkPerformanceCounterDescriptionARM* texts) {
    if (counters)
        for (std::uint32_t i = 0; i < kRegionCounters.size(); ++i) {
            counters[i].counterID = kFirstCounterId + i;
            std::strcpy(texts[i].name, kRegionCounters[i]);
        }
    *count = kRegionCounters.size();
    return VK_SUCCESS;
}

inline void fill(VkPhysicalDevicePerformanceCountersByRegionPropertiesARM& p) {
    p.maxPerRegionPerformanceCounters = kCountersAtOnce;
    p.performanceCounterRegionSize = kRegion;
    p.rowStrideAlignment = kRowAlignment;
    p.regionAlignment = kRegionAlignment;
    p.identityTransformOrder = true;
}

inline VKAPI_ATTR VkResult VKAPI_CALL CreateBuffer(VkDevice of, const VkBufferCreateInfo* info,
                                                   const VkAllocationCallbacks* allocator, VkBuffer* buffer) {
    const VkResult result = nextCreateBuffer(of, info, allocator, buffer);
    const std::lock_guard lock(regionsMutex);
    if (result == VK_SUCCESS && countsRegions()) bufferSizes[*buffer] = info->size;
    return result;
}

inline VKAPI_ATTR VkDeviceAddress VKAPI_CALL GetBufferDeviceAddressKHR(VkDevice of,
                                                                       const VkBufferDeviceAddressInfo* info) {
    const VkDeviceAddress address = nextGetBufferDeviceAddressKHR(of, info);
    const std::lock_guard lock(regionsMutex);
    addressedBuffers[address] = {info->buffer, bufferSizes[info->buffer]};
    return address;
}

[[noreturn]] inline void wrongRegions(const char* what) {
    std::fprintf(stderr, "phone: counters of regions: %s\n", what);
    std::abort();
}

/// Writes the counters of a render pass before it begins: nothing reads them until it has ended.
inline void writeRegions(VkCommandBuffer commands, const void* chain, VkExtent2D area, std::size_t subpasses,
                         std::uint32_t views) {
    const auto* wanted = chained<VkRenderPassPerformanceCountersByRegionBeginInfoARM>(
        chain, VK_STRUCTURE_TYPE_RENDER_PASS_PERFORMANCE_COUNTERS_BY_REGION_BEGIN_INFO_ARM);
    if (!wanted) return;
    if (!countsRegions()) wrongRegions("not offered");
    if (wanted->counterAddressCount != subpasses * views) wrongRegions("an address for each subpass and view");
    if (wanted->counterIndexCount > kCountersAtOnce) wrongRegions("too many at once");
    const std::uint32_t columns = (area.width + kRegion.width - 1) / kRegion.width;
    const std::uint32_t rows = (area.height + kRegion.height - 1) / kRegion.height;
    const std::uint32_t step =
        (wanted->counterIndexCount * 4 + kRegionAlignment - 1) / kRegionAlignment * kRegionAlignment;
    const std::uint32_t row = (columns * step + kRowAlignment - 1) / kRowAlignment * kRowAlignment;
    std::vector<std::uint32_t> values(std::size_t{row} * rows / 4, 0xffffffffu);
    for (std::uint32_t r = 0; r < columns * rows; ++r)
        for (std::uint32_t c = 0; c < wanted->counterIndexCount; ++c) {
            const std::uint32_t counter = wanted->pCounterIndices[c] - kFirstCounterId;
            if (counter >= kRegionCounters.size()) wrongRegions("a counter that is not there");
            values[(r / columns * row + r % columns * step) / 4 + c] = 1000 * counter + r;
        }
    for (std::uint32_t view = 0; view < views; ++view) {  // of the first subpass, into which the others are merged
        const std::lock_guard lock(regionsMutex);
        const VkDeviceAddress address = wanted->pCounterAddresses[view];
        auto found = addressedBuffers.upper_bound(address);
        if (found == addressedBuffers.begin()) wrongRegions("an address of nothing");
        const auto& [first, buffer] = *--found;
        if (address + values.size() * 4 > first + buffer.second) wrongRegions("too little memory");
        constexpr std::size_t kMost = 16384;  // words of an update
        for (std::size_t at = 0; at < values.size(); at += kMost)
            nextCmdUpdateBuffer(commands, buffer.first, address - first + at * 4,
                                std::min(kMost, values.size() - at) * 4, values.data() + at);
    }
}

}  // namespace nacre::phone
