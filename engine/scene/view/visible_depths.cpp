#include "engine/scene/view/visible_depths.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace nacre {
namespace {

constexpr int kDepthCells = 64;  // per side

}  // namespace

std::vector<double> visibleDepths(const std::vector<glm::dvec4>& balls, const View& view) {
    constexpr double kVertexReach = 0.6;  // Å: of vertices, which are dense
    double reach = 1e-6;
    for (const glm::dvec4& ball : balls) reach = std::max(reach, glm::length(glm::dvec3(ball)) + ball.w);
    const double cell = 2 * reach / kDepthCells;
    std::vector<double> nearest(static_cast<std::size_t>(kDepthCells) * kDepthCells,
                                std::numeric_limits<double>::infinity());
    for (const glm::dvec4& ball : balls) {
        const glm::dvec3 v = view.rotation * glm::dvec3(ball);
        const double radius = std::max(ball.w, kVertexReach);
        const auto findCell = [&](double at) {
            return std::clamp(static_cast<int>((at + reach) / cell), 0, kDepthCells - 1);
        };
        for (int y = findCell(v.y - radius); y <= findCell(v.y + radius); ++y)
            for (int x = findCell(v.x - radius); x <= findCell(v.x + radius); ++x) {
                const glm::dvec2 middle((x + 0.5) * cell - reach, (y + 0.5) * cell - reach);
                if (glm::distance(middle, glm::dvec2(v)) > std::max(radius, cell)) continue;
                double& there = nearest[static_cast<std::size_t>(y) * kDepthCells + static_cast<std::size_t>(x)];
                there = std::min(there, -v.z - ball.w);
            }
    }
    std::erase_if(nearest, [](double depth) { return !std::isfinite(depth); });
    std::sort(nearest.begin(), nearest.end());
    return nearest;
}

std::optional<DepthRange> frontRange(const std::vector<double>& depths, double radius) {
    constexpr double kBehind = 0.1;  // of the radius: visible surfaces extend this far behind the centre
    constexpr double kNear = 0.1, kFar = 0.95;
    if (depths.empty()) return std::nullopt;
    const auto at = [&](double share) {
        return depths[static_cast<std::size_t>(share * static_cast<double>(depths.size() - 1))];
    };
    if (at(kFar) > kBehind * radius || !(at(kFar) - at(kNear) > 0)) return std::nullopt;
    return DepthRange{at(kNear), at(kFar)};
}

}  // namespace nacre
