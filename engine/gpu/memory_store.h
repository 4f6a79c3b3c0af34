#pragma once
// Device memory, one allocation per resource. Freed memory is kept for the next resource of about the same size: a
// batch makes the same dozen buffers for each picture, and a GPU's driver takes up to a millisecond for each
// allocation.

#include <cstdint>
#include <initializer_list>
#include <mutex>
#include <optional>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

/// Memory of one resource.
struct HeldMemory {
    vk::raii::DeviceMemory memory{nullptr};
    std::uint32_t type = 0;
    vk::MemoryPropertyFlags properties;
    vk::DeviceSize size = 0;      ///< of the allocation
    std::uint64_t used = 0;       ///< bytes that the resource asked for
    std::byte* mapped = nullptr;  ///< the whole allocation; null until somebody maps it
};

/// Bytes of spare memory at most: little where host and device share their memory, as on phones.
constexpr vk::DeviceSize spareMemory(const vk::PhysicalDeviceMemoryProperties& memory) {
    for (std::uint32_t heap = 0; heap < memory.memoryHeapCount; ++heap)
        if (!(memory.memoryHeaps[heap].flags & vk::MemoryHeapFlagBits::eDeviceLocal)) return 32 << 20;
    return 8 << 20;
}

/// For any thread.
class MemoryStore {
public:
    /// @param device  outlives this
    MemoryStore(const vk::raii::Device& device, const vk::raii::PhysicalDevice& physical)
        : device_(device), types_(physical.getMemoryProperties()), mostSpare_(spareMemory(types_)) {}

    /// Memory of the first type that has all properties of the first choice, else of the next one; null if no type has
    /// room.
    std::optional<HeldMemory> take(const vk::MemoryRequirements& requirements,
                                   std::initializer_list<vk::MemoryPropertyFlags> choices);
    /// The device must no longer use it.
    void giveBack(HeldMemory&& held);

    /// Bytes of resources: now, and at most so far. Spare memory does not count.
    std::uint64_t bytes() const;
    std::uint64_t peakBytes() const;

    /// Bytes of memory kept for further resources: now, and at most. Only memory up to a quarter of that is kept.
    std::uint64_t spareBytes() const;
    std::uint64_t mostSpare() const { return mostSpare_; }

private:
    vk::DeviceSize sizeClass(vk::DeviceSize size) const;
    bool isKept(const HeldMemory& held) const;
    std::optional<HeldMemory> takeSpare(std::uint32_t type, vk::DeviceSize size);
    bool allocate(HeldMemory& held) const;
    void dropSpare(vk::DeviceSize most);

    const vk::raii::Device& device_;
    const vk::PhysicalDeviceMemoryProperties types_;
    const vk::DeviceSize mostSpare_;
    mutable std::mutex turn_;
    std::vector<HeldMemory> spare_;  // oldest first
    vk::DeviceSize spareBytes_ = 0;
    std::uint64_t bytes_ = 0, peakBytes_ = 0;
};

}  // namespace nacre::gpu
