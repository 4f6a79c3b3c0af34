#pragma once
// Cuts a surface out of one block of its grid by marching cubes.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/mesh/surface_field.h"

namespace nacre {

/// An edge of the grid, by its lower node and its direction.
struct GridEdge {
    glm::ivec3 node{};
    int direction = 0;
    friend bool operator==(const GridEdge&, const GridEdge&) = default;
};
struct GridEdgeHash {
    std::size_t operator()(const GridEdge& edge) const {
        std::size_t h = static_cast<std::size_t>(edge.direction);
        for (const int v : {edge.node.x, edge.node.y, edge.node.z})
            h = (h ^ static_cast<std::size_t>(static_cast<unsigned>(v))) * 0x9e3779b97f4a7c15u;
        return h ^ h >> 32;
    }
};

/// Output of a block: a mesh, and its vertices shared with other blocks.
struct BlockMesh {
    Mesh mesh;
    std::vector<std::pair<std::uint32_t, GridEdge>> shared;
};

/// Cuts block after block. Visits only cells that the surface crosses: a row of nodes is a word with a bit per node,
/// set inside.
class BlockCutter {
public:
    static constexpr int kMostCells = 63;  ///< along x

    /// @param field  outlives this @param shift  of the vertices, Å
    BlockCutter(const SurfaceField& field, const glm::dvec3& shift) : field_(field), shift_(shift) {}

    /// @param sources  of the field that reach into the block
    BlockMesh cut(const GridBlock& block, std::span<const std::uint32_t> sources);

private:
    void findInside();
    void cutCell(const glm::ivec3& cell);
    std::uint32_t vertexOn(const glm::ivec3& cell, std::uint8_t number);

    const SurfaceField& field_;
    glm::dvec3 shift_;
    GridBlock block_;
    std::vector<float> values_;
    std::vector<std::uint32_t> origins_;
    std::vector<std::uint64_t> inside_;  // by row of nodes
    // by edge, for two layers of nodes in turn, and the edges from them to the next layer
    std::vector<std::uint32_t> vertices_;
    std::vector<GridCrossing> crossings_;  // by vertex
    std::vector<SurfacePoint> points_;
    BlockMesh result_;
};

}  // namespace nacre
