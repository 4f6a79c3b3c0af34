#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/mesh/ball_grid.h"
#include "engine/mesh/probe_field.h"
#include "engine/mesh/unit_vectors.h"

namespace nacre {
namespace {

constexpr double kSmoothness = 1.5;
constexpr double kGaussianReach = 2.5;  // radii; exp(-1.5 * 6.25) is 1e-4 of the value at an atom's centre

constexpr std::size_t kMostNodes = 64;  ///< of a block along an axis

class GaussianField : public SurfaceField {
public:
    explicit GaussianField(const std::vector<SurfaceBall>& balls) : balls_(balls), grid_(balls, 0) {
        for (const SurfaceBall& ball : balls) farthest_ = std::max(farthest_, kGaussianReach * ball.radius);
    }

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

    /// The logarithm of a sum of Gaussians is nearly a parabola: takes a first place from the values at the nodes, and
    /// one Newton step from there.
    SurfacePoint cross(const Node& inside, const Node& outside) const override {
        constexpr double kLeastSum = 1e-4;
        const glm::dvec3 edge = outside.place - inside.place;
        const double above = std::log(1 + inside.value), below = -std::log(std::max(1 + outside.value, kLeastSum));
        const auto within = [](double share) { return std::clamp(share, 0.02, 0.98); };
        const double guess = within(above + below > 0 ? above / (above + below) : 0.5);
        const Sum sum = sumAt(inside.place + edge * guess);
        const double slope = 2 * kSmoothness * glm::dot(sum.downwards, edge);  // downwards, per edge
        const double share = slope > 0 ? within(guess + sum.value / slope) : guess;
        return {inside.place + edge * share, unitOr(sum.downwards, unitOr(edge, glm::dvec3(0, 0, 1))), sum.atom};
    }

private:
    static constexpr float kShareOfReach = static_cast<float>(kGaussianReach * kGaussianReach);
    static inline const float kPeak = static_cast<float>(std::exp(kSmoothness));

    /// A ball's Gaussian along one axis. Factors of the axes multiply, and their shares of the squared radius add up.
    struct Profile {
        int first;
        std::array<float, kMostNodes> shares, parts;

        Profile(const GridBlock& block, const NodeRange& range, const SurfaceBall& ball, int axis)
            : first(range.first[axis]) {
            for (int i = first; i <= range.last[axis]; ++i) {
                const double way = (i * block.step - ball.center[axis]) / ball.radius;
                shares[static_cast<std::size_t>(i - first)] = static_cast<float>(way * way);
                parts[static_cast<std::size_t>(i - first)] = static_cast<float>(std::exp(-kSmoothness * way * way));
            }
        }
        float share(int i) const { return shares[static_cast<std::size_t>(i - first)]; }
        float part(int i) const { return parts[static_cast<std::size_t>(i - first)]; }
    };

    struct Sum {
        double value = -1;
        glm::dvec3 downwards{};
        std::uint32_t atom = 0;
    };

    Sum sumAt(const glm::dvec3& place) const {
        Sum sum;
        double nearest = 1e9;
        grid_.near(place, farthest_, [&](std::uint32_t i) {
            const SurfaceBall& ball = balls_[i];
            const glm::dvec3 way = place - ball.center;
            const double squaredRadius = ball.radius * ball.radius, squared = glm::dot(way, way);
            if (squared >= kGaussianReach * kGaussianReach * squaredRadius) return;
            const double part = std::exp(kSmoothness * (1 - squared / squaredRadius));
            sum.value += part;
            sum.downwards += way * (part / squaredRadius);
            const double height = std::sqrt(squared) - ball.radius;
            if (height < nearest) nearest = height, sum.atom = ball.atom;
        });
        return sum;
    }

    const std::vector<SurfaceBall>& balls_;
    BallGrid grid_;
    double farthest_ = 0;
};

}  // namespace

std::unique_ptr<SurfaceField> gaussianField(const std::vector<SurfaceBall>& balls) {
    return std::make_unique<GaussianField>(balls);
}

}  // namespace nacre
