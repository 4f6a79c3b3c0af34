#pragma once
// The copies of a scene as one view sees them: what the geometry passes draw, one call a copy.

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "engine/results.h"
#include "engine/scene/camera.h"
#include "engine/scene/chunks.h"
#include "engine/scene/representation.h"

namespace nacre::passes {

struct PlacedCopies {
    /// Instances of a stream, drawn at one copy's place.
    struct Call {
        std::uint32_t copy = 0;  ///< index of three rows
        std::uint32_t first = 0, count = 0;
    };
    std::vector<glm::vec4> rows;  ///< three a transform: into view space, as ViewConstants has them
    std::vector<Call> spheres, cylinders, triangles;

    void clear() { rows.clear(), spheres.clear(), cylinders.clear(), triangles.clear(); }
    /// Of all calls together.
    std::uint64_t sphereCount() const;
    std::uint64_t cylinderCount() const;
    std::uint64_t triangleCount() const;
    /// By the meshes' levels of detail.
    std::vector<MeshLevelCount> triangleLevels(const Representation& representation) const;
};

/// Rotations and shifts are composed in double precision. Runs of copies whose bounding sphere lies outside the picture
/// are left out, and so are chunks; what is left stays in the order of the streams.
/// @param chunks  of the representation; null: there are only whole runs
/// @param room    pixels beside a primitive that show it, too
/// @param error   Å that meshes may be off by (drawnRuns())
/// @param wires   they are drawn, too, behind the cylinders, once whatever the copies
PlacedCopies placeCopies(const Representation& representation, const View& view, const Chunks* chunks = nullptr,
                         double room = 0, double error = 0, bool wires = false);
/// The same, where an earlier view's have their room.
void placeCopies(PlacedCopies& placed, const Representation& representation, const View& view, const Chunks* chunks,
                 double room, double error, bool wires = false);

}  // namespace nacre::passes
