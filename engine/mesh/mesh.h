#pragma once
// Triangles in space: what cartoons and surfaces are made of. Knows no Vulkan.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace nacre {

/// Triangles that stand for all of a mesh where they are small in the picture.
struct MeshLevel {
    /// Å that no point of either is off the other by: of cartoons a bound by construction, of surfaces what was
    /// measured at their vertices.
    float error = 0;
    std::vector<glm::uvec3> triangles;  ///< as Mesh's: of some of its vertices
};

/// A surface of triangles. Vertices that differ in normal or atom are stored apart even where they share a place.
struct Mesh {
    std::vector<glm::vec3> positions;  ///< Å, relative to an origin that the maker states
    std::vector<glm::vec3> normals;    ///< unit vectors, outward; same length as positions
    /// Index into the molecule's atoms: whose colour and number the vertex has. A point of a triangle takes those of
    /// the vertex with the largest barycentric weight. Same length as positions.
    std::vector<std::uint32_t> atoms;
    std::vector<glm::uvec3> triangles;  ///< indices of vertices, counter-clockwise seen from outside
    std::vector<MeshLevel> coarser{};   ///< each with a larger error than the one before
};

}  // namespace nacre
