#pragma once

#include <cstdint>
#include <vector>

#include "engine/occlusion/atlas_layout.h"

namespace nacre {

/// The stored result of a finished bake. Pictures are bit-identical to those drawn with the bake.
struct FinishedOcclusion {
    OcclusionLayout layout;
    std::vector<std::uint8_t> atlas;  ///< layout.width x layout.height texels, of one byte or kBytesPerBounced
    std::vector<bool> seenSpheres;    ///< for each sphere whether any direction saw any of it
    std::uint64_t openTexels = 0;
    bool bounced = false;  ///< with bounced light (bounced_light.h)
};

}  // namespace nacre
