#pragma once
// Light that surfaces send each other: what hides the sky from a place gives it some in its own colour.

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "engine/occlusion/atlas_layout.h"
#include "engine/scene/build/representation.h"

namespace nacre {

/// Changes with every change of the result: part of the names of stored ones.
constexpr std::uint32_t kBouncedVersion = 2;

/// Bytes per texel of an atlas with bounced light. The upper half of the image holds openness, then the light of the
/// surroundings, red to blue. The lower half, as high again, holds where the sky is (SkyLean) in 256ths, 128 being 0,
/// and a byte without use.
constexpr std::uint32_t kBytesPerBounced = 8;

/// An atlas with bounced light, from a finished one. The light of the surroundings is the mean over all directions in
/// which a texel does not see the sky, weighted by the cosine to its surface: of the colour that is nearest there,
/// times the light that reaches that. The sky's light is 1, and bytes hold square roots. The sky is brighter above, so
/// a texel also stores where it sees it. Rays on the host (light_spots.h), so that it is the same on every device and
/// path.
/// @param open  a byte per texel @param stop  when requested, returns early and incomplete
std::vector<std::uint8_t> bouncedLight(const Representation& representation, const OcclusionLayout& layout,
                                       std::span<const std::uint8_t> open, const std::stop_token& stop = {});

}  // namespace nacre
