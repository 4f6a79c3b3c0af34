// Moves the molecule clear of title, legends, scale bar and axes in the picture's corners.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "app/annotation/room.h"

namespace nacre::app {
namespace {

constexpr std::size_t kHullSides = 32;

/// Convex hull of the drawn scene on the image plane, Å, y down, as extents in several directions.
struct Hull {
    glm::dvec2 middle{};
    std::array<double, kHullSides> reach{};
};

glm::dvec2 hullSide(std::size_t i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / kHullSides;
    return {std::cos(angle), std::sin(angle)};
}

Hull makeHull(const View& view, const std::vector<glm::dvec4>& balls) {
    std::array<glm::dvec2, kHullSides> sides;
    for (std::size_t i = 0; i < kHullSides; ++i) sides[i] = hullSide(i);
    Hull hull;
    hull.reach.fill(-std::numeric_limits<double>::infinity());
    for (const glm::dvec4& ball : balls) {
        const glm::dvec3 v = view.seen(glm::dvec3(ball));
        const bool perspective = view.projection == Projection::perspective;
        const double magnify = perspective ? view.eyeDistance / (view.eyeDistance - v.z) : 1;
        const glm::dvec2 at = glm::dvec2(v.x, -v.y) * magnify;
        const double radius = ball.w * magnify;
        for (std::size_t i = 0; i < kHullSides; ++i)
            hull.reach[i] = std::max(hull.reach[i], glm::dot(sides[i], at) + radius);
    }
    hull.middle = {(hull.reach[0] - hull.reach[kHullSides / 2]) / 2,
                   (hull.reach[kHullSides / 4] - hull.reach[3 * kHullSides / 4]) / 2};
    for (std::size_t i = 0; i < kHullSides; ++i)
        hull.reach[i] = std::max(hull.reach[i] - glm::dot(sides[i], hull.middle), 1e-6);
    return hull;
}

/// Largest scale, pixels per Å, at which a hull with its centre at a position does not overlap an area.
double scaleBeside(const Hull& hull, const glm::dvec2& at, const Area& area) {
    double most = 0;
    for (std::size_t i = 0; i < kHullSides; ++i) {
        const glm::dvec2 side = hullSide(i);
        const glm::dvec2 nearest(side.x > 0 ? area.low.x : area.high.x, side.y > 0 ? area.low.y : area.high.y);
        most = std::max(most, glm::dot(side, nearest - at) / hull.reach[i]);
    }
    return most;
}

double scaleBeside(const Hull& hull, const glm::dvec2& at, const std::vector<Area>& areas) {
    double most = std::numeric_limits<double>::infinity();
    for (const Area& area : areas) most = std::min(most, scaleBeside(hull, at, area));
    return most;
}

/// As above, for the picture's frame.
double scaleWithin(const Hull& hull, const glm::dvec2& at, const Area& frame) {
    return std::max(0.0,
                    std::min({(frame.high.x - at.x) / hull.reach[0], (frame.high.y - at.y) / hull.reach[kHullSides / 4],
                              (at.x - frame.low.x) / hull.reach[kHullSides / 2],
                              (at.y - frame.low.y) / hull.reach[3 * kHullSides / 4]}));
}

struct Standing {
    glm::dvec2 at{};
    double scale = 0, worth = -1;
};

/// The position with the largest scale, up to a limit; of nearly equal ones the nearest.
Standing bestPlace(const Hull& hull, const std::vector<Area>& areas, const Area& frame, const glm::dvec2& from,
                   double most) {
    // Fractions of the scale given up to avoid a horizontal or vertical shift: centred molecules look better.
    constexpr double kAside = 0.7, kAway = 0.1;
    const glm::dvec2 size = frame.high - frame.low;
    Standing best;
    const auto consider = [&](const glm::dvec2& at) {
        const double scale = std::min({most, scaleWithin(hull, at, frame), scaleBeside(hull, at, areas)});
        const glm::dvec2 away = glm::abs(at - from) / size;
        const double worth = scale * (1 - kAside * away.x - kAway * away.y);
        if (worth > best.worth) best = {at, scale, worth};
    };
    consider(from);
    constexpr int kSteps = 32;
    for (int j = 1; j < kSteps; ++j)
        for (int i = 1; i < kSteps; ++i) consider(frame.low + size * glm::dvec2(i, j) / double{kSteps});
    for (double step = 0.5 / kSteps; step > 1e-4; step /= 2) {
        const glm::dvec2 middle = best.at;
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) consider(middle + size * step * glm::dvec2(i, j));
    }
    return best;
}

}  // namespace

View besideWords(const View& view, const PlacedWords& words, double size, const std::vector<glm::dvec4>& balls,
                 double zoom, const TextWidth& measureWidth) {
    if (!words.hasBlocks() || balls.empty()) return view;
    const double em = size > 0 ? size : usualTextSize(view.width, view.height);
    const Hull hull = makeHull(view, balls);
    const glm::dvec2 middle(view.width / 2.0, view.height / 2.0), pan(view.pan.x, -view.pan.y);
    const double beyond = std::max(zoom, 1.0), usual = view.pixelsPerAngstrom / beyond;
    const glm::dvec2 from = middle + (hull.middle + pan) * usual;
    constexpr double kEdge = 0.02, kGap = 0.35, kLeast = 1.0 / 3;
    const double edge = kEdge * std::min(view.width, view.height);
    const Area frame{glm::dvec2(edge), 2.0 * middle - edge};
    View fitted = view;
    // The length of a scale bar changes with the scale, in steps.
    for (int turn = 0; turn < 3; ++turn) {
        Room room(fitted, em, measureWidth);
        layBlocks(room, words);
        for (Area& area : room.taken) area = area.grown(kGap * em);
        if (turn == 0 && scaleBeside(hull, from, room.taken) >= usual) return view;
        const Standing best = bestPlace(hull, room.taken, frame, from, usual);
        if (best.scale < kLeast * usual) return view;
        fitted.pixelsPerAngstrom = best.scale * beyond;
        const glm::dvec2 moved = (best.at - middle) / best.scale - hull.middle;
        fitted.pan = {moved.x, -moved.y};
    }
    return fitted;
}

}  // namespace nacre::app
