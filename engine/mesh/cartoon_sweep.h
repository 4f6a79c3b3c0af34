#pragma once
// Cross-sections swept along a curve: closed pieces of a cartoon.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/mesh/cartoon_curve.h"
#include "engine/mesh/mesh.h"

namespace nacre {

/// Half of the extent of a cross-section along Frame::side and Frame::normal, Å.
struct Section {
    double width = 0, thickness = 0;
};

enum class SectionShape { oval, rectangle };

/// A piece of a sweep, from frame `first` to frame `last` (first < last).
struct SweepPiece {
    std::size_t first = 0, last = 0;
    SectionShape shape = SectionShape::oval;
    bool roundBegin = false, roundEnd = false;  ///< for ovals: hemispherical ends, else flat
    std::vector<Section> sections;              ///< per frame, from first to last
};

/// Adds a closed piece. It is also closed in each of the mesh's levels, which omit sides, and rings within a residue.
/// @param owners  atom of the stretch from each frame to the next: vertices are duplicated where it changes
/// @param origin  of the mesh's positions
/// @param sides  vertices around an oval
void sweep(Mesh& mesh, std::span<const Frame> frames, const SweepPiece& piece, std::span<const std::uint32_t> owners,
           const glm::dvec3& origin, int sides);

}  // namespace nacre
