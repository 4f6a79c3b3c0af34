#include "engine/occlusion/mesh_heights.h"

#include <algorithm>
#include <cstring>

namespace nacre::occlusion {
namespace {

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

/// Four pixels side by side.
constexpr int kWide = 4;
using Wide = float __attribute__((vector_size(kWide * sizeof(float))));

/// Keeps the larger of heights and those of a triangle where it covers pixels' centres. @param x  of the centres
void cover(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const Wide& x, float y, float* heights) {
    const Wide ax = a.x - x, bx = b.x - x, cx = c.x - x;
    const float ay = a.y - y, by = b.y - y, cy = c.y - y;
    // Twice the area between the centre and an edge: equal for both triangles of an edge except for the sign.
    const Wide ofA = bx * cy - by * cx, ofB = cx * ay - cy * ax, ofC = ax * by - ay * bx;
    const Wide sum = ofA + ofB + ofC;
    const Wide height = (ofA * a.z + ofB * b.z + ofC * c.z) / sum;
    Wide there;
    std::memcpy(&there, heights, sizeof there);
    const auto inside = (((ofA >= 0) & (ofB >= 0) & (ofC >= 0)) | ((ofA <= 0) & (ofB <= 0) & (ofC <= 0))) & (sum != 0);
    there = (inside & (height > there)) ? height : there;
    std::memcpy(heights, &there, sizeof there);
}

/// @param fronts  only one that is seen from its front
void drawTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, bool fronts, const HeightMap& map) {
    // Rows run downwards, so a front turns clockwise. One that is seen from its edge is drawn, whatever rounding does.
    constexpr float kEdge = 1e-3f;
    if (fronts && (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > kEdge) return;
    const Range x(std::min(a.x, std::min(b.x, c.x)), std::max(a.x, std::max(b.x, c.x)), map.pixels);
    if (x.first >= x.end) return;
    const Range y(std::min(a.y, std::min(b.y, c.y)), std::max(a.y, std::max(b.y, c.y)), map.pixels);
    for (int row = y.first; row < y.end; ++row)
        for (int column = x.first; column < x.end; column += kWide) {
            // Of this map alone: its neighbour may be another thread's.
            const int from = std::min(column, static_cast<int>(map.pixels) - kWide);
            const float middle = static_cast<float>(from) + 0.5f;
            cover(a, b, c, Wide{middle, middle + 1, middle + 2, middle + 3}, static_cast<float>(row) + 0.5f,
                  map.heights + static_cast<std::ptrdiff_t>(row) * map.pitch + from);
        }
}

}  // namespace

void MeshHeights::draw(const OccluderMesh& mesh, std::size_t first, std::size_t end, const glm::vec4* rows,
                       const HeightMap& map) {
    corners_.resize(std::max(corners_.size(), mesh.positions.size()));
    const float middle = static_cast<float>(map.pixels) / 2;
    const glm::vec4 x = rows[0] * map.perAngstrom, y = rows[1] * -map.perAngstrom, z = rows[2];
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 p = mesh.positions[i];
        corners_[i] = {middle + (x.x * p.x + x.y * p.y + x.z * p.z + x.w),
                       middle + (y.x * p.x + y.y * p.y + y.z * p.z + y.w), z.x * p.x + z.y * p.y + z.z * p.z + z.w};
    }
    for (const glm::uvec3& t : std::span(mesh.triangles).subspan(first, end - first))
        drawTriangle(corners_[t.x], corners_[t.y], corners_[t.z], mesh.closed, map);
}

}  // namespace nacre::occlusion
