#pragma once
// Triangles that one looks through: those with a vertex whose colour is not opaque (colors.h).

#include <cstdint>
#include <vector>

#include "engine/scene/representation.h"

namespace nacre {

/// How much a triangle hides, by its most opaque vertex.
enum class Translucency : std::uint8_t {
    opaque,  ///< all of it is
    dense,   ///< over a half: it is what a pointer meets
    faint,   ///< a pointer, and what layers tell of a pixel, go through it
};
Translucency translucencyOf(const Representation& representation, const Triangle& triangle);

/// Neighbouring triangles that are not opaque.
struct TranslucentRun {
    std::uint32_t first = 0, count = 0;
    Translucency kind = Translucency::dense;
};
using TranslucentRuns = std::vector<TranslucentRun>;  ///< ascending

TranslucentRuns translucentRuns(const Representation& representation);

/// Puts the triangles of a mesh in the order of their kinds, so that there are few runs.
void orderByTranslucency(const Representation& representation, std::vector<Triangle>::iterator first,
                         std::vector<Triangle>::iterator end);

}  // namespace nacre
