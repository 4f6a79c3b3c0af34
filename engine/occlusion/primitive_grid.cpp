#include "engine/occlusion/primitive_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nacre {

PrimitiveGrid::PrimitiveGrid(const Representation& r) {
    balls_.reserve(r.spheres.size() + r.cylinders.size());
    for (const Sphere& s : r.spheres) balls_.push_back({s.center, s.radius});
    for (const Cylinder& c : r.cylinders) {
        const glm::vec3 half = (c.b - c.a) * 0.5f;
        balls_.push_back({c.a + half, std::sqrt(glm::dot(half, half) + c.radius * c.radius)});
    }
    if (balls_.empty()) {
        starts_.assign(2, 0);
        return;
    }
    glm::vec3 low = balls_[0].center, high = low;
    for (const Ball& b : balls_) {
        low = glm::min(low, b.center);
        high = glm::max(high, b.center);
        reach_ = std::max(reach_, b.radius);
    }
    low_ = low;
    // Cells of a radius, but never more of them than a few per primitive.
    const glm::dvec3 size = glm::dvec3(high - low) + 1.0;
    const double most = 8.0 * static_cast<double>(balls_.size()) + 64.0;
    cell_ = std::max({reach_, static_cast<float>(std::cbrt(size.x * size.y * size.z / most)), 1e-3f});
    for (int i = 0; i < 3; ++i) size_[i] = std::clamp(static_cast<int>((high[i] - low[i]) / cell_) + 1, 1, 1 << 10);

    const auto cellOf = [&](const Ball& b) {
        const glm::ivec3 c = at(b.center);
        return index(c.x, c.y, c.z);
    };
    starts_.assign(index(0, 0, size_.z) + 1, 0);
    for (const Ball& b : balls_) ++starts_[cellOf(b) + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    items_.resize(balls_.size());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t i = 0; i < balls_.size(); ++i) items_[next[cellOf(balls_[i])]++] = i;
}

glm::ivec3 PrimitiveGrid::at(const glm::vec3& p) const {
    glm::ivec3 c;
    for (int i = 0; i < 3; ++i)
        c[i] = static_cast<int>(std::clamp((p[i] - low_[i]) / cell_, 0.0f, static_cast<float>(size_[i] - 1)));
    return c;
}

}  // namespace nacre
