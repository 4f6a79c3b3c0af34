#include "engine/mesh/marching_cubes.h"

namespace nacre {
namespace {

constexpr std::uint8_t kNoEdge = 0xff;

std::uint8_t edgeBetween(int a, int b) {
    for (std::uint8_t e = 0; e < kCellEdges; ++e) {
        const CellEdge& edge = cellEdges()[e];
        if ((edge.from == a && edge.to == b) || (edge.from == b && edge.to == a)) return e;
    }
    return kNoEdge;
}

/// The corners of each face, counter-clockwise seen from outside the cell.
constexpr std::array<std::array<int, 4>, 6> kFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

std::vector<CellTriangle> makeTriangles(int inside) {
    const auto isInside = [&](int corner) { return (inside >> corner & 1) != 0; };
    // Around a face: connects the edge where a run of inside corners begins with the edge where it ends.
    std::array<std::uint8_t, kCellEdges> next;
    next.fill(kNoEdge);
    for (const auto& face : kFaces)
        for (int i = 0; i < 4; ++i) {
            if (!isInside(face[i]) || isInside(face[(i + 3) % 4])) continue;
            int last = i;
            while (isInside(face[(last + 1) % 4])) ++last;
            next[edgeBetween(face[(i + 3) % 4], face[i])] = edgeBetween(face[last % 4], face[(last + 1) % 4]);
        }
    std::vector<CellTriangle> triangles;
    for (std::uint8_t start = 0; start < kCellEdges; ++start) {
        if (next[start] == kNoEdge) continue;
        std::vector<std::uint8_t> loop;
        for (std::uint8_t e = start; next[e] != kNoEdge;) {
            loop.push_back(e);
            const std::uint8_t following = next[e];
            next[e] = kNoEdge;
            e = following;
        }
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) triangles.push_back({loop[0], loop[i], loop[i + 1]});
    }
    return triangles;
}

}  // namespace

const std::array<CellEdge, kCellEdges>& cellEdges() {
    static constexpr std::array<CellEdge, kCellEdges> kEdges{
        {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    return kEdges;
}

const std::array<std::vector<CellTriangle>, 256>& cellTriangles() {
    static const std::array<std::vector<CellTriangle>, 256> kTriangles = [] {
        std::array<std::vector<CellTriangle>, 256> all;
        for (int inside = 0; inside < 256; ++inside) all[static_cast<std::size_t>(inside)] = makeTriangles(inside);
        return all;
    }();
    return kTriangles;
}

}  // namespace nacre
