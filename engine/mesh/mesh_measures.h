#pragma once
// What a mesh encloses, and of how many parts it is.

#include <cstdint>
#include <vector>

#include "engine/mesh/mesh.h"

namespace nacre {

struct MeshMeasures {
    double area = 0;    ///< Å^2
    double volume = 0;  ///< Å^3, enclosed; cavities count against it, what overlaps counts twice
};
MeshMeasures measure(const Mesh& mesh);

/// The number, from 0, of the connected part that each vertex belongs to: vertices are joined by triangles, not by
/// standing at the same place. Parts are numbered by their first vertex.
std::vector<std::uint32_t> meshParts(const Mesh& mesh);

/// Removes the parts that enclose a negative volume: cavities, seen from within a body. @return how many there were
std::size_t dropCavities(Mesh& mesh);

}  // namespace nacre
