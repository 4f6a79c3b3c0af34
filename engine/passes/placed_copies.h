#pragma once
// The copies of a scene as one view sees them. Geometry passes draw them, one call per copy.

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "engine/results.h"
#include "engine/scene/build/chunks.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre::passes {

struct PlacedCopies {
    /// Instances of a stream, drawn for one copy.
    struct Call {
        std::uint32_t copy = 0;  ///< index of its three rows
        std::uint32_t first = 0, count = 0;
    };
    std::vector<glm::vec4> rows;     ///< three per transform: into view space, as in ViewConstants
    std::vector<float> otherShifts;  ///< of two views: per transform, the other's row 0, w
    std::vector<Call> spheres, cylinders, triangles;

    void clear() { rows.clear(), otherShifts.clear(), spheres.clear(), cylinders.clear(), triangles.clear(); }
    /// Total over all calls.
    std::uint64_t sphereCount() const;
    std::uint64_t cylinderCount() const;
    std::uint64_t triangleCount() const;
    /// Per level of detail of the meshes.
    std::vector<MeshLevelCount> triangleLevels(const Representation& representation) const;
};

/// Composes rotations and shifts in double precision. Culls runs of copies whose bounding sphere lies outside the
/// picture, and such chunks; the rest keeps the order of the streams. With two views, keeps what either shows.
/// @param chunks  of the representation; null: whole runs only
/// @param room    margin around a primitive in which it still shows, pixels
/// @param error   allowed error of meshes, Å (drawnRuns())
/// @param wires   add them after the cylinders, once for all copies
PlacedCopies placeCopies(const Representation& representation, const View& view, const Chunks* chunks = nullptr,
                         double room = 0, double error = 0, bool wires = false);
/// As above, reusing the memory of an earlier view.
void placeCopies(PlacedCopies& placed, const Representation& representation, const View& view, const Chunks* chunks,
                 double room, double error, bool wires = false);

}  // namespace nacre::passes
