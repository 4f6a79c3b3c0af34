#pragma once
// Translucent triangles: those with a vertex whose colour is not opaque (colors.h).

#include <cstdint>
#include <vector>

#include "engine/scene/build/representation.h"

namespace nacre {

/// Opacity class of a triangle, by its most opaque vertex.
enum class Translucency : std::uint8_t {
    opaque,  ///< fully opaque
    dense,   ///< above one half: picking hits it
    faint,   ///< picking and layers ignore it
};
Translucency translucencyOf(const Representation& representation, const Triangle& triangle);

/// Consecutive translucent triangles.
struct TranslucentRun {
    std::uint32_t first = 0, count = 0;
    Translucency kind = Translucency::dense;
};
using TranslucentRuns = std::vector<TranslucentRun>;  ///< ascending

TranslucentRuns translucentRuns(const Representation& representation);

/// Sorts the triangles of a mesh by class, so that there are few runs.
void orderByTranslucency(const Representation& representation, std::vector<Triangle>::iterator first,
                         std::vector<Triangle>::iterator end);

}  // namespace nacre
