#pragma once
// Where a movie's pictures come from.

#include <cstdint>
#include <functional>
#include <optional>

#include "engine/results.h"

namespace nacre::app {

class MovieSource {
public:
    virtual ~MovieSource() = default;
    virtual std::uint64_t frames() const = 0;
    /// A frame, 0..frames() - 1, in any order. @throws Error
    virtual Picture draw(std::uint64_t frame) = 0;
    /// The model, record, frame of a trajectory or snapshot that a frame shows, from 1; none if all show the same.
    virtual std::optional<int> modelOf(std::uint64_t frame) const = 0;
    /// Called with the finished share while occlusion is baked.
    std::function<void(double)> onBake;
};

}  // namespace nacre::app
