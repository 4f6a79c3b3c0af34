#include "engine/mesh/probe_field.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/mesh/probe_places.h"
#include "engine/mesh/unit_vectors.h"

namespace nacre {
namespace {

using glm::dvec3;

constexpr double kSlack = 0.05;  // Å^2, so that nothing is lost between a circle's wedge and its neighbours
constexpr double kNowhere = 1e9;
constexpr float kDeepInside = 1e3f;  // for nodes far from every probe position

class ProbeField : public SurfaceField {
public:
    ProbeField(const std::vector<SurfaceBall>& balls, double probe, double step)
        : balls_(balls),
          probe_(probe),
          reach_(probe + step * 1.001),
          outside_(probe < step * 1.001 ? step * 1.001 : 0),
          places_(balls, probe) {
        for (const SurfaceBall& ball : balls) widest_ = std::max(widest_, ball.radius);
    }

    std::vector<std::array<dvec3, 2>> reaches() const override {
        std::vector<std::array<dvec3, 2>> boxes;
        for (const SurfaceBall& ball : balls_) {
            const double reach = ball.radius + probe_ + outside_;
            boxes.push_back({ball.center - reach, ball.center + reach});
        }
        for (const ProbeCircle& circle : places_.circles()) {
            const dvec3 half = circle.radius * glm::sqrt(glm::max(1.0 - circle.axis * circle.axis, dvec3(0)));
            const dvec3 &a = balls_[circle.a].center, &b = balls_[circle.b].center;
            boxes.push_back(
                {glm::min(glm::min(a, b), circle.center - half), glm::max(glm::max(a, b), circle.center + half)});
        }
        for (const ProbePoint& point : places_.points()) boxes.push_back({point.place - reach_, point.place + reach_});
        return boxes;
    }

    void fill(const GridBlock& block, std::span<const std::uint32_t> sources, std::vector<float>& values,
              std::vector<std::uint32_t>& origins) const override {
        // First finds nodes inside a ball, then their distance to the outside.
        std::fill(values.begin(), values.end(), static_cast<float>(-probe_ - outside_));
        std::fill(origins.begin(), origins.end(), kNoSource);
        for (const std::uint32_t source : sources)
            if (source < balls_.size()) fillBall(block, source, values, origins);
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

    SurfacePoint cross(const Node& inside, const Node& outside) const override {
        if (probe_ == 0) return leave(inside.place, outside.place);
        double a = 0, b = 1, atA = inside.value, atB = outside.value;
        Nearest nearest;
        dvec3 place{};
        for (int round = 0; round < 3; ++round) {
            const double share = std::clamp(a + (b - a) * (atA > atB ? atA / (atA - atB) : 0.5), 0.02, 0.98);
            place = inside.place + (outside.place - inside.place) * share;
            nearest = nearer(nearestOf(inside.origin, place), nearestOf(outside.origin, place));
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

private:
    struct Nearest {
        dvec3 place{};
        dvec3 normal{};              ///< of a ball
        double distance = kNowhere;  ///< Å; negative outside of the balls
    };

    /// Inside, the nearer of two; sources outside of a ball have no information about the inside.
    static const Nearest& nearer(const Nearest& a, const Nearest& b) {
        if (a.distance == kNowhere || b.distance == kNowhere) return a.distance == kNowhere ? b : a;
        const bool first = a.distance < b.distance;
        return first == (std::min(a.distance, b.distance) >= 0) ? a : b;
    }

    /// The probe position nearest to a point, for one source, whether open or not.
    Nearest nearestOf(std::uint32_t source, const dvec3& place) const {
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
        return balls_[*std::min_element(of.begin(), of.end(), [&](auto a, auto b) { return height(a) < height(b); })]
            .atom;
    }

    /// Without a probe: where a line leaves the balls, which is exact.
    SurfacePoint leave(const dvec3& from, const dvec3& to) const {
        const dvec3 way = to - from;
        const BallExit exit = exitOf(balls_, places_.grid(), widest_, from, way);
        const SurfaceBall& ball = balls_[exit.ball == kNoSource ? 0 : exit.ball];
        SurfacePoint point;
        point.place = from + way * std::clamp(exit.share, 0.0, 1.0);
        point.normal = unitOr(point.place - ball.center, unitOr(way, dvec3(0, 0, 1)));
        point.atom = ball.atom;
        return point;
    }

    template <typename Visit>
    static void eachNode(const GridBlock& block, const NodeRange& range, const Visit& visit) {
        for (int z = range.first.z; z <= range.last.z; ++z)
            for (int y = range.first.y; y <= range.last.y; ++y) {
                std::size_t index = block.index({range.first.x, y, z});
                for (int x = range.first.x; x <= range.last.x; ++x, ++index)
                    visit(index, dvec3(x * block.step, y * block.step, z * block.step));
            }
    }

    void fillBall(const GridBlock& block, std::uint32_t number, std::vector<float>& values,
                  std::vector<std::uint32_t>& origins) const {
        const SurfaceBall& ball = balls_[number];
        const double reach = places_.reachOf(number), to = reach + outside_;
        eachNode(block, {block, ball.center - to, ball.center + to}, [&](std::size_t i, const dvec3& place) {
            const dvec3 way = place - ball.center;
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

    /// Takes a distance if it is the least yet.
    void take(std::size_t i, double distance, std::uint32_t source, std::vector<float>& values,
              std::vector<std::uint32_t>& origins) const {
        const float value = static_cast<float>(distance - probe_);
        if (value >= values[i]) return;
        values[i] = value;
        origins[i] = source;
    }

    void nearBall(const GridBlock& block, std::uint32_t number, std::vector<float>& values,
                  std::vector<std::uint32_t>& origins) const {
        const SurfaceBall& ball = balls_[number];
        const double reach = places_.reachOf(number), least = std::max(reach - reach_, 0.0);
        const std::span<const std::uint32_t> neighbours = places_.neighbours(number);
        std::size_t last = 0;  // who was in the way of the node before is likely to be again
        eachNode(block, {block, ball.center - reach, ball.center + reach}, [&](std::size_t i, const dvec3& place) {
            const dvec3 way = place - ball.center;
            const double squared = glm::dot(way, way);
            if (squared >= reach * reach || squared < least * least) return;
            const double length = std::sqrt(squared);
            if (static_cast<float>(reach - length - probe_) >= values[i]) return;
            const dvec3 found = ball.center + unitOr(way, dvec3(0, 0, 1)) * reach;
            if (last < neighbours.size() && places_.covers(neighbours[last], found)) return;
            for (std::size_t n = 0; n < neighbours.size(); ++n)
                if (places_.covers(neighbours[n], found)) {
                    last = n;
                    return;
                }
            take(i, reach - length, number, values, origins);
        });
    }

    /// A circle has a node's nearest position only if the node is between the directions from there to both centres.
    void nearCircle(const GridBlock& block, std::uint32_t source, std::vector<float>& values,
                    std::vector<std::uint32_t>& origins) const {
        const ProbeCircle& circle = places_.circles()[source - balls_.size()];
        const dvec3 half = circle.radius * glm::sqrt(glm::max(1.0 - circle.axis * circle.axis, dvec3(0)));
        const dvec3 &a = balls_[circle.a].center, &b = balls_[circle.b].center;
        const double heightA = glm::dot(a - circle.center, circle.axis),
                     heightB = glm::dot(b - circle.center, circle.axis);
        const NodeRange range(block, glm::min(glm::min(a, b), circle.center - half),
                              glm::max(glm::max(a, b), circle.center + half));
        eachNode(block, range, [&](std::size_t i, const dvec3& place) {
            const dvec3 way = place - circle.center;
            const double height = glm::dot(way, circle.axis);
            const double out = std::sqrt(std::max(glm::dot(way, way) - height * height, 0.0));
            const double inwards = circle.radius - out;
            const double squared = inwards * inwards + height * height;
            // The wedge's sides, from (radius, 0) to (0, heightA) and (0, heightB), A being below.
            if (inwards < 0 || squared > reach_ * reach_ || height * circle.radius < heightA * inwards - kSlack ||
                height * circle.radius > heightB * inwards + kSlack)
                return;
            if (static_cast<float>(std::sqrt(squared) - probe_) >= values[i]) return;
            if (isOpen(circle, std::atan2(glm::dot(way, circle.y), glm::dot(way, circle.x))))
                take(i, std::sqrt(squared), source, values, origins);
        });
    }

    static bool isOpen(const ProbeCircle& circle, double angle) {
        constexpr double kTurn = 2 * std::numbers::pi;
        for (const OpenArc& arc : circle.arcs)
            for (const double turned : {angle, angle + kTurn, angle - kTurn})
                if (turned >= arc.begin && turned <= arc.end) return true;
        return false;
    }

    void nearPoint(const GridBlock& block, std::uint32_t source, std::vector<float>& values,
                   std::vector<std::uint32_t>& origins) const {
        const dvec3& point = places_.points()[source - balls_.size() - places_.circles().size()].place;
        eachNode(block, {block, point - reach_, point + reach_}, [&](std::size_t i, const dvec3& place) {
            const dvec3 way = place - point;
            const double squared = glm::dot(way, way);
            if (squared <= reach_ * reach_) take(i, std::sqrt(squared), source, values, origins);
        });
    }

    const std::vector<SurfaceBall>& balls_;
    double probe_, reach_, widest_ = 0;
    double outside_;  ///< Å, to which distances are known beyond the probe's places, of probes smaller than a cell
    ProbePlaces places_;
};

}  // namespace

std::unique_ptr<SurfaceField> probeField(const std::vector<SurfaceBall>& balls, double probe, double step) {
    return std::make_unique<ProbeField>(balls, probe, step);
}

}  // namespace nacre
