#include "engine/occlusion/mesh_heights.h"

#include <algorithm>
#include <glm/common.hpp>

namespace nacre::occlusion {
namespace {

/// Twice the area between the origin and an edge: equal for both triangles of an edge except for the sign.
float sideOf(const glm::vec3& from, const glm::vec3& to) { return from.x * to.y - from.y * to.x; }

/// Pixels whose centres may lie between two coordinates.
struct Range {
    int first, end;
    Range(float low, float high, std::uint32_t pixels) {
        // Some of a pixel more, which the edges decide. Whole numbers are cut off towards 0, so below 0 nothing is
        // lost.
        constexpr float kRoom = 1.0f / 64;
        const auto across = static_cast<float>(pixels);
        first = static_cast<int>(std::clamp(low + (0.5f - kRoom), 0.0f, across));
        end = static_cast<int>(std::clamp(high + (0.5f + kRoom), 0.0f, across));
    }
};

/// @param fronts  only one that is seen from its front
void drawTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, bool fronts, const HeightMap& map) {
    // Rows run downwards, so a front turns clockwise. One that is seen from its edge is drawn, whatever rounding does.
    constexpr float kEdge = 1e-3f;
    if (fronts && (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > kEdge) return;
    const Range x(std::min(a.x, std::min(b.x, c.x)), std::max(a.x, std::max(b.x, c.x)), map.pixels);
    if (x.first >= x.end) return;
    const Range y(std::min(a.y, std::min(b.y, c.y)), std::max(a.y, std::max(b.y, c.y)), map.pixels);
    for (int row = y.first; row < y.end; ++row)
        for (int column = x.first; column < x.end; ++column) {
            const glm::vec3 pixel(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f, 0);
            const glm::vec3 pa = a - pixel, pb = b - pixel, pc = c - pixel;
            const float ofA = sideOf(pb, pc), ofB = sideOf(pc, pa), ofC = sideOf(pa, pb);
            const bool inside = std::min(ofA, std::min(ofB, ofC)) >= 0 || std::max(ofA, std::max(ofB, ofC)) <= 0;
            const float sum = ofA + ofB + ofC;
            if (!inside || sum == 0) continue;
            float& height = map.heights[static_cast<std::size_t>(row) * map.pitch + static_cast<std::size_t>(column)];
            height = std::max(height, (ofA * a.z + ofB * b.z + ofC * c.z) / sum);
        }
}

}  // namespace

/// Where the vertices of some triangles stand; all of them are in the same step.
void MeshHeights::place(const Representation& r, std::span<const Triangle> triangles, const glm::vec4* rows,
                        const HeightMap& map) {
    std::uint32_t first = UINT32_MAX, end = 0;
    for (const Triangle& t : triangles) {
        first = std::min({first, t.a, t.b, t.c});
        end = std::max({end, t.a + 1, t.b + 1, t.c + 1});
    }
    corners_.resize(std::max<std::size_t>(corners_.size(), end));
    const float step = triangles.front().step, middle = static_cast<float>(map.pixels) / 2;
    const glm::vec4 x = rows[0] * map.perAngstrom, y = rows[1] * -map.perAngstrom, z = rows[2];
    for (std::uint32_t i = first; i < end; ++i) {
        const glm::vec3 p = positionOf(r.meshVertices[i], step);
        corners_[i] = {middle + (x.x * p.x + x.y * p.y + x.z * p.z + x.w),
                       middle + (y.x * p.x + y.y * p.y + y.z * p.z + y.w), z.x * p.x + z.y * p.y + z.z * p.z + z.w};
    }
}

/// A number for each directed edge is added where it is met, and subtracted where it is met the other way.
bool isClosed(std::span<const Triangle> triangles) {
    const auto mixed = [](std::uint64_t from, std::uint64_t to) {  // the finaliser of splitmix64
        std::uint64_t x = (from << 32 | to) + 0x9e3779b97f4a7c15u;
        x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
        x = (x ^ x >> 27) * 0x94d049bb133111ebu;
        return x ^ x >> 31;
    };
    std::uint64_t sum = 0;
    const auto add = [&](std::uint32_t from, std::uint32_t to) { sum += mixed(from, to) - mixed(to, from); };
    for (const Triangle& t : triangles) {
        add(t.a, t.b);
        add(t.b, t.c);
        add(t.c, t.a);
    }
    return sum == 0;
}

std::span<const Triangle> trianglesOf(const Representation& r, std::uint32_t first, std::uint32_t count) {
    const std::size_t finest = r.triangles.size();
    return first < finest ? std::span(r.triangles).subspan(first, count)
                          : std::span(r.coarseTriangles).subspan(first - finest, count);
}

void MeshHeights::draw(const Representation& r, const glm::vec4* rows, const HeightRun& run, const HeightMap& map) {
    std::span<const Triangle> left = trianglesOf(r, run.first, run.count);
    while (!left.empty()) {
        std::size_t end = 0;
        // Triangles of one mesh stand together.
        while (end < left.size() && left[end].step == left[0].step) ++end;
        const std::span<const Triangle> triangles = left.first(end);
        place(r, triangles, rows, map);
        for (const Triangle& t : triangles) drawTriangle(corners_[t.a], corners_[t.b], corners_[t.c], run.closed, map);
        left = left.subspan(end);
    }
}

}  // namespace nacre::occlusion
