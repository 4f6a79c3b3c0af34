#include "engine/mesh/probe_places.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <compare>
#include <glm/common.hpp>
#include <iterator>
#include <utility>

#include "engine/mesh/unit_vectors.h"
#include "engine/threads.h"

namespace nacre {
namespace {

using glm::dvec3;

constexpr ProbeBox kEmpty{dvec3(1e30), dvec3(-1e30)};

void include(ProbeBox& box, const dvec3& place) {
    box[0] = glm::min(box[0], place);
    box[1] = glm::max(box[1], place);
}

/// Bits of the sectors of a turn that lie within a part of it.
std::uint32_t sectorsWithin(double begin, double end) {
    constexpr int kSectors = 32;
    const int first = static_cast<int>(begin * kSectors / OpenArc::kTurn) + 1;
    const int count = std::min(static_cast<int>(end * kSectors / OpenArc::kTurn) - first, kSectors);
    if (count <= 0) return 0;
    const std::uint64_t bits = ((std::uint64_t{1} << count) - 1) << first % kSectors;
    return static_cast<std::uint32_t>(bits | bits >> kSectors);
}

}  // namespace

/// Circles of each ball with balls of higher numbers, and the ends of their arcs.
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
        std::vector<CoveredArc> covered;
        for (std::size_t a = part * kTogether; a < end; ++a) {
            const auto neighbours = grid_.neighbours(static_cast<std::uint32_t>(a));
            for (const std::uint32_t b : neighbours) {
                if (b < a) continue;
                ProbeCircle circle;
                if (!findCircle(static_cast<std::uint32_t>(a), b, circle)) continue;
                if (!openArcs(circle, covered, found[part].points)) continue;
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
    dropRepeated();
}

bool ProbePlaces::isCovered(std::uint32_t ball, const dvec3& place) const {
    const auto neighbours = grid_.neighbours(ball);
    return std::any_of(neighbours.begin(), neighbours.end(), [&](auto other) { return covers(other, place); });
}

/// Merges duplicates: a point where three spheres meet is found on each of their circles.
void ProbePlaces::dropRepeated() {
    struct Balls {
        std::array<std::uint32_t, 3> sorted;
        std::uint32_t point;
        auto operator<=>(const Balls&) const = default;
    };
    std::vector<Balls> balls;
    for (const ProbePoint& point : points_) {
        balls.push_back({{point.a, point.b, point.c}, static_cast<std::uint32_t>(balls.size())});
        std::sort(balls.back().sorted.begin(), balls.back().sorted.end());
    }
    std::sort(balls.begin(), balls.end());
    std::vector<char> repeated(points_.size(), 0);
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t k = i + 1; k < balls.size() && balls[k].sorted == balls[i].sorted; ++k)
            if (glm::distance(points_[balls[i].point].place, points_[balls[k].point].place) < kSame)
                repeated[balls[k].point] = 1;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points_.size(); ++i)
        if (!repeated[i]) points_[kept++] = points_[i];
    points_.resize(kept);
}

/// Whether a ball without open circles is fully open rather than fully covered.
bool ProbePlaces::isAlone(std::uint32_t ball) const {
    return !isCovered(ball, balls_[ball].center + dvec3(0, 0, reachRadius(ball)));
}

/// The extreme points along an axis are the ends of an arc, or the circle's own extreme point.
ProbeBox ProbePlaces::boundingBox(const ProbeCircle& circle) {
    ProbeBox box = kEmpty;
    for (const OpenArc& arc : circle.arcs) {
        include(box, circle.at(arc.begin));
        include(box, circle.at(arc.end));
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec2 way(circle.x[axis], circle.y[axis]);
            const double length = glm::length(way);
            if (length < kTouch) continue;
            if (arc.holds(way)) include(box, circle.at(way / length));
            if (arc.holds(-way)) include(box, circle.at(-way / length));
        }
    }
    return box;
}

/// The extreme points along an axis are on its border, which consists of arcs, or at the sphere's poles.
std::vector<ProbeBox> ProbePlaces::openBoxes() const {
    std::vector<ProbeBox> boxes(balls_.size(), kEmpty);
    for (const ProbeCircle& circle : circles_)
        for (const dvec3& corner : boundingBox(circle)) {
            include(boxes[circle.a], corner);
            include(boxes[circle.b], corner);
        }
    inParallel((balls_.size() + kTogether - 1) / kTogether, [&](std::size_t part) {
        const auto end = static_cast<std::uint32_t>(std::min(balls_.size(), (part + 1) * kTogether));
        for (auto ball = static_cast<std::uint32_t>(part * kTogether); ball < end; ++ball)
            for (int pole = 0; isOpen(ball) && pole < 6; ++pole) {
                dvec3 place = balls_[ball].center;
                place[pole / 2] += pole % 2 ? reachRadius(ball) : -reachRadius(ball);
                if (!isCovered(ball, place)) include(boxes[ball], place);
            }
    });
    return boxes;
}

/// The circle where two spheres meet. @returns false if they do not
bool ProbePlaces::findCircle(std::uint32_t a, std::uint32_t b, ProbeCircle& circle) const {
    const dvec3 way = balls_[b].center - balls_[a].center;
    const double distance = glm::length(way), ra = reachRadius(a), rb = reachRadius(b);
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

/// Parts of a circle that third balls cover. @return false if certainly nothing is left
bool ProbePlaces::coveredArcs(const ProbeCircle& circle, std::vector<CoveredArc>& covered) const {
    covered.clear();
    std::uint32_t sectors = 0;
    for (const std::uint32_t other : grid_.neighbours(circle.a)) {
        if (other == circle.b) continue;
        const dvec3 way = balls_[other].center - circle.center;
        const double reach = reachRadius(other);
        const double least = (glm::dot(way, way) + circle.radius * circle.radius - reach * reach) / (2 * circle.radius);
        const glm::dvec2 towards(glm::dot(way, circle.x), glm::dot(way, circle.y));
        const double squared = glm::dot(towards, towards);
        if (least + kTouch > 0 && (least + kTouch) * (least + kTouch) >= squared) continue;
        if (least <= 0 && least * least >= squared) return false;
        // The ends: directions at half the covered angle on either side of the ball's direction.
        const double most = std::sqrt(squared), cosine = least / most;
        const double sine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
        const glm::dvec2 along = towards * (cosine / most), aside = glm::dvec2(-towards.y, towards.x) * (sine / most);
        CoveredArc arc{0, 0, along - aside, along + aside, other};
        arc.begin = OpenArc::turnTo(arc.beginWay);
        arc.end = OpenArc::turnTo(arc.endWay);
        if (arc.end < arc.begin) arc.end += OpenArc::kTurn;
        if (cosine < 0 && arc.end - arc.begin < OpenArc::kTurn / 4) return false;  // all covered, up to rounding
        covered.push_back(arc);
        sectors |= sectorsWithin(arc.begin, arc.end);
        if (~sectors == 0) return false;
    }
    return true;
}

/// Finds arcs that no third ball covers, and adds their ends. Each end is found on all three circles, or on fewer if
/// more than three spheres meet numerically. @param covered  scratch @return false if nothing is open
bool ProbePlaces::openArcs(ProbeCircle& circle, std::vector<CoveredArc>& covered,
                           std::vector<ProbePoint>& points) const {
    if (!coveredArcs(circle, covered)) return false;
    if (covered.empty()) {
        circle.arcs.emplace_back();
        return true;
    }
    std::sort(covered.begin(), covered.end(),
              [](const CoveredArc& a, const CoveredArc& b) { return a.begin < b.begin; });
    // Start after the arc that reaches farthest past the end of the turn.
    const CoveredArc* last = &covered[0];
    for (const CoveredArc& arc : covered)
        if (arc.end > last->end) last = &arc;
    double end = last->end - OpenArc::kTurn;
    for (const CoveredArc& arc : covered) {
        if (arc.begin > end) {
            circle.arcs.push_back({last->endWay, arc.beginWay, arc.begin - end});
            points.push_back({circle.a, circle.b, last->by, circle.at(last->endWay)});
            points.push_back({circle.a, circle.b, arc.by, circle.at(arc.beginWay)});
        }
        if (arc.end > end) end = arc.end, last = &arc;
    }
    return !circle.arcs.empty();
}

}  // namespace nacre
