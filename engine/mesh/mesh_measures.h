#pragma once
// Area, volume and number of parts of a mesh.

#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.h"

namespace nacre {

struct MeshMeasures {
    double area = 0;    ///< Å^2
    double volume = 0;  ///< Å^3, enclosed; cavities are subtracted, overlaps count twice
};
MeshMeasures measure(const Mesh& mesh);

/// For each vertex the index, from 0, of its connected part: vertices connect by triangles, not by equal positions.
/// Parts are numbered by their first vertex.
std::vector<std::uint32_t> meshParts(const Mesh& mesh);

/// Removes parts with a negative volume: cavities, seen from inside a body. @return their number
std::size_t dropCavities(Mesh& mesh);

}  // namespace nacre
