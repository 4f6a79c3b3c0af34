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
constexpr std::uint32_t kBouncedVersion = 1;

/// Bytes per texel of an atlas with bounced light: openness, then the light of the surroundings, red to blue.
constexpr std::uint32_t kBouncedChannels = 4;

/// An atlas with bounced light, from a finished one. The light of the surroundings is the mean over all directions in
/// which a texel does not see the sky, weighted by the cosine to its surface: of the colour that is nearest there,
/// times the light that reaches that. The sky's light is 1, and bytes hold square roots. Rays on the host
/// (light_spots.h), so that it is the same on every device and path.
/// @param open  a byte per texel @param stop  when requested, returns early and incomplete
std::vector<std::uint8_t> bouncedLight(const Representation& representation, const OcclusionLayout& layout,
                                       std::span<const std::uint8_t> open, const std::stop_token& stop = {});

}  // namespace nacre
