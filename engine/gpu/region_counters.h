#pragma once
// Counters of a render pass's regions (VK_ARM_performance_counters_by_region), summed over a frame. The driver names
// them, and tells no units.

#include <list>
#include <span>
#include <string>
#include <vector>

#include "engine/gpu/device.h"
#include "engine/gpu/performance_counters_by_region.h"
#include "engine/graph/plan.h"

namespace nacre::gpu {

/// Whether the device has such counters. Devices without a window enable them. @param validate  whether validation is
/// on
bool hasRegionCounters(const vk::raii::PhysicalDevice& device, bool validate);

/// How a render pass writes its counters: of each region in turn, from left to right and top to bottom.
struct RegionLayout {
    std::uint32_t columns = 0, rows = 0;
    std::uint32_t regionBytes = 0, rowBytes = 0;
    std::uint64_t bytes() const { return std::uint64_t{rowBytes} * rows; }
};
RegionLayout layOut(const VkPhysicalDevicePerformanceCountersByRegionPropertiesARM& properties, graph::Extent area,
                    std::uint32_t counters);

class RegionCounters {
public:
    explicit RegionCounters(const Device& device);
    RegionCounters(const RegionCounters&) = delete;

    const std::vector<std::string>& names() const { return names_; }

    /// Every counter's sum over the regions, subpasses and render passes that `record` records through an executor
    /// that counts into this.
    template <typename Record>
    std::vector<std::uint64_t> count(const Record& record) {
        std::vector<std::uint64_t> sums;
        while (sums.size() < ids_.size()) {  // as many at once as the device can
            const std::size_t most = std::min(atOnce_, ids_.size() - sums.size());
            counted_ = std::span(ids_).subspan(sums.size(), most);
            device_.submitAndWait([&](CommandBuffer& c) {
                record(c);
                makeReadable(c);
            });
            takeSums(sums);
        }
        return sums;
    }

    /// A render pass begins. @returns the chain of the structure that begins it, valid until the next call
    const void* begin(const graph::RenderPassPlan& pass, std::size_t subpasses);

private:
    /// Memory of a render pass, with a part for each subpass and view.
    struct Area {
        vk::raii::DeviceMemory memory{nullptr};
        vk::raii::Buffer buffer{nullptr};  // before its memory
        RegionLayout layout;
        std::size_t parts = 0;
        std::uint64_t partBytes = 0;
        std::byte* mapped = nullptr;
    };
    Area makeArea(RegionLayout layout, std::size_t parts) const;
    static void makeReadable(CommandBuffer& commands);
    /// Adds the sums of the counted ones, and frees the areas.
    void takeSums(std::vector<std::uint64_t>& sums);

    const Device& device_;
    VkPhysicalDevicePerformanceCountersByRegionPropertiesARM properties_{};
    std::vector<std::string> names_;
    std::vector<std::uint32_t> ids_;
    std::size_t atOnce_ = 1;
    std::span<std::uint32_t> counted_;
    std::list<Area> areas_;
    std::vector<VkDeviceAddress> addresses_;
    VkRenderPassPerformanceCountersByRegionBeginInfoARM link_{};
};

}  // namespace nacre::gpu
