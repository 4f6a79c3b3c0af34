#include "engine/gpu/memory_store.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace nacre::gpu {
namespace {

constexpr std::size_t kMostResources = 512;  // whose memory is kept

}  // namespace

/// Sizes of allocations: four for each power of two, so that resources of about the same size share them.
vk::DeviceSize MemoryStore::sizeClass(vk::DeviceSize size) const {
    constexpr vk::DeviceSize kLeast = 4096;
    if (size > mostSpare_ / 4) return size;
    const vk::DeviceSize step = std::max(std::bit_ceil(std::max(size, kLeast)) / 8, kLeast);
    return (size + step - 1) / step * step;
}

/// Lazily allocated memory is backed by what a frame needed last.
bool MemoryStore::isKept(const HeldMemory& held) const {
    return held.size <= mostSpare_ / 4 && !(held.properties & vk::MemoryPropertyFlagBits::eLazilyAllocated);
}

std::optional<HeldMemory> MemoryStore::takeSpare(std::uint32_t type, vk::DeviceSize size) {
    const auto found = std::find_if(spare_.rbegin(), spare_.rend(),
                                    [&](const HeldMemory& spare) { return spare.type == type && spare.size == size; });
    if (found == spare_.rend()) return std::nullopt;
    HeldMemory held = std::move(*found);
    spare_.erase(std::next(found).base());
    spareBytes_ -= held.size;
    return held;
}

bool MemoryStore::allocate(HeldMemory& held) const {
    try {
        held.memory = vk::raii::DeviceMemory(device_, vk::MemoryAllocateInfo(held.size, held.type));
        return true;
    } catch (const vk::SystemError&) {
        return false;
    }
}

void MemoryStore::dropSpare(vk::DeviceSize most) {
    auto end = spare_.begin();
    for (; end != spare_.end() && spareBytes_ > most; ++end) spareBytes_ -= end->size;
    spare_.erase(spare_.begin(), end);
}

std::optional<HeldMemory> MemoryStore::take(const vk::MemoryRequirements& requirements,
                                            std::initializer_list<vk::MemoryPropertyFlags> choices) {
    const std::lock_guard lock(turn_);
    spare_.reserve(kMostResources);
    for (const vk::MemoryPropertyFlags properties : choices)
        for (std::uint32_t type = 0; type < types_.memoryTypeCount; ++type) {
            const vk::MemoryPropertyFlags has = types_.memoryTypes[type].propertyFlags;
            if (!(requirements.memoryTypeBits & (1u << type)) || (has & properties) != properties) continue;
            const bool lazy = static_cast<bool>(has & vk::MemoryPropertyFlagBits::eLazilyAllocated);
            const vk::DeviceSize size = lazy ? requirements.size : sizeClass(requirements.size);
            std::optional<HeldMemory> held = takeSpare(type, size);
            if (!held) {
                held = HeldMemory{nullptr, type, has, size};
                if (!allocate(*held)) {  // this heap is full; without the spare memory, or of another type, may be room
                    if (spare_.empty()) continue;
                    dropSpare(0);
                    if (!allocate(*held)) continue;
                }
            }
            held->used = requirements.size;
            bytes_ += held->used;
            peakBytes_ = std::max(peakBytes_, bytes_);
            return held;
        }
    return std::nullopt;
}

void MemoryStore::giveBack(HeldMemory&& held) {
    const std::lock_guard lock(turn_);
    bytes_ -= held.used;
    // Destructors call this: it must not allocate.
    if (!isKept(held) || spare_.size() == spare_.capacity()) {
        held.memory.clear();
        return;
    }
    spareBytes_ += held.size;
    spare_.push_back(std::move(held));
    dropSpare(mostSpare_);
}

std::uint64_t MemoryStore::bytes() const {
    const std::lock_guard lock(turn_);
    return bytes_;
}

std::uint64_t MemoryStore::peakBytes() const {
    const std::lock_guard lock(turn_);
    return peakBytes_;
}

std::uint64_t MemoryStore::spareBytes() const {
    const std::lock_guard lock(turn_);
    return spareBytes_;
}

}  // namespace nacre::gpu
