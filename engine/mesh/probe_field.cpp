#include "engine/mesh/probe_field.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/mesh/probe_places.h"
#include "engine/mesh/unit_vectors.h"

namespace nacre {
namespace {

using glm::dvec3;

constexpr double kSlack = 0.05;   // Å^2, tolerance between a circle's wedge and its neighbours
constexpr double kBorder = 0.05;  // Å, tolerance of boxes
constexpr double kTouch = 1e-6;   // Å^2: a node there is on a sphere
constexpr double kNowhere = 1e9;
constexpr float kDeepInside = 1e3f;  // for nodes far from all probe positions

class ProbeField : public SurfaceField {
public:
    ProbeField(const std::vector<SurfaceBall>& balls, double probe, double step)
        : balls_(balls),
          probe_(probe),
          reach_(probe + step * 1.001),
          outside_(probe < step * 1.001 ? step * 1.001 : 0),
          places_(balls, probe) {
        for (const SurfaceBall& ball : balls) widest_ = std::max(widest_, ball.radius);
        if (probe_ > 0) findBoxes();
    }

    std::vector<std::array<dvec3, 2>> reaches() const override {
        std::vector<std::array<dvec3, 2>> boxes;
        for (const SurfaceBall& ball : balls_) {
            const double reach = ball.radius + probe_ + outside_;
            boxes.push_back({ball.center - reach, ball.center + reach});
        }
        if (probe_ == 0) return boxes;
        boxes.insert(boxes.end(), ofCircles_.begin(), ofCircles_.end());
        for (const ProbePoint& point : places_.points()) boxes.push_back({point.place - reach_, point.place + reach_});
        return boxes;
    }

    void fill(const GridBlock& block, std::span<const std::uint32_t> sources, std::vector<float>& values,
              std::vector<std::uint32_t>& origins) const override {
        // First marks nodes inside a ball, then finds their distance to the outside.
        std::fill(values.begin(), values.end(), static_cast<float>(-probe_ - outside_));
        std::fill(origins.begin(), origins.end(), kNoSource);
        for (const std::uint32_t source : sources)
            if (source < balls_.size()) fillBall(block, source, values, origins);
        if (probe_ == 0) return;  // leave() needs no distance
        for (const std::uint32_t source : sources) {
            if (source < balls_.size()) {
                if (places_.isOpen(source)) nearBall(block, source, values, origins);
            } else if (source < balls_.size() + places_.circles().size()) {
                nearCircle(block, source, values, origins);
            } else {
                nearPoint(block, source, values, origins);
            }
        }
    }

    void cross(const GridBlock&, std::span<const std::uint32_t>, std::span<const GridCrossing> crossings,
               std::vector<SurfacePoint>& points) const override {
        for (const GridCrossing& c : crossings) points.push_back(crossOne(c.inside, c.outside));
    }

private:
    using Node = GridCrossing::Node;

    SurfacePoint crossOne(const Node& inside, const Node& outside) const {
        if (probe_ == 0) return leave(inside.place, outside.place);
        double a = 0, b = 1, atA = inside.value, atB = outside.value;
        Nearest nearest;
        dvec3 place{};
        for (int round = 0; round < 3; ++round) {
            const double share = std::clamp(a + (b - a) * (atA > atB ? atA / (atA - atB) : 0.5), 0.02, 0.98);
            place = inside.place + (outside.place - inside.place) * share;
            nearest = findNearest(inside.origin, place);
            if (outside.origin != inside.origin) nearest = nearer(nearest, findNearest(outside.origin, place));
            const double value = nearest.distance - probe_;
            if (value > 0)
                a = share, atA = value;
            else
                b = share, atB = value;
        }
        SurfacePoint point;
        point.place = place;
        const dvec3 outwards = unitOr(outside.place - inside.place, dvec3(0, 0, 1));
        point.normal = nearest.normal == dvec3() ? unitOr(nearest.place - place, outwards) : nearest.normal;
        point.atom = owner(inside.origin != kNoSource ? inside.origin : outside.origin, place);
        return point;
    }

    struct Nearest {
        dvec3 place{};
        dvec3 normal{};              ///< of a ball
        double distance = kNowhere;  ///< Å; negative outside of the balls
    };

    /// The nearer of two inside. A source whose ball does not contain the node tells nothing about the inside.
    static const Nearest& nearer(const Nearest& a, const Nearest& b) {
        if (a.distance == kNowhere || b.distance == kNowhere) return a.distance == kNowhere ? b : a;
        const bool first = a.distance < b.distance;
        return first == (std::min(a.distance, b.distance) >= 0) ? a : b;
    }

    /// The nearest probe position on one source, open or not.
    Nearest findNearest(std::uint32_t source, const dvec3& place) const {
        if (source == kNoSource) return {};
        dvec3 found;
        if (source < balls_.size()) {
            const SurfaceBall& ball = balls_[source];
            const double reach = ball.radius + probe_;
            found = ball.center + unitOr(place - ball.center, dvec3(0, 0, 1)) * reach;
            return {found, unitOr(place - ball.center, dvec3(0, 0, 1)), reach - glm::distance(place, ball.center)};
        } else if (source < balls_.size() + places_.circles().size()) {
            const ProbeCircle& circle = places_.circles()[source - balls_.size()];
            found = circle.center + unitOr(across(place - circle.center, circle.axis), circle.x) * circle.radius;
        } else {
            found = places_.points()[source - balls_.size() - places_.circles().size()].place;
        }
        return {found, {}, glm::distance(found, place)};
    }

    std::uint32_t owner(std::uint32_t source, const dvec3& place) const {
        if (source == kNoSource) return balls_[0].atom;
        if (source < balls_.size()) return balls_[source].atom;
        std::array<std::uint32_t, 3> of{};
        if (source < balls_.size() + places_.circles().size()) {
            const ProbeCircle& circle = places_.circles()[source - balls_.size()];
            of = {circle.a, circle.b, circle.b};
        } else {
            const ProbePoint& point = places_.points()[source - balls_.size() - places_.circles().size()];
            of = {point.a, point.b, point.c};
        }
        const auto height = [&](std::uint32_t ball) {
            return glm::distance(balls_[ball].center, place) - balls_[ball].radius;
        };
        return balls_[*std::ranges::min_element(of, [&](auto a, auto b) { return height(a) < height(b); })].atom;
    }

    /// Without a probe: the point where a line leaves the balls, which is exact.
    SurfacePoint leave(const dvec3& from, const dvec3& to) const {
        const dvec3 way = to - from;
        const BallExit exit = findExit(balls_, places_.grid(), widest_, from, way);
        const SurfaceBall& ball = balls_[exit.ball == kNoSource ? 0 : exit.ball];
        SurfacePoint point;
        point.place = from + way * std::clamp(exit.share, 0.0, 1.0);
        point.normal = unitOr(point.place - ball.center, unitOr(way, dvec3(0, 0, 1)));
        point.atom = ball.atom;
        return point;
    }

    /// Finds boxes of the nodes whose nearest probe position is on a ball's sphere or on a circle. Such nodes lie
    /// between that position and a ball's centre, and within reach_ of the position.
    void findBoxes() {
        ofBalls_ = places_.openBoxes();
        for (std::uint32_t i = 0; i < balls_.size(); ++i) {
            if (!places_.isOpen(i)) continue;
            const dvec3& center = balls_[i].center;
            const double least = std::max(1 - reach_ / places_.reachRadius(i), 0.0);
            const auto [low, high] = ofBalls_[i];
            ofBalls_[i] = {glm::min(low, center + (low - center) * least) - kBorder,
                           glm::max(high, center + (high - center) * least) + kBorder};
        }
        for (const ProbeCircle& circle : places_.circles()) {
            const auto [low, high] = ProbePlaces::boundingBox(circle);
            const dvec3 &a = balls_[circle.a].center, &b = balls_[circle.b].center;
            ofCircles_.push_back({glm::max(glm::min(glm::min(a, b), low), low - reach_) - kBorder,
                                  glm::min(glm::max(glm::max(a, b), high), high + reach_) + kBorder});
        }
    }

    /// Part of a row of nodes, Å from a source's centre.
    struct Span {
        double low = -1e9, high = 1e9;
        void clip(const Span& other) { low = std::max(low, other.low), high = std::min(high, other.high); }
    };
    static Span ofBall(double squaredReach, double squaredOff) {
        const double half = std::sqrt(std::max(squaredReach - squaredOff, 0.0));
        return squaredOff < squaredReach ? Span{-half, half} : Span{1, -1};
    }

    static int floorToInt(double value) {
        const int cut = static_cast<int>(value);
        return cut - (value < cut ? 1 : 0);
    }

    /// Visits nodes row by row. @param findSpan  part of a row to visit, by its y and z from the centre
    /// @param visitRow  first node's index and x, number of nodes, and y and z from the centre
    template <typename FindSpan, typename VisitRow>
    static void eachRow(const GridBlock& block, const NodeRange& range, const dvec3& center, const FindSpan& findSpan,
                        const VisitRow& visitRow) {
        const double perStep = 1 / block.step;
        for (int z = range.first.z; z <= range.last.z; ++z)
            for (int y = range.first.y; y <= range.last.y; ++y) {
                const double wayY = y * block.step - center.y, wayZ = z * block.step - center.z;
                const Span span = findSpan(wayY, wayZ);
                if (span.low > span.high) continue;
                const double low = (center.x + span.low) * perStep, high = (center.x + span.high) * perStep;
                const int first = low > range.first.x ? -floorToInt(-low) : range.first.x;
                const int last = high < range.last.x ? floorToInt(high) : range.last.x;
                if (first <= last) visitRow(block.index({first, y, z}), first, last - first + 1, wayY, wayZ);
            }
    }
    template <typename FindSpan, typename Visit>
    static void eachNode(const GridBlock& block, const NodeRange& range, const dvec3& center, const FindSpan& findSpan,
                         const Visit& visit) {
        eachRow(block, range, center, findSpan, [&](std::size_t i, int x, int count, double wayY, double wayZ) {
            for (const int end = x + count; x < end; ++x, ++i) visit(i, dvec3(x * block.step - center.x, wayY, wayZ));
        });
    }

    void fillBall(const GridBlock& block, std::uint32_t number, std::vector<float>& values,
                  std::vector<std::uint32_t>& origins) const {
        const dvec3& center = balls_[number].center;
        const double reach = places_.reachRadius(number), to = reach + outside_;
        const NodeRange range(block, center - to, center + to);
        const auto inside = [&](double y, double z) { return ofBall(reach * reach, y * y + z * z); };
        if (outside_ == 0)
            return eachRow(block, range, center, inside, [&](std::size_t i, int, int count, double, double) {
                std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(i), count, kDeepInside);
            });
        const auto within = [&](double y, double z) { return ofBall(to * to, y * y + z * z); };
        eachNode(block, range, center, within, [&](std::size_t i, const dvec3& way) {
            const double squared = glm::dot(way, way);
            if (squared < reach * reach) {
                values[i] = kDeepInside;
                origins[i] = kNoSource;
            } else if (squared < to * to) {
                const float value = static_cast<float>(reach - std::sqrt(squared) - probe_);
                if (value <= values[i]) return;
                values[i] = value;
                origins[i] = number;
            }
        });
    }

    /// Keeps the smaller distance.
    void take(std::size_t i, double distance, std::uint32_t source, std::vector<float>& values,
              std::vector<std::uint32_t>& origins) const {
        const float value = static_cast<float>(distance - probe_);
        if (value >= values[i]) return;
        values[i] = value;
        origins[i] = source;
    }

    void nearBall(const GridBlock& block, std::uint32_t number, std::vector<float>& values,
                  std::vector<std::uint32_t>& origins) const {
        const dvec3& center = balls_[number].center;
        const double reach = places_.reachRadius(number), least = std::max(reach - reach_, 0.0);
        const double farthest = reach * reach + kTouch;
        const std::span<const std::uint32_t> neighbours = places_.neighbours(number);
        std::size_t last = 0;  // the source that covered the previous node probably covers this one
        const auto [low, high] = ofBalls_[number];
        const auto within = [&](double y, double z) { return ofBall(farthest, y * y + z * z); };
        eachNode(block, {block, low, high}, center, within, [&](std::size_t i, const dvec3& way) {
            const double squared = glm::dot(way, way);
            if (squared > farthest || squared < least * least) return;
            const double length = std::sqrt(squared), distance = std::max(reach - length, 0.0);
            if (static_cast<float>(distance - probe_) >= values[i]) return;
            const dvec3 found = center + (length > 1e-9 ? way * (reach / length) : dvec3(0, 0, reach));
            if (last < neighbours.size() && places_.covers(neighbours[last], found)) return;
            for (std::size_t n = 0; n < neighbours.size(); ++n)
                if (places_.covers(neighbours[n], found)) {
                    last = n;
                    return;
                }
            take(i, distance, number, values, origins);
        });
    }

    /// A circle holds a node's nearest position only if the node's direction lies between the directions to both
    /// centres.
    void nearCircle(const GridBlock& block, std::uint32_t source, std::vector<float>& values,
                    std::vector<std::uint32_t>& origins) const {
        const std::size_t number = source - balls_.size();
        const ProbeCircle& circle = places_.circles()[number];
        const dvec3& axis = circle.axis;
        const double heightA = glm::dot(balls_[circle.a].center - circle.center, axis),
                     heightB = glm::dot(balls_[circle.b].center - circle.center, axis);
        const double slack = kSlack / circle.radius;
        const Span heights{std::max(std::min(heightA, 0.0) - slack, -reach_),
                           std::min(std::max(heightB, 0.0) + slack, reach_)};
        // The circle's plane and its parallels clip a row, unless they are parallel to it.
        const auto within = [&](double y, double z) {
            const double off = axis.y * y + axis.z * z;
            if (std::abs(axis.x) < 1e-3) return Span{};
            const double first = (heights.low - off) / axis.x, second = (heights.high - off) / axis.x;
            return Span{std::min(first, second), std::max(first, second)};
        };
        const auto [low, high] = ofCircles_[number];
        eachNode(block, {block, low, high}, circle.center, within, [&](std::size_t i, const dvec3& way) {
            const double height = glm::dot(way, axis);
            const double out = std::sqrt(std::max(glm::dot(way, way) - height * height, 0.0));
            const double inwards = circle.radius - out;
            const double squared = inwards * inwards + height * height;
            // Tests the wedge's sides, from (radius, 0) to (0, heightA) and (0, heightB); A is below.
            if (inwards < 0 || squared > reach_ * reach_ || height * circle.radius < heightA * inwards - kSlack ||
                height * circle.radius > heightB * inwards + kSlack)
                return;
            const double distance = std::sqrt(squared);
            if (static_cast<float>(distance - probe_) >= values[i]) return;
            if (circle.isOpen({glm::dot(way, circle.x), glm::dot(way, circle.y)}))
                take(i, distance, source, values, origins);
        });
    }

    void nearPoint(const GridBlock& block, std::uint32_t source, std::vector<float>& values,
                   std::vector<std::uint32_t>& origins) const {
        const dvec3& point = places_.points()[source - balls_.size() - places_.circles().size()].place;
        const auto within = [&](double y, double z) { return ofBall(reach_ * reach_, y * y + z * z); };
        eachNode(block, {block, point - reach_, point + reach_}, point, within, [&](std::size_t i, const dvec3& way) {
            const double squared = glm::dot(way, way);
            if (squared <= reach_ * reach_) take(i, std::sqrt(squared), source, values, origins);
        });
    }

    const std::vector<SurfaceBall>& balls_;
    double probe_, reach_, widest_ = 0;
    double outside_;  ///< Å: range of known distances outside, for probes smaller than a cell
    ProbePlaces places_;
    std::vector<ProbeBox> ofBalls_, ofCircles_;
};

}  // namespace

std::unique_ptr<SurfaceField> probeField(const std::vector<SurfaceBall>& balls, double probe, double step) {
    return std::make_unique<ProbeField>(balls, probe, step);
}

}  // namespace nacre
