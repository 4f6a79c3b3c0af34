#include "engine/software/triangle_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/simd/lanes.h"
#include "engine/simd/processor_lanes.h"
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace nacre {

TriangleLens::TriangleLens(const TileView& view)
    : width(view.width),
      height(view.height),
      perspective(view.perspective),
      frontsOnly(view.frontsOnly),
      axisX(view.axis.x),
      axisY(view.axis.y),
      clips(view.clips()),
      clipNear(view.clipNear),
      clipFar(view.clipFar) {
    // Rounding is relative: u = 2^-24. With the range P in pixels, no corner is farther than P / 2 from the axis. For a
    // corner's position the host rounds each of three coefficients, products and sums once: 2.5 u P; a shader 2 u P.
    // Coordinates relative to the picture's corner add u times the picture's size, a pixel's ray 4 u times its distance
    // from the axis, perspective 8 u times that: the 16 u that findPlanes() adds cover the latter two. This is 8.4 u P,
    // or 2.5 u times the picture, of which at most 2.4 are needed.
    const float picture = std::max({static_cast<float>(std::max(width, height)), std::abs(axisX), std::abs(axisY)});
    error = 5e-7f * std::max(view.range * view.pixels, 0.3f * picture);
    errorOfZ = 1e-6f * std::max(view.range, view.origin);
}

CornerPlace::CornerPlace(const TileView& view, const glm::vec4* rows)
    : z(rows[2]), axisX(view.axis.x), axisY(view.axis.y), origin(view.origin), perspective(view.perspective) {
    // As toPixel().
    const glm::vec4 right = rows[0] * view.pixels, up = rows[1] * view.pixels;
    const glm::vec4 turned[4][2] = {{right, -up}, {up, right}, {-right, up}, {-up, -right}};
    x = turned[view.quarterTurns & 3][0];
    y = turned[view.quarterTurns & 3][1];
}

glm::vec4 CornerPlace::operator()(const glm::vec3& p) const {
    const float Z = origin - (z.x * p.x + z.y * p.y + z.z * p.z + z.w);
    const float scale = perspective ? origin / Z : 1.0f;
    return {axisX + (x.x * p.x + x.y * p.y + x.z * p.z + x.w) * scale,
            axisY + (y.x * p.x + y.y * p.y + y.z * p.z + y.w) * scale, Z, 0};
}

void TriangleBand::beginRow(std::int32_t y) const {
    const std::size_t at = static_cast<std::size_t>(y) * pitch;
    rows[y] = 1;
    for (float* plane : {behind, before}) std::fill_n(plane + at, pitch, -std::numeric_limits<float>::max());
    std::fill_n(index + at, pitch, kNone);
}

void TriangleBand::doubt(std::uint32_t triangle) const {
    if (ambiguous->empty() || ambiguous->back() != triangle) ambiguous->push_back(triangle);
}

/// Draws a triangle that certainly contains the centre, between two keys, and is not certainly hidden.
void TriangleBand::meet(std::size_t at, float ofBehind, float ofBefore, std::uint32_t triangle) const {
    if (ofBefore < behind[at]) return;
    const bool wins = ofBehind > before[at];
    const bool nearer = ofBehind + ofBefore > behind[at] + before[at];
    if (!wins) doubt(nearer ? index[at] : triangle);
    if (!wins && !nearer) return;
    behind[at] = ofBehind;
    before[at] = ofBefore;
    index[at] = triangle;
}

void TriangleBand::hold(const TriangleShapes& shapes, std::uint32_t i, std::uint32_t triangle, std::size_t at,
                        float key, bool certain) const {
    const float error = shapes.error[i];
    if (lens->clips && (shapes.splinters >> i & 1) == 0) {
        const float least = key - error, Z = lens->perspective ? 1.0f / least : -least;
        const float room = lens->perspective ? error * Z * Z : error;
        if (Z + room < lens->clipNear || Z - room > lens->clipFar) return;
        if (Z - room <= lens->clipNear || Z + room >= lens->clipFar) certain = false;
    }
    if (certain)
        meet(at, key - 2 * error, key, triangle);
    else
        doubt(triangle);
}

namespace triangle_lanes {

#define NACRE_LANES_CODE "engine/software/triangle_lanes.inc"
#include "engine/simd/each_lanes.inc"

}  // namespace triangle_lanes

std::span<const TriangleLanes> triangleLanes() {
    using namespace triangle_lanes;
    static constexpr TriangleLanes kLaneTable[] = {
        {4, lanes4::drawTriangles, lanes4::placeCorners},
#if defined(__x86_64__)
        {8, lanes8::drawTriangles, lanes8::placeCorners},
#endif
    };
    return usableLanes<TriangleLanes>(kLaneTable);
}

}  // namespace nacre
