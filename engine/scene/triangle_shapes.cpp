#include "engine/scene/triangle_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/scene/lanes.h"

namespace nacre {

TriangleLens::TriangleLens(const TileView& view)
    : width(view.width),
      height(view.height),
      perspective(view.perspective),
      axisX(view.axis.x),
      axisY(view.axis.y),
      clips(view.clipNear > -1e29f || view.clipFar < 1e29f),
      clipNear(view.clipNear),
      clipFar(view.clipFar) {
    // A number is rounded by u = 2^-24 of itself, and with P, the range in pixels, no corner is farther than P / 2 from
    // the axis. To place one there the host rounds each of three coefficients, products and sums once: 2.5 u P; a
    // shader 2 u P. To count from the picture's corner takes u times the picture's size, the ray of a pixel 4 u times
    // its way from the axis, perspective 8 u times that: the latter two are in what TriangleBounds adds, 16 u. This
    // is 8.4 u P, or 2.5 u times the picture, of which then no more than 2.4 are needed.
    const float picture = std::max({static_cast<float>(std::max(width, height)), std::abs(axisX), std::abs(axisY)});
    error = 5e-7f * std::max(view.range * view.pixels, 0.3f * picture);
    errorOfZ = 1e-6f * std::max(view.range, view.origin);
}

void TriangleShapes::place(const TriangleLens& lens, const Triangle* triangles, std::uint32_t count,
                           const glm::vec4* corners) {
    constexpr float kRoom = 1.0f / 32;
    const Lanes none{}, width = none + static_cast<float>(lens.width), height = none + static_cast<float>(lens.height);
    // Whole numbers are cut off towards 0, where the picture begins.
    const auto pixelAt = [&](Lanes place, Lanes size) {
        return __builtin_convertvector(lesser(greater(place, none), size), Mask);
    };
    for (std::uint32_t first = 0; first < count; first += kLanes) {
        const Triangle* four[kLanes];
        for (std::uint32_t i = 0; i < kLanes; ++i) four[i] = &triangles[std::min(first + i, count - 1)];
        const auto points = [&](std::uint32_t Triangle::*corner) {
            const auto at = [&](const Triangle& t) { return loadLanes(&corners[t.*corner].x); };
            return LanePoints(at(*four[0]), at(*four[1]), at(*four[2]), at(*four[3]));
        };
        const LanePoints a = points(&Triangle::a), b = points(&Triangle::b), c = points(&Triangle::c);
        const Lanes twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        const Mask turns = twice < none;
        const auto store = [&](Row<float>* of, Lanes ofA, Lanes ofB, Lanes ofC) {
            storeLanes(ofA, &of[0][first]);
            storeLanes(turns ? ofC : ofB, &of[1][first]);
            storeLanes(turns ? ofB : ofC, &of[2][first]);
        };
        store(x, a.x, b.x, c.x);
        store(y, a.y, b.y, c.y);
        store(z, a.z, b.z, c.z);
        storeLanes(turns ? -twice : twice, &area[first]);
        storeLanes(~turns, &turnedAway[first]);  // rows run downwards
        storeLanes(lesser(a.z, lesser(b.z, c.z)), &nearest[first]);
        storeLanes(pixelAt(lesser(a.x, lesser(b.x, c.x)) + (0.5f - kRoom), width), &left[first]);
        storeLanes(pixelAt(greater(a.x, greater(b.x, c.x)) + (0.5f + kRoom), width), &right[first]);
        storeLanes(pixelAt(lesser(a.y, lesser(b.y, c.y)) + (0.5f - kRoom), height), &top[first]);
        storeLanes(pixelAt(greater(a.y, greater(b.y, c.y)) + (0.5f + kRoom), height), &bottom[first]);
    }
}

TriangleBounds::TriangleBounds(const TriangleLens& lens, const TriangleShapes& s, std::uint32_t i) {
    float off = 0;
    for (int k = 0; k < 3; ++k) {
        off = std::max({off, std::abs(s.x[k][i] - lens.axisX), std::abs(s.y[k][i] - lens.axisY)});
        key[k] = lens.keyOf(s.z[k][i]);
    }
    const auto length = [&](int from, int to) {
        return std::abs(s.x[to][i] - s.x[from][i]) + std::abs(s.y[to][i] - s.y[from][i]);
    };
    const float rounded = lens.error + 1e-6f * off;
    const float ab = length(0, 1), bc = length(1, 2), ca = length(2, 0), around = ab + bc + ca;
    room[0] = 2 * rounded * bc;
    room[1] = 2 * rounded * ca;
    room[2] = 2 * rounded * ab;
    splinter = s.area[i] < 16 * rounded * around;
    perArea = 1 / s.area[i];
    const float nearest = std::max({key[0], key[1], key[2]});
    const float rise = nearest - std::min({key[0], key[1], key[2]});
    // A key may be off by as much as it rises on the way that a corner is off, and by what Z is rounded.
    error = splinter ? std::numeric_limits<float>::infinity()
                     : 4 * rounded * rise * around * perArea + lens.errorOfKey(nearest);
}

}  // namespace nacre
