#pragma once

#include <cstdint>

namespace nacre::passes {

/// What a shading pass writes of a pixel's nearest surface.
enum class Output : std::uint8_t {
    color,     ///< linear, opaque
    surface,   ///< view-space normal and Z, 4 floats
    identity,  ///< atom and the bits of its occlusion, 2 unsigned numbers
};

/// Where a pass finds the nearest depth of a pixel.
enum class NearestFrom : std::uint8_t {
    depthBuffer,      ///< by the depth test alone
    inputAttachment,  ///< what an earlier subpass left
    texture,          ///< the same, where it left the tile
    ownAttachment,    ///< which the pass itself keeps, in raster order
};

}  // namespace nacre::passes
