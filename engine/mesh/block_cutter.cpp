#include "engine/mesh/block_cutter.h"

#include <algorithm>
#include <bit>

#include "engine/mesh/marching_cubes.h"
#include "engine/mesh/solids.h"

namespace nacre {
namespace {

glm::ivec3 cornerOffset(int c) { return {c & 1, c >> 1 & 1, c >> 2 & 1}; }

}  // namespace

BlockMesh BlockCutter::cut(const GridBlock& block, std::span<const std::uint32_t> sources) {
    block_ = block;
    result_ = {};
    const glm::ivec3 n = block.nodes();
    const std::size_t nodes = static_cast<std::size_t>(n.x) * n.y * n.z,
                      layer = static_cast<std::size_t>(n.x) * n.y * 3;
    values_.resize(nodes);
    origins_.resize(nodes);
    field_.fill(block_, sources, values_, origins_);
    findInside();
    vertices_.assign(2 * layer, kNoSource);
    crossings_.clear();
    points_.clear();
    for (int z = 0; z + 1 < n.z; ++z) {
        for (int y = 0; y + 1 < n.y; ++y) {
            const std::uint64_t* rows = inside_.data() + static_cast<std::size_t>(z) * n.y + y;
            const std::uint64_t any = rows[0] | rows[1] | rows[n.y] | rows[n.y + 1];
            const std::uint64_t all = rows[0] & rows[1] & rows[n.y] & rows[n.y + 1];
            std::uint64_t cells = (any | any >> 1) & ~(all & all >> 1) & ((std::uint64_t{1} << (n.x - 1)) - 1);
            for (; cells != 0; cells &= cells - 1) cutCell(block_.first + glm::ivec3(std::countr_zero(cells), y, z));
        }
        std::fill_n(vertices_.begin() + static_cast<std::ptrdiff_t>(z % 2 * layer), layer, kNoSource);
    }
    field_.cross(block_, sources, crossings_, points_);
    for (const SurfacePoint& point : points_) addVertex(result_.mesh, point.place + shift_, point.normal, point.atom);
    return std::move(result_);
}

void BlockCutter::findInside() {
    const glm::ivec3 n = block_.nodes();
    inside_.resize(static_cast<std::size_t>(n.y) * n.z);
    const float* value = values_.data();
    for (std::uint64_t& row : inside_) {
        row = 0;
        for (int x = 0; x < n.x; ++x) row |= static_cast<std::uint64_t>(*value++ > 0) << x;
    }
}

void BlockCutter::cutCell(const glm::ivec3& cell) {
    const glm::ivec3 n = block_.nodes(), at = cell - block_.first;
    const std::uint64_t* rows = inside_.data() + static_cast<std::size_t>(at.z) * n.y + at.y;
    const std::size_t inside = (rows[0] >> at.x & 3) | (rows[1] >> at.x & 3) << 2 | (rows[n.y] >> at.x & 3) << 4 |
                               (rows[n.y + 1] >> at.x & 3) << 6;
    for (const CellTriangle& triangle : cellTriangles()[inside])
        result_.mesh.triangles.emplace_back(vertexOn(cell, triangle[0]), vertexOn(cell, triangle[1]),
                                            vertexOn(cell, triangle[2]));
}

std::uint32_t BlockCutter::vertexOn(const glm::ivec3& cell, std::uint8_t number) {
    const CellEdge edge = cellEdges()[number];
    const glm::ivec3 a = cell + cornerOffset(edge.from), b = cell + cornerOffset(edge.to), way = b - a;
    const int direction = way.x ? 0 : way.y ? 1 : 2;
    const glm::ivec3 n = block_.nodes(), place = a - block_.first;
    const std::size_t inTwoLayers = (static_cast<std::size_t>(place.z % 2) * n.y + place.y) * n.x + place.x;
    std::uint32_t& vertex = vertices_[3 * inTwoLayers + direction];
    if (vertex != kNoSource) return vertex;
    const std::size_t atA = block_.index(a), atB = block_.index(b);
    const GridCrossing::Node nodeA{block_.place(a), values_[atA], origins_[atA]};
    const GridCrossing::Node nodeB{block_.place(b), values_[atB], origins_[atB]};
    vertex = static_cast<std::uint32_t>(crossings_.size());
    crossings_.push_back(values_[atA] > 0 ? GridCrossing{nodeA, nodeB} : GridCrossing{nodeB, nodeA});
    for (int i = 0; i < 3; ++i)
        if (i != direction && (a[i] == block_.first[i] || a[i] == block_.last[i])) {
            result_.shared.emplace_back(vertex, GridEdge{a, direction});
            break;
        }
    return vertex;
}

}  // namespace nacre
