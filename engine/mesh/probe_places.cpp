#include "engine/mesh/probe_places.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <numbers>
#include <utility>

#include "engine/mesh/unit_vectors.h"
#include "engine/threads.h"

namespace nacre {
namespace {

using glm::dvec3;

/// Part of a circle that a ball covers.
struct CoveredArc {
    double begin = 0, end = 0;
    std::uint32_t by = 0;
};

}  // namespace

/// Circles of each ball with those of higher numbers, and the ends of their arcs.
ProbePlaces::ProbePlaces(const std::vector<SurfaceBall>& balls, double probe)
    : balls_(balls), probe_(probe), grid_(balls, probe) {
    struct Found {
        std::vector<ProbeCircle> circles;
        std::vector<ProbePoint> points;
    };
    open_.assign(balls_.size(), 0);
    std::vector<Found> found((balls_.size() + kTogether - 1) / kTogether);
    std::vector<std::atomic<char>> open(balls_.size());
    inParallel(found.size(), [&](std::size_t part) {
        const std::size_t end = std::min(balls_.size(), (part + 1) * kTogether);
        for (std::size_t a = part * kTogether; a < end; ++a) {
            const auto neighbours = grid_.neighbours(static_cast<std::uint32_t>(a));
            for (const std::uint32_t b : neighbours) {
                if (b < a) continue;
                ProbeCircle circle;
                if (!circleOf(static_cast<std::uint32_t>(a), b, circle)) continue;
                if (!openArcs(circle, found[part].points)) continue;
                open[a] = open[b] = 1;
                found[part].circles.push_back(std::move(circle));
            }
        }
    });
    for (std::uint32_t i = 0; i < balls_.size(); ++i) open_[i] = open[i] || isAlone(i);
    for (Found& part : found) {
        std::move(part.circles.begin(), part.circles.end(), std::back_inserter(circles_));
        points_.insert(points_.end(), part.points.begin(), part.points.end());
    }
}

/// For a ball without open circles: whether it is fully open, not covered.
bool ProbePlaces::isAlone(std::uint32_t ball) const {
    const dvec3 place = balls_[ball].center + dvec3(0, 0, reachOf(ball));
    const auto neighbours = grid_.neighbours(ball);
    return std::none_of(neighbours.begin(), neighbours.end(), [&](auto other) { return covers(other, place); });
}

/// False if the spheres do not meet.
bool ProbePlaces::circleOf(std::uint32_t a, std::uint32_t b, ProbeCircle& circle) const {
    const dvec3 way = balls_[b].center - balls_[a].center;
    const double distance = glm::length(way), ra = reachOf(a), rb = reachOf(b);
    if (distance < kTouch) return false;
    const double height = (distance * distance + ra * ra - rb * rb) / (2 * distance);
    const double squared = ra * ra - height * height;
    if (squared <= kTouch) return false;
    circle.a = a;
    circle.b = b;
    circle.axis = way / distance;
    circle.center = balls_[a].center + circle.axis * height;
    circle.radius = std::sqrt(squared);
    circle.x = anyAcross(circle.axis);
    circle.y = glm::cross(circle.axis, circle.x);
    return true;
}

/// Arcs that no third ball covers. Adds their ends, which are found on all three circles, or on fewer if more than
/// three spheres meet numerically. @return false if nothing is open
bool ProbePlaces::openArcs(ProbeCircle& circle, std::vector<ProbePoint>& points) const {
    constexpr double kTurn = 2 * std::numbers::pi;
    std::vector<CoveredArc> covered;
    for (const std::uint32_t other : grid_.neighbours(circle.a)) {
        if (other == circle.b) continue;
        const dvec3 way = balls_[other].center - circle.center;
        const double x = glm::dot(way, circle.x), y = glm::dot(way, circle.y), reach = reachOf(other);
        const double most = std::hypot(x, y);
        const double least = (glm::dot(way, way) + circle.radius * circle.radius - reach * reach) / (2 * circle.radius);
        if (least >= most - kTouch) continue;
        if (least <= -most) return false;
        const double middle = std::atan2(y, x), half = std::acos(std::clamp(least / most, -1.0, 1.0));
        double begin = middle - half;
        if (begin < 0) begin += kTurn;
        covered.push_back({begin, begin + 2 * half, other});
    }
    if (covered.empty()) {
        circle.arcs.push_back({0, kTurn});
        return true;
    }
    std::sort(covered.begin(), covered.end(),
              [](const CoveredArc& a, const CoveredArc& b) { return a.begin < b.begin; });
    // Behind the one that reaches farthest over the end of the turn.
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < covered.size(); ++i)
        if (covered[i].end > covered[farthest].end) farthest = i;
    double end = covered[farthest].end - kTurn;
    std::uint32_t by = covered[farthest].by;
    for (const CoveredArc& arc : covered) {
        if (arc.begin > end) {
            circle.arcs.push_back({end, arc.begin});
            points.push_back({circle.a, circle.b, by, circle.at(end)});
            points.push_back({circle.a, circle.b, arc.by, circle.at(arc.begin)});
        }
        if (arc.end > end) end = arc.end, by = arc.by;
    }
    return !circle.arcs.empty();
}

}  // namespace nacre
