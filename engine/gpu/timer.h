#pragma once
// GPU times of the parts of a submission, by timestamps where the queue has them.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/gpu/device.h"
#include "engine/results.h"

namespace nacre::gpu {

/// One timestamp before the first part and one after each. A part's time runs from the end of the previous part to its
/// own end, so times add up to the total even if parts overlap. Parts are render passes, dispatches and copies: a
/// tile-based GPU orders the work within a render pass as it likes.
class Timer {
public:
    explicit Timer(const Device& device);

    /// Whether the device's queue has timestamps. If not, nothing is recorded and times() is empty.
    bool there() const { return static_cast<bool>(*pool_); }
    /// Call outside render passes, before the first part.
    void begin(const vk::raii::CommandBuffer& commands);
    /// Call after each part. Parts beyond the capacity are added to the last.
    void lap(const vk::raii::CommandBuffer& commands, std::string part);
    /// Times since the last begin(); call when those commands are done. Empty if nothing was recorded.
    std::vector<PassTime> times() const;
    /// Sum of times().
    std::optional<double> milliseconds() const;

private:
    static constexpr std::uint32_t kStamps = 64;
    using Stamps = std::array<std::uint64_t, kStamps>;
    /// Reads all timestamps that were written and returns their number; 0 if the device returns none.
    std::size_t read(Stamps& stamps) const;
    double millisecondsBetween(std::uint64_t from, std::uint64_t to) const;

    const Device& device_;
    vk::raii::QueryPool pool_{nullptr};
    std::vector<std::string> parts_;
    bool begun_ = false;
};

}  // namespace nacre::gpu
