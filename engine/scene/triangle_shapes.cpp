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
      frontsOnly(view.frontsOnly),
      axisX(view.axis.x),
      axisY(view.axis.y),
      clips(view.clips()),
      clipNear(view.clipNear),
      clipFar(view.clipFar) {
    // Rounding is relative: u = 2^-24. With the range P in pixels, no corner is farther than P / 2 from the axis. For a
    // corner's position the host rounds each of three coefficients, products and sums once: 2.5 u P; a shader 2 u P.
    // Counting from the picture's corner adds u times the picture's size, a pixel's ray 4 u times its distance from the
    // axis, perspective 8 u times that: the latter two are in the 16 u that findPlanes() adds. This is 8.4 u P, or 2.5
    // u times the picture, of which at most 2.4 are needed.
    const float picture = std::max({static_cast<float>(std::max(width, height)), std::abs(axisX), std::abs(axisY)});
    error = 5e-7f * std::max(view.range * view.pixels, 0.3f * picture);
    errorOfZ = 1e-6f * std::max(view.range, view.origin);
}

void TriangleShapes::place(const TriangleLens& lens, const Triangle* triangles, std::uint32_t count,
                           const glm::vec4* corners) {
    for (std::uint32_t first = 0; first < count; first += kLanes) {
        const Triangle* four[kLanes];
        for (std::uint32_t i = 0; i < kLanes; ++i) four[i] = &triangles[std::min(first + i, count - 1)];
        const auto points = [&](std::uint32_t Triangle::*corner) {
            const auto at = [&](const Triangle& t) { return loadLanes(&corners[t.*corner].x); };
            return LanePoints(at(*four[0]), at(*four[1]), at(*four[2]), at(*four[3]));
        };
        placeFour(lens, points(&Triangle::a), points(&Triangle::b), points(&Triangle::c), first);
    }
}

namespace {

/// A triangle faces one way, whatever the rounding, from this much area over its outline and a corner's error on.
constexpr float kCertain = 16;

Lanes ofLeast(Lanes a, Lanes b, Lanes c) { return lesser(a, lesser(b, c)); }
Lanes ofMost(Lanes a, Lanes b, Lanes c) { return greater(a, greater(b, c)); }
Lanes farther(Lanes low, Lanes high, float axis) { return greater(high - axis, axis - low); }

/// Twice the area between an edge and a point, positive on one side.
struct LaneEdge {
    Lanes start, right, down, length;
    LaneEdge(Lanes fromX, Lanes fromY, Lanes toX, Lanes toY)
        : start(fromX * toY - fromY * toX), right(fromY - toY), down(toX - fromX) {
        length = greater(right, -right) + greater(down, -down);
    }
};

}  // namespace

NACRE_CLONED void TriangleShapes::placeFour(const TriangleLens& lens, LanePoints a, LanePoints b, LanePoints c,
                                            std::uint32_t first) {
    constexpr float kRoom = 1.0f / 32;
    const Lanes none{}, width = none + static_cast<float>(lens.width), height = none + static_cast<float>(lens.height);
    const Lanes twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const Mask turns = twice < none;
    const auto store = [&](Row<float>* of, Lanes ofA, Lanes ofB, Lanes ofC) {
        storeLanes(ofA, &of[0][first]);
        storeLanes(turns ? ofC : ofB, &of[1][first]);
        storeLanes(turns ? ofB : ofC, &of[2][first]);
    };
    store(x_, a.x, b.x, c.x);
    store(y_, a.y, b.y, c.y);
    store(z_, a.z, b.z, c.z);
    storeLanes(turns ? -twice : twice, &area_[first]);
    storeLanes(~turns, &turnedAway[first]);  // rows run downwards
    // Whole numbers are cut off towards 0, where the picture begins.
    const auto seen = [&](Lanes place, Lanes size) { return lesser(greater(place, none), size); };
    const auto pixelsOf = [&](Lanes place) { return __builtin_convertvector(place, Mask); };
    const Lanes lowX = ofLeast(a.x, b.x, c.x), highX = ofMost(a.x, b.x, c.x), lowY = ofLeast(a.y, b.y, c.y),
                highY = ofMost(a.y, b.y, c.y);
    Lanes leftmost = seen(lowX + (0.5f - kRoom), width), rightmost = seen(highX + (0.5f + kRoom), width),
          topmost = seen(lowY + (0.5f - kRoom), height), lowest = seen(highY + (0.5f + kRoom), height),
          Z = ofLeast(a.z, b.z, c.z);
    std::uint32_t turnedOff = 0;
    if (lens.frontsOnly) {
        const Lanes off = greater(farther(lowX, highX, lens.axisX), farther(lowY, highY, lens.axisY));
        const Mask away = twice > kCertain * lens.rounded(off) * 2 * (highX - lowX + highY - lowY);
        turnedOff = signsOf(away);
        leftmost = away ? width : leftmost;
        rightmost = away ? none : rightmost;
        topmost = away ? height : topmost;
        lowest = away ? none : lowest;
        Z = away ? none + std::numeric_limits<float>::max() : Z;
    }
    storeLanes(pixelsOf(leftmost), &left[first]);
    storeLanes(pixelsOf(rightmost), &right[first]);
    storeLanes(pixelsOf(topmost), &top[first]);
    storeLanes(pixelsOf(lowest), &bottom[first]);
    storeLanes(Z, &nearest[first]);
    const auto pixel = [](float place) { return static_cast<std::int32_t>(place); };
    boxes[first / kLanes] = {pixel(leastOf(leftmost)),
                             pixel(-leastOf(-rightmost)),
                             pixel(leastOf(topmost)),
                             pixel(-leastOf(-lowest)),
                             leastOf(Z),
                             turnedOff};
}

NACRE_CLONED void TriangleShapes::findPlanes(const TriangleLens& lens, std::uint32_t first) {
    const Lanes none{};
    const auto corner = [&](const Row<float>* of, int k) { return loadLanes(&of[k][first]); };
    const auto pixel = [&](const Row<std::int32_t>& of) { return loadLanes(&of[first]); };
    const Mask leftmost = pixel(left), topmost = pixel(top);
    const Lanes x = __builtin_convertvector(leftmost, Lanes) + 0.5f, y = __builtin_convertvector(topmost, Lanes) + 0.5f;
    const Lanes ax = corner(x_, 0) - x, bx = corner(x_, 1) - x, cx = corner(x_, 2) - x;
    const Lanes ay = corner(y_, 0) - y, by = corner(y_, 1) - y, cy = corner(y_, 2) - y;
    const LaneEdge edge[] = {{bx, by, cx, cy}, {cx, cy, ax, ay}, {ax, ay, bx, by}};
    const Lanes off = greater(farther(ofLeast(ax, bx, cx) + x, ofMost(ax, bx, cx) + x, lens.axisX),
                              farther(ofLeast(ay, by, cy) + y, ofMost(ay, by, cy) + y, lens.axisY));
    const Lanes area = loadLanes(&area_[first]), around = edge[0].length + edge[1].length + edge[2].length;
    const Lanes rounded = lens.rounded(off);
    const Mask narrow = ~(area > kCertain * rounded * around);
    storeLanes(narrow, &splinter[first]);
    Mask outside[4] = {};  // of the first pixels
    for (int k = 0; k < 3; ++k) {
        const Lanes room = 2 * rounded * edge[k].length, start = edge[k].start + room, below = start + edge[k].down;
        const Lanes at[] = {start, start + edge[k].right, below, below + edge[k].right};
        for (int i = 0; i < 4; ++i) outside[i] |= bitsOf(at[i]);
        storeLanes(start, &edges[k].start[first]);
        storeLanes(edge[k].right, &edges[k].right[first]);
        storeLanes(edge[k].down, &edges[k].down[first]);
        storeLanes(narrow ? none + std::numeric_limits<float>::infinity() : 2 * room, &inside[k][first]);
    }
    // Most triangles of a fold are as small as pixels, and lie between their centres.
    const Mask missed = (outside[0] & outside[1] & outside[2] & outside[3]) < 0;
    const Mask small = (pixel(right) - leftmost <= 2) & (pixel(bottom) - topmost <= 2);
    storeLanes(missed & small ? topmost : pixel(bottom), &bottom[first]);

    const auto keyAt = [&](Lanes Z) { return lens.perspective ? 1 / Z : -Z; };
    const Lanes ofA = keyAt(corner(z_, 0)), ofB = keyAt(corner(z_, 1)), ofC = keyAt(corner(z_, 2));
    const Lanes most = ofMost(ofA, ofB, ofC), rise = most - ofLeast(ofA, ofB, ofC), perArea = 1 / area;
    const Lanes errorOfMost = lens.perspective ? lens.errorOfZ * most * most : none + lens.errorOfZ;
    const auto mean = [&](Lanes LaneEdge::*of) {
        return (edge[1].*of * (ofB - ofA) + edge[2].*of * (ofC - ofA)) * perArea;
    };
    storeLanes(narrow ? most + errorOfMost : ofA + mean(&LaneEdge::start), &key.start[first]);
    storeLanes(narrow ? none : mean(&LaneEdge::right), &key.right[first]);
    storeLanes(narrow ? none : mean(&LaneEdge::down), &key.down[first]);
    // A key's error: its slope over a corner's error, plus the rounding of Z.
    storeLanes(narrow ? none : 4 * rounded * rise * around * perArea + errorOfMost, &error[first]);
}

}  // namespace nacre
