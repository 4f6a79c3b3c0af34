#pragma once
// Translucent primitives: those with a colour that is not opaque (colors.h).

#include <cstdint>
#include <vector>

#include "engine/scene/build/representation.h"

namespace nacre {

/// Opacity class of a primitive, by its most opaque end or vertex.
enum class Translucency : std::uint8_t {
    opaque,  ///< fully opaque
    dense,   ///< above one half: picking hits it
    faint,   ///< picking and layers ignore it
};
Translucency classifyTranslucency(const SphereLook& look);
Translucency classifyTranslucency(const CylinderLook& look);
Translucency classifyTranslucency(const Representation& representation, const Triangle& triangle);

/// Consecutive translucent primitives of a stream.
struct TranslucentRun {
    std::uint32_t first = 0, count = 0;
    Translucency kind = Translucency::dense;
    friend bool operator==(const TranslucentRun&, const TranslucentRun&) = default;
};
using TranslucentRuns = std::vector<TranslucentRun>;  ///< ascending

struct TranslucentParts {
    TranslucentRuns spheres, cylinders, triangles;
    bool empty() const { return !hasAtoms() && triangles.empty(); }
    bool hasAtoms() const { return !spheres.empty() || !cylinders.empty(); }
    friend bool operator==(const TranslucentParts&, const TranslucentParts&) = default;
};

TranslucentParts translucentParts(const Representation& representation);

/// Translucent primitives on a way through them, on average per Å: their area in a picture from any side, by the volume
/// of the ellipsoid in their box.
double layersPerLength(const Representation& representation, const TranslucentParts& parts);

/// Sorts the triangles of a mesh by class, so that there are few runs.
void orderByTranslucency(const Representation& representation, std::vector<Triangle>::iterator first,
                         std::vector<Triangle>::iterator end);

}  // namespace nacre
