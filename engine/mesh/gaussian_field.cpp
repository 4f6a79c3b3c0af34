#include <algorithm>
#include <array>
#include <cmath>

#include "engine/mesh/gaussian_crossings.h"
#include "engine/mesh/probe_field.h"

namespace nacre {
namespace {

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
