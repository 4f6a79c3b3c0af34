#pragma once
// How long the device takes for the parts of what is submitted, by timestamps where its queue has them.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/gpu/device.h"
#include "engine/results.h"

namespace nacre::gpu {

/// One stamp before the first part and one behind each: a part's time runs from the end of the one before it to its own
/// end, so that times add up to the whole however parts overlap. Parts are render passes, dispatches and copies: what
/// happens within a render pass is the tiler's own affair.
class Timer {
public:
    explicit Timer(const Device& device);

    /// Whether the device's queue stamps times. If not, nothing is recorded, and times() are none.
    bool there() const { return static_cast<bool>(*pool_); }
    /// Call outside of render passes, before the first part.
    void begin(const vk::raii::CommandBuffer& commands);
    /// Call behind each part. Those beyond what there is room for add to the last.
    void lap(const vk::raii::CommandBuffer& commands, std::string part);
    /// Of what begin() and lap() recorded last; call when those commands have run. None if nothing was recorded.
    std::vector<PassTime> times() const;
    /// The same, in all.
    std::optional<double> milliseconds() const;

private:
    static constexpr std::uint32_t kStamps = 64;
    using Stamps = std::array<std::uint64_t, kStamps>;
    /// As many as were written, and how many those are; 0 if the device does not tell.
    std::size_t read(Stamps& stamps) const;
    double millisecondsBetween(std::uint64_t from, std::uint64_t to) const;

    const Device& device_;
    vk::raii::QueryPool pool_{nullptr};
    std::vector<std::string> parts_;
    bool begun_ = false;
};

}  // namespace nacre::gpu
