#pragma once
// Triangle meshes of cartoons and surfaces. Makes no Vulkan calls.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace nacre {

/// A coarser level of detail: triangles for a mesh that is small in the picture.
struct MeshLevel {
    /// Largest distance between level and mesh, Å: for cartoons a guaranteed bound, for surfaces measured at their
    /// vertices.
    float error = 0;
    std::vector<glm::uvec3> triangles;  ///< as in Mesh, from some of its vertices
};

/// A triangle mesh. Vertices with different normals or atoms are separate even at one position.
struct Mesh {
    std::vector<glm::vec3> positions;  ///< Å, relative to an origin that the maker states
    std::vector<glm::vec3> normals;    ///< unit vectors, outward; same length as positions
    /// Index into the molecule's atoms, for colour and number. A point of a triangle takes the atom of the vertex with
    /// the largest product of barycentric weight and margin. Same length as positions.
    std::vector<std::uint32_t> atoms;
    std::vector<glm::uvec3> triangles;  ///< indices of vertices, counter-clockwise seen from outside
    std::vector<MeshLevel> coarser{};   ///< by increasing error
    /// Å by which a vertex is nearer to its own atom than to its neighbours' nearest one. Puts borders where two atoms
    /// are equally near. Empty: all equal.
    std::vector<float> margins{};
};

}  // namespace nacre
