// The surface where a sum of Gaussians is 1: its values on a grid, and where it crosses the edges.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/mesh/probe_field.h"
#include "engine/mesh/surface_field.h"
#include "engine/mesh/unit_vectors.h"
#include "engine/simd/lanes.h"

namespace nacre {
namespace {

/// A ball's Gaussian is exp(s (1 - (d / radius)^2)), 0 from kGaussianReach radii on. The surface is where their sum
/// is 1.
constexpr double kGaussianSmoothness = 1.5;
constexpr double kGaussianReach = 2.5;  ///< exp(-1.5 * 6.25) is 1e-4 of the value at an atom's centre

constexpr int kBrickCells = 4;  // along each edge of a brick

/// exp(x) to 2 units in the last place, for |x| < 80; else any number. After S. Moshier's Cephes.
Lanes exponentials(Lanes x) {
    constexpr float kShift = 12582912;  // 1.5 * 2^23: leaves a whole number in the lowest bits
    const Lanes shifted = x * 1.44269504f + kShift, whole = shifted - kShift;
    const Lanes rest = x - whole * 0.693359375f + whole * 2.12194440e-4f;
    Lanes sum = rest * 1.9875691500e-4f + 1.3981999507e-3f;
    for (const float next : {8.3334519073e-3f, 4.1665795894e-2f, 1.6666665459e-1f, 5.0000001201e-1f})
        sum = sum * rest + next;
    const Mask bits = toBits(sum * rest * rest + rest + 1) + (toBits(shifted) << 23);
    Lanes result;
    std::memcpy(&result, &bits, sizeof result);
    return result;
}

float addLanes(Lanes lanes) { return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]); }

/// The balls that reach a brick, in lanes.
class NearBalls {
public:
    struct Sum {
        double value = -1;
        glm::dvec3 downwards{};
        std::uint32_t atom = 0;  ///< whose sphere is nearest
    };

    /// @param origin  of places
    void assign(const std::vector<SurfaceBall>& balls, std::span<const std::uint32_t> list, const glm::dvec3& origin) {
        const std::size_t whole = (list.size() + kLanes - 1) / kLanes * kLanes;
        constexpr float kAway = 1e9f;
        x_.assign(whole, kAway);
        for (auto* const numbers : {&y_, &z_, &radius_}) numbers->assign(whole, 0);
        inverseSquare_.assign(whole, 1);
        atoms_.assign(whole, 0);
        for (std::size_t i = 0; i < list.size(); ++i) {
            const SurfaceBall& ball = balls[list[i]];
            const glm::dvec3 center = ball.center - origin;
            x_[i] = static_cast<float>(center.x), y_[i] = static_cast<float>(center.y);
            z_[i] = static_cast<float>(center.z);
            radius_[i] = static_cast<float>(ball.radius);
            inverseSquare_[i] = static_cast<float>(1 / (ball.radius * ball.radius));
            atoms_[i] = ball.atom;
        }
    }

    Sum at(const glm::vec3& place) const {
        constexpr auto kSmoothness = static_cast<float>(kGaussianSmoothness);
        constexpr auto kShareOfReach = static_cast<float>(kGaussianReach * kGaussianReach);
        constexpr float kFar = 1e30f;
        Lanes value{}, downX{}, downY{}, downZ{}, lowest = Lanes{} + kFar;
        Mask nearest{};  // its number
        for (std::size_t i = 0; i < x_.size(); i += kLanes) {
            const Lanes x = place.x - loadLanes(&x_[i]), y = place.y - loadLanes(&y_[i]),
                        z = place.z - loadLanes(&z_[i]), inverse = loadLanes(&inverseSquare_[i]);
            const Lanes squared = x * x + y * y + z * z, share = squared * inverse;
            const Mask reaches = share < kShareOfReach;
            if (!any(reaches)) continue;
            const Lanes part = reaches ? exponentials(kSmoothness - kSmoothness * share) : Lanes{};
            value += part;
            const Lanes slope = part * inverse;
            downX += x * slope, downY += y * slope, downZ += z * slope;
            const Lanes height = squareRoots(squared) - loadLanes(&radius_[i]);
            const Mask lower = (height < lowest) & reaches;
            lowest = lower ? height : lowest;
            nearest = lower ? Mask{} + static_cast<std::int32_t>(i) : nearest;
        }
        Sum sum;
        sum.value += static_cast<double>(addLanes(value));
        sum.downwards = {addLanes(downX), addLanes(downY), addLanes(downZ)};
        std::uint32_t best = 0;
        for (std::uint32_t k = 1; k < kLanes; ++k)
            if (lowest[k] < lowest[best]) best = k;
        if (!atoms_.empty()) sum.atom = atoms_[static_cast<std::uint32_t>(nearest[best]) + best];
        return sum;
    }

private:
    std::vector<float> x_, y_, z_, radius_, inverseSquare_;
    std::vector<std::uint32_t> atoms_;
};

/// The bricks of a block, with the balls and crossings of each.
class Bricks {
public:
    Bricks(const GridBlock& block, std::span<const GridCrossing> crossings)
        : block_(block), count_((block.nodes() - 2) / kBrickCells + 1) {
        const auto bricks = static_cast<std::size_t>(count_.x) * count_.y * count_.z;
        first_.assign(bricks + 1, 0);
        balls_.resize(bricks);
        std::vector<std::uint32_t> brickOf(crossings.size());
        for (std::size_t i = 0; i < crossings.size(); ++i) {
            const glm::dvec3 middle = (crossings[i].inside.place + crossings[i].outside.place) * 0.5;
            brickOf[i] = static_cast<std::uint32_t>(index(brickAt(middle)));
            ++first_[brickOf[i] + 1];
        }
        for (std::size_t i = 0; i < bricks; ++i) first_[i + 1] += first_[i];
        sorted_.resize(crossings.size());
        std::vector<std::uint32_t> places(first_.begin(), first_.end() - 1);
        for (std::uint32_t i = 0; i < crossings.size(); ++i) sorted_[places[brickOf[i]]++] = i;
    }

    void add(std::uint32_t number, const SurfaceBall& ball) {
        constexpr double kRoom = 1e-6;  // Å
        const double reach = kGaussianReach * ball.radius + kRoom;
        const glm::ivec3 low = brickAt(ball.center - reach), high = brickAt(ball.center + reach);
        const double edge = kBrickCells * block_.step;
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x) {
                    const std::size_t brick = index({x, y, z});
                    if (first_[brick] == first_[brick + 1]) continue;
                    const glm::dvec3 corner = block_.place(block_.first) + glm::dvec3(x, y, z) * edge;
                    const glm::dvec3 way = ball.center - glm::clamp(ball.center, corner, corner + edge);
                    if (glm::dot(way, way) < reach * reach) balls_[brick].push_back(number);
                }
    }

    /// Calls visit(balls, crossings) for each brick that has crossings.
    template <typename Visit>
    void each(const Visit& visit) const {
        for (std::size_t i = 0; i < balls_.size(); ++i)
            if (first_[i] < first_[i + 1])
                visit(balls_[i], std::span(sorted_).subspan(first_[i], first_[i + 1] - first_[i]));
    }

private:
    glm::ivec3 brickAt(const glm::dvec3& place) const {
        const glm::dvec3 brick = glm::floor((place / block_.step - glm::dvec3(block_.first)) / double{kBrickCells});
        return glm::ivec3(glm::clamp(brick, glm::dvec3(0), glm::dvec3(count_ - 1)));
    }
    std::size_t index(const glm::ivec3& brick) const {
        return (static_cast<std::size_t>(brick.z) * count_.y + brick.y) * count_.x + brick.x;
    }

    const GridBlock& block_;
    glm::ivec3 count_;
    std::vector<std::uint32_t> first_, sorted_;  // crossings of each brick
    std::vector<std::vector<std::uint32_t>> balls_;
};

/// The logarithm of a sum of Gaussians is nearly a parabola: takes a first place from the values at the nodes, and
/// Newton's steps from there, mostly one. @param origin  of the balls
SurfacePoint cross(const NearBalls& balls, const GridCrossing& c, const glm::dvec3& origin) {
    constexpr double kLeastSum = 1e-4;
    constexpr double kNear = 0.01;  // of the edge: a step from there is exact
    constexpr int kMostSteps = 4;
    const glm::dvec3 edge = c.outside.place - c.inside.place;
    const double above = std::log(1 + c.inside.value), below = -std::log(std::max(1 + c.outside.value, kLeastSum));
    const auto within = [](double share) { return std::clamp(share, 0.02, 0.98); };
    double share = within(above + below > 0 ? above / (above + below) : 0.5);
    NearBalls::Sum sum;
    for (int step = 0; step < kMostSteps; ++step) {
        sum = balls.at(glm::vec3(c.inside.place + edge * share - origin));
        const double slope = 2 * kGaussianSmoothness * glm::dot(sum.downwards, edge);  // downwards, per edge
        if (!(slope > 0)) break;
        const double before = share;
        share = within(share + sum.value / slope);
        if (std::abs(share - before) < kNear) break;
    }
    return {c.inside.place + edge * share, unitOr(sum.downwards, unitOr(edge, glm::dvec3(0, 0, 1))), sum.atom};
}

/// Adds a point for each crossing of a block. Crossings in one brick of 4 x 4 x 4 cells share a list of the balls that
/// reach it, four balls at once.
/// @param sources  balls that reach into the block
void crossGaussians(const std::vector<SurfaceBall>& balls, const GridBlock& block,
                    std::span<const std::uint32_t> sources, std::span<const GridCrossing> crossings,
                    std::vector<SurfacePoint>& points) {
    Bricks bricks(block, crossings);
    for (const std::uint32_t source : sources) bricks.add(source, balls[source]);
    const glm::dvec3 origin = block.place(block.first);
    const std::size_t before = points.size();
    points.resize(before + crossings.size());
    NearBalls near;
    bricks.each([&](std::span<const std::uint32_t> list, std::span<const std::uint32_t> inBrick) {
        near.assign(balls, list, origin);
        for (const std::uint32_t i : inBrick) points[before + i] = cross(near, crossings[i], origin);
    });
}

constexpr std::size_t kMostNodesOfAxis = 64;  ///< of a block along an axis

class GaussianField : public SurfaceField {
public:
    explicit GaussianField(const std::vector<SurfaceBall>& balls) : balls_(balls) {}

    std::vector<std::array<glm::dvec3, 2>> reaches() const override {
        std::vector<std::array<glm::dvec3, 2>> boxes;
        for (const SurfaceBall& ball : balls_) {
            const double reach = kGaussianReach * ball.radius;
            boxes.push_back({ball.center - reach, ball.center + reach});
        }
        return boxes;
    }

    void fill(const GridBlock& block, std::span<const std::uint32_t> sources, std::vector<float>& values,
              std::vector<std::uint32_t>& origins) const override {
        std::fill(values.begin(), values.end(), -1.0f);
        std::fill(origins.begin(), origins.end(), kNoSource);
        for (const std::uint32_t source : sources) {
            const SurfaceBall& ball = balls_[source];
            const double reach = kGaussianReach * ball.radius;
            const NodeRange range(block, ball.center - reach, ball.center + reach);
            const Profile x(block, range, ball, 0), y(block, range, ball, 1), z(block, range, ball, 2);
            for (int k = range.first.z; k <= range.last.z; ++k)
                for (int j = range.first.y; j <= range.last.y; ++j) {
                    float* const row = &values[block.index({range.first.x, j, k})];
                    const float left = kShareOfReach - y.share(j) - z.share(k);
                    const float factor = kPeak * y.part(j) * z.part(k);
                    for (int i = 0; i <= range.last.x - range.first.x; ++i)
                        row[i] += x.shares[i] < left ? factor * x.parts[i] : 0.0f;
                }
        }
    }

    void cross(const GridBlock& block, std::span<const std::uint32_t> sources, std::span<const GridCrossing> crossings,
               std::vector<SurfacePoint>& points) const override {
        crossGaussians(balls_, block, sources, crossings, points);
    }

private:
    static constexpr float kShareOfReach = static_cast<float>(kGaussianReach * kGaussianReach);
    static inline const float kPeak = static_cast<float>(std::exp(kGaussianSmoothness));

    /// A ball's Gaussian along one axis. Factors of the axes multiply, and their shares of the squared radius add up.
    struct Profile {
        int first;
        std::array<float, kMostNodesOfAxis> shares, parts;

        Profile(const GridBlock& block, const NodeRange& range, const SurfaceBall& ball, int axis)
            : first(range.first[axis]) {
            for (int i = first; i <= range.last[axis]; ++i) {
                const double way = (i * block.step - ball.center[axis]) / ball.radius;
                shares[static_cast<std::size_t>(i - first)] = static_cast<float>(way * way);
                parts[static_cast<std::size_t>(i - first)] =
                    static_cast<float>(std::exp(-kGaussianSmoothness * way * way));
            }
        }
        float share(int i) const { return shares[static_cast<std::size_t>(i - first)]; }
        float part(int i) const { return parts[static_cast<std::size_t>(i - first)]; }
    };

    const std::vector<SurfaceBall>& balls_;
};

}  // namespace

std::unique_ptr<SurfaceField> gaussianField(const std::vector<SurfaceBall>& balls) {
    return std::make_unique<GaussianField>(balls);
}

}  // namespace nacre
