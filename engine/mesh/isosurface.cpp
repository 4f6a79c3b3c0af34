#include "engine/mesh/isosurface.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>

#include "engine/error.h"
#include "engine/mesh/carve.h"
#include "engine/mesh/marching_cubes.h"
#include "engine/threads.h"

namespace nacre {
namespace {

constexpr int kBlock = MapRegion::kBlock;
constexpr double kMostNodes = 1e9;  // of a region

/// An edge of a cell: its lower end and its direction.
struct PlacedEdge {
    int direction = 0, x = 0, y = 0, z = 0;
};
std::array<PlacedEdge, kCellEdges> placedEdges() {
    std::array<PlacedEdge, kCellEdges> edges;
    for (std::size_t i = 0; i < kCellEdges; ++i) {
        const CellEdge& e = cellEdges()[i];
        const int way = e.from ^ e.to;
        edges[i] = {way == 1 ? 0 : way == 2 ? 1 : 2, e.from & 1, e.from >> 1 & 1, e.from >> 2 & 1};
    }
    return edges;
}

/// For each of the 256 cell types, the borders of its triangles in the three lower faces. Each face is the lower face
/// of exactly one cell, so this visits borders once; it visits diagonals between triangles twice.
using CellLines = std::array<std::vector<std::array<std::uint8_t, 2>>, 256>;
CellLines lowerLines() {
    CellLines lines;
    const auto inLowerFace = [](std::uint8_t edge, int axis) {
        const CellEdge& e = cellEdges()[edge];
        return ((e.from | e.to) >> axis & 1) == 0;
    };
    for (std::size_t i = 0; i < 256; ++i)
        for (const CellTriangle& t : cellTriangles()[i])
            for (std::size_t side = 0; side < 3; ++side) {
                const std::uint8_t a = t[side], b = t[(side + 1) % 3];
                const auto isReverse = [&](const CellTriangle& other) {
                    for (std::size_t s = 0; s < 3; ++s)
                        if (other[s] == b && other[(s + 1) % 3] == a) return true;
                    return false;
                };
                const auto& all = cellTriangles()[i];
                if (std::any_of(all.begin(), all.end(), isReverse)) continue;
                for (int axis = 0; axis < 3; ++axis)
                    if (inLowerFace(a, axis) && inLowerFace(b, axis)) {
                        lines[i].push_back({a, b});
                        break;
                    }
            }
    return lines;
}

int wrappedNode(int at, int count) {
    const int rest = at % count;
    return rest < 0 ? rest + count : rest;
}

}  // namespace

/// Cuts one layer of blocks. The vertices on its upper plane start the next layer and are numbered after its own.
class IsosurfaceSlab {
public:
    IsosurfaceSlab(const MapRegion& region, float level, bool above, IsosurfaceParts parts, const glm::dvec3& origin)
        : region_(region),
          map_(region.map_),
          values_(region.values()),
          n_(region.size_),
          level_(level),
          above_(above),
          parts_(parts),
          toSpace_(glm::transpose(glm::inverse(region.map_.step))),
          shift_(region.map_.place(glm::dvec3(region.first_)) - origin),
          mirrored_(glm::determinant(region.map_.step) < 0) {}

    Isosurface cut(int layer) {
        const int begin = layer * kBlock, end = std::min(begin + kBlock, n_.z - 1);
        const std::size_t plane = static_cast<std::size_t>(n_.x) * n_.y;
        for (auto* lists : {&lower_, &upper_})
            for (auto& list : *lists) list.resize(plane);
        upright_.resize(plane);
        const bool last = end == n_.z - 1;
        edgesInPlane(begin, upper_, true);
        for (int z = begin; z < end; ++z) {
            std::swap(lower_, upper_);
            edgesBetween(z);
            // The last plane belongs to this layer; other upper planes belong to the next layer.
            edgesInPlane(z + 1, upper_, z + 1 < end || last);
            cells(z);
        }
        return std::move(result_);
    }

private:
    using PlaneEdges = std::array<std::vector<std::uint32_t>, 2>;  // along x and y, by the lower node

    bool inside(float value) const { return above_ ? value > level_ : value < level_; }
    std::size_t index(int x, int y, int z) const { return (static_cast<std::size_t>(z) * n_.y + y) * n_.x + x; }
    static int blockIndex(int node, int blocks) { return std::min(node / kBlock, blocks - 1); }

    bool isActive(int x, int y, int z) const {
        const glm::ivec3& b = region_.blocks_;
        const MapRegion::Range& r = region_.ranges_[(static_cast<std::size_t>(z) * b.y + y) * b.x + x];
        return above_ ? r.high > level_ && r.low <= level_ : r.low < level_ && r.high >= level_;
    }

    /// Visits the rows of active blocks: nodes of a plane, or the cells above it.
    template <typename Visit>
    void eachRow(int z, bool ofCells, const Visit& visit) const {
        const glm::ivec3& b = region_.blocks_;
        const int layer = blockIndex(z, b.z);
        for (int by = 0; by < b.y; ++by)
            for (int bx = 0; bx < b.x; ++bx) {
                if (!isActive(bx, by, layer)) continue;
                const auto until = [&](int at, int blocks, int nodes) {
                    const int cells = std::min((at + 1) * kBlock, nodes - 1);
                    return ofCells || at + 1 < blocks ? cells : nodes;
                };
                const int endX = until(bx, b.x, n_.x), endY = until(by, b.y, n_.y);
                for (int y = by * kBlock; y < endY; ++y) visit(y, bx * kBlock, endX);
            }
    }

    /// @param keep  store the vertices; else only count them
    void edgesInPlane(int z, PlaneEdges& edges, bool keep) {
        auto next = static_cast<std::uint32_t>(result_.positions.size());
        eachRow(z, false, [&](int y, int x, int endX) {
            for (; x < endX; ++x) {
                const std::size_t at = index(x, y, z), inPlane = static_cast<std::size_t>(y) * n_.x + x;
                const float here = values_[at];
                const bool in = inside(here);
                const auto edge = [&](int axis, std::size_t there) {
                    const float other = values_[there];
                    if (inside(other) == in || std::isnan(here) || std::isnan(other)) return;
                    if (keep) addVertex({x, y, z}, axis, here, other);
                    edges[static_cast<std::size_t>(axis)][inPlane] = next++;
                };
                if (x + 1 < n_.x) edge(0, at + 1);
                if (y + 1 < n_.y) edge(1, at + n_.x);
            }
        });
    }
    void edgesBetween(int z) {
        auto next = static_cast<std::uint32_t>(result_.positions.size());
        const std::size_t plane = static_cast<std::size_t>(n_.x) * n_.y;
        eachRow(z, false, [&](int y, int x, int endX) {
            for (; x < endX; ++x) {
                const std::size_t at = index(x, y, z);
                const float here = values_[at], other = values_[at + plane];
                if (inside(other) == inside(here) || std::isnan(here) || std::isnan(other)) continue;
                addVertex({x, y, z}, 2, here, other);
                upright_[static_cast<std::size_t>(y) * n_.x + x] = next++;
            }
        });
    }

    void addVertex(const glm::ivec3& node, int axis, float here, float other) {
        const double share = (static_cast<double>(level_) - static_cast<double>(here)) /
                             (static_cast<double>(other) - static_cast<double>(here));
        glm::dvec3 at(node);
        at[axis] += share;
        result_.positions.emplace_back(map_.step * at + shift_);
        if (parts_ == IsosurfaceParts::lines) return;
        glm::ivec3 next = node;
        ++next[axis];
        const glm::dvec3 gradient = gradientAt(node) * (1 - share) + gradientAt(next) * share;
        const glm::dvec3 normal = toSpace_ * gradient * (above_ ? -1.0 : 1.0);
        const double length = glm::length(normal);
        result_.normals.emplace_back(length > 0 ? normal / length : glm::dvec3(0, 0, 1));
    }
    /// Gradient of the values at a node. One-sided at the ends of a box and next to unknown values.
    glm::dvec3 gradientAt(const glm::ivec3& node) const {
        const glm::ivec3 in = region_.first_ + node;
        const double here = static_cast<double>(mapValue(in));
        glm::dvec3 gradient(0);
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 before = in, after = in;
            --before[axis];
            ++after[axis];
            const auto low = static_cast<double>(mapValue(before)), high = static_cast<double>(mapValue(after));
            if (std::isnan(low) && std::isnan(high)) continue;
            gradient[axis] = std::isnan(low) ? high - here : std::isnan(high) ? here - low : (high - low) / 2;
        }
        return gradient;
    }
    /// Value of the map itself, inside or outside the region.
    float mapValue(glm::ivec3 node) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (node[axis] >= 0 && node[axis] < map_.size[axis]) continue;
            if (!map_.periodic) return kUnknownDensity;
            node[axis] = wrappedNode(node[axis], map_.size[axis]);
        }
        return map_.values[map_.index(node)];
    }

    void cells(int z) {
        eachRow(z, true, [&](int y, int x, int endX) {
            const float* rows[4];
            for (int i = 0; i < 4; ++i) rows[i] = values_ + index(x, y + (i & 1), z + (i >> 1));
            std::uint32_t bits[4] = {}, any = 0, all = ~0u;
            const int count = endX - x;
            for (int i = 0; i < 4; ++i) {
                for (int at = 0; at <= count; ++at) bits[i] |= static_cast<std::uint32_t>(inside(rows[i][at])) << at;
                any |= bits[i];
                all &= bits[i];
            }
            if (any == 0 || (all & ((2u << count) - 1)) == (2u << count) - 1) return;
            for (int at = 0; at < count; ++at) {
                std::size_t corners = 0;
                for (int i = 0; i < 4; ++i) corners |= std::size_t{bits[i] >> at & 3} << 2 * i;
                if (corners != 0 && corners != 255) cell(x + at, y, corners, rows, at);
            }
        });
    }
    void cell(int x, int y, std::size_t corners, const float* const (&rows)[4], int at) {
        for (const float* row : rows)
            if (std::isnan(row[at]) || std::isnan(row[at + 1])) return;
        static const std::array<PlacedEdge, kCellEdges> kEdges = placedEdges();
        static const CellLines kLines = lowerLines();
        const auto vertex = [&](std::uint8_t number) {
            const PlacedEdge& e = kEdges[number];
            const std::size_t inPlane = static_cast<std::size_t>(y + e.y) * n_.x + (x + e.x);
            if (e.direction == 2) return upright_[inPlane];
            return (e.z ? upper_ : lower_)[static_cast<std::size_t>(e.direction)][inPlane];
        };
        if (parts_ == IsosurfaceParts::lines) {
            for (const auto& line : kLines[corners]) result_.lines.emplace_back(vertex(line[0]), vertex(line[1]));
            return;
        }
        if (parts_ == IsosurfaceParts::vertices) return;
        for (const CellTriangle& t : cellTriangles()[corners]) {
            const std::uint32_t b = vertex(t[1]), c = vertex(t[2]);
            result_.triangles.emplace_back(vertex(t[0]), mirrored_ ? c : b, mirrored_ ? b : c);
        }
    }

    const MapRegion& region_;
    const DensityMap& map_;
    const float* values_;
    glm::ivec3 n_;
    float level_;
    bool above_;
    IsosurfaceParts parts_;
    glm::dmat3 toSpace_;
    glm::dvec3 shift_;
    bool mirrored_;
    PlaneEdges lower_, upper_;
    std::vector<std::uint32_t> upright_;
    Isosurface result_;
};

MapRegion::MapRegion(const DensityMap& map, glm::ivec3 first, glm::ivec3 last) : map_(map) {
    begin(first, last);
    if (map.periodic || size_ != map.size) copyValues();
    findRanges();
}

MapRegion::MapRegion(const DensityMap& map, std::span<const glm::dvec3> places, double carved)
    : map_(map), places_(places.begin(), places.end()), reach_(carved) {
    if (places.empty()) return;
    // All nodes of a cell that the surface may cross within reach.
    const double reach = carved + glm::length(glm::abs(map.step[0]) + glm::abs(map.step[1]) + glm::abs(map.step[2]));
    // The extent of a ball along a grid axis depends on the distance between the grid's planes.
    const glm::dmat3 toNodes = glm::transpose(glm::inverse(map.step));  // columns: normals of the grid planes
    const glm::dvec3 ball(glm::length(toNodes[0]) * reach, glm::length(toNodes[1]) * reach,
                          glm::length(toNodes[2]) * reach);
    glm::dvec3 low(1e300), high(-1e300);
    for (const glm::dvec3& place : places) {
        low = glm::min(low, map.nodeAt(place) - ball);
        high = glm::max(high, map.nodeAt(place) + ball);
    }
    constexpr double kFarthest = 1e8;
    begin(glm::ivec3(glm::clamp(glm::floor(low), -kFarthest, kFarthest)),
          glm::ivec3(glm::clamp(glm::ceil(high), -kFarthest, kFarthest)));
    if (empty()) return;
    copyValues();
    std::vector<bool> within(own_.size(), false);
    for (const glm::dvec3& place : places) {
        const glm::dvec3 middle = map.nodeAt(place) - glm::dvec3(first_);
        const glm::ivec3 from = glm::max(glm::ivec3(glm::ceil(middle - ball)), 0),
                         to = glm::min(glm::ivec3(glm::floor(middle + ball)), size_ - 1);
        for (int z = from.z; z <= to.z; ++z)
            for (int y = from.y; y <= to.y; ++y)
                for (int x = from.x; x <= to.x; ++x) {
                    const glm::dvec3 off = map.step * (glm::dvec3(x, y, z) - middle);
                    if (glm::dot(off, off) <= reach * reach)
                        within[(static_cast<std::size_t>(z) * size_.y + y) * size_.x + x] = true;
                }
    }
    for (std::size_t i = 0; i < own_.size(); ++i)
        if (!within[i]) own_[i] = kUnknownDensity;
    findRanges();
}

void MapRegion::begin(glm::ivec3 first, glm::ivec3 last) {
    if (!map_.periodic) {
        first = glm::max(first, 0);
        last = glm::min(last, map_.size - 1);
    }
    first_ = first;
    size_ = glm::max(last - first + 1, 0);
    const double nodes = 1.0 * size_.x * size_.y * size_.z;
    if (nodes > kMostNodes)
        throw Error("cannot draw map", map_.name,
                    "its part about the molecule has " + std::to_string(std::llround(nodes / 1e6)) +
                        " million grid nodes, more than the limit of 1000 (--map-around SEL)");
    blocks_ = empty() ? glm::ivec3(0) : (size_ - 2) / kBlock + 1;
}

void MapRegion::copyValues() {
    if (empty()) return;
    own_.resize(static_cast<std::size_t>(size_.x) * size_.y * size_.z);
    std::vector<int> xs(static_cast<std::size_t>(size_.x));
    for (int x = 0; x < size_.x; ++x) xs[static_cast<std::size_t>(x)] = wrappedNode(first_.x + x, map_.size.x);
    float* to = own_.data();
    for (int z = 0; z < size_.z; ++z)
        for (int y = 0; y < size_.y; ++y) {
            const float* row = map_.values.data() + map_.index({0, wrappedNode(first_.y + y, map_.size.y),
                                                                wrappedNode(first_.z + z, map_.size.z)});
            for (const int x : xs) *to++ = row[x];
        }
}

void MapRegion::findRanges() {
    if (empty()) return;
    ranges_.resize(static_cast<std::size_t>(blocks_.x) * blocks_.y * blocks_.z);
    const float* all = values();
    inParallel(static_cast<std::size_t>(blocks_.z), [&](std::size_t layer) {
        Range* range = ranges_.data() + layer * blocks_.y * blocks_.x;
        const int firstZ = static_cast<int>(layer) * kBlock, lastZ = std::min(firstZ + kBlock, size_.z - 1);
        for (int by = 0; by < blocks_.y; ++by)
            for (int bx = 0; bx < blocks_.x; ++bx, ++range) {
                *range = {INFINITY, -INFINITY};
                const int lastY = std::min((by + 1) * kBlock, size_.y - 1),
                          lastX = std::min((bx + 1) * kBlock, size_.x - 1);
                for (int z = firstZ; z <= lastZ; ++z)
                    for (int y = by * kBlock; y <= lastY; ++y) {
                        const float* row = all + (static_cast<std::size_t>(z) * size_.y + y) * size_.x;
                        for (int x = bx * kBlock; x <= lastX; ++x) {
                            range->low = row[x] < range->low ? row[x] : range->low;  // NaN compares false
                            range->high = row[x] > range->high ? row[x] : range->high;
                        }
                    }
            }
    });
}

Isosurface MapRegion::at(double level, bool above, IsosurfaceParts parts, const glm::dvec3& origin) const {
    Isosurface all;
    if (empty()) return all;
    std::vector<Isosurface> slabs(static_cast<std::size_t>(blocks_.z));
    std::atomic<std::size_t> triangles{0}, lines{0};
    inParallel(slabs.size(), [&](std::size_t layer) {
        if (triangles > kMostIsoTriangles || lines > kMostIsoLines) return;
        slabs[layer] =
            IsosurfaceSlab(*this, static_cast<float>(level), above, parts, origin).cut(static_cast<int>(layer));
        triangles += slabs[layer].triangles.size();
        lines += slabs[layer].lines.size();
    });
    if (triangles > kMostIsoTriangles || lines > kMostIsoLines)
        throw Error("cannot draw map", map_.name,
                    "at this level it has more than " +
                        std::to_string((lines > kMostIsoLines ? kMostIsoLines : kMostIsoTriangles) / 1'000'000) +
                        " million " + (lines > kMostIsoLines ? "lines" : "triangles") +
                        " (a higher --map-level, or --map-around SEL)");
    all.triangles.reserve(triangles);
    all.lines.reserve(lines);
    for (Isosurface& slab : slabs) {
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), slab.positions.begin(), slab.positions.end());
        all.normals.insert(all.normals.end(), slab.normals.begin(), slab.normals.end());
        for (const glm::uvec3& t : slab.triangles) all.triangles.push_back(t + first);
        for (const glm::uvec2& line : slab.lines) all.lines.push_back(line + first);
        slab = {};
    }
    if (places_.empty()) return all;
    std::vector<glm::dvec3> places;
    for (const glm::dvec3& place : places_) places.push_back(place - origin);
    carve(all, places, reach_);
    return all;
}

}  // namespace nacre
