#pragma once

#include <cstdint>

namespace nacre::passes {

/// Values that a shading pass writes for a pixel's nearest surface.
enum class Output : std::uint8_t {
    color,     ///< linear, opaque
    surface,   ///< view-space normal and Z, 4 floats
    identity,  ///< atom, and the bits of its occlusion, 2 unsigned integers
};

/// Source of a pixel's nearest depth.
enum class NearestFrom : std::uint8_t {
    depthBuffer,      ///< the depth test alone
    inputAttachment,  ///< output of an earlier subpass
    texture,          ///< output of an earlier subpass, as a texture in memory
    ownAttachment,    ///< the pass's own attachment, in raster order
};

}  // namespace nacre::passes
