#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/mesh/ball_grid.h"
#include "engine/mesh/probe_field.h"
#include "engine/mesh/unit_vectors.h"

namespace nacre {
namespace {

constexpr double kSmoothness = 1.5;
constexpr double kGaussianReach = 2.5;  // radii; exp(-1.5 * 6.25) is 1e-4 of the value at an atom's centre

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
            const double reach = kGaussianReach * ball.radius, squaredRadius = ball.radius * ball.radius;
            const NodeRange range(block, ball.center - reach, ball.center + reach);
            for (int z = range.first.z; z <= range.last.z; ++z)
                for (int y = range.first.y; y <= range.last.y; ++y) {
                    std::size_t i = block.index({range.first.x, y, z});
                    for (int x = range.first.x; x <= range.last.x; ++x, ++i) {
                        const glm::dvec3 way = block.place({x, y, z}) - ball.center;
                        const double share = glm::dot(way, way) / squaredRadius;
                        if (share < kGaussianReach * kGaussianReach)
                            values[i] += static_cast<float>(std::exp(kSmoothness * (1 - share)));
                    }
                }
        }
    }

    SurfacePoint cross(const Node& inside, const Node& outside) const override {
        double a = 0, b = 1, atA = inside.value, atB = outside.value;
        Sum sum;
        glm::dvec3 place{};
        for (int round = 0; round < 2; ++round) {
            const double share = std::clamp(a + (b - a) * (atA > atB ? atA / (atA - atB) : 0.5), 0.02, 0.98);
            place = inside.place + (outside.place - inside.place) * share;
            sum = sumAt(place);
            if (sum.value > 0)
                a = share, atA = sum.value;
            else
                b = share, atB = sum.value;
        }
        return {place, unitOr(sum.downwards, unitOr(outside.place - inside.place, glm::dvec3(0, 0, 1))), sum.atom};
    }

private:
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
