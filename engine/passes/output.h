#pragma once

#include <cstdint>

namespace nacre::passes {

/// What a shading pass writes of a pixel's nearest surface.
enum class Output : std::uint8_t {
    color,     ///< linear, opaque
    surface,   ///< view-space normal and Z, 4 floats
    identity,  ///< atom and the bits of its occlusion, 2 unsigned numbers
};

}  // namespace nacre::passes
