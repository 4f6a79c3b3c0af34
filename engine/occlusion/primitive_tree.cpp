#include "engine/occlusion/primitive_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace nacre {
namespace {

constexpr std::uint32_t kLeafSize = 8;

float finite(float value) { return std::isfinite(value) ? value : 0.0f; }

}  // namespace

PrimitiveTree::PrimitiveTree(const Representation& r) {
    balls_.reserve(r.spheres.size() + r.cylinders.size());
    for (const Sphere& s : r.spheres) balls_.push_back({s.center, s.radius});
    for (const Cylinder& c : r.cylinders) {
        const glm::vec3 half = (c.b - c.a) * 0.5f;
        balls_.push_back({c.a + half, std::sqrt(glm::dot(half, half) + c.radius * c.radius)});
    }
    for (Ball& ball : balls_)
        ball = {{finite(ball.center.x), finite(ball.center.y), finite(ball.center.z)}, finite(ball.radius)};
    items_.resize(balls_.size());
    std::iota(items_.begin(), items_.end(), 0u);
    nodes_.reserve(balls_.size() / 2 + 1);
    build(0, static_cast<std::uint32_t>(balls_.size()));
}

std::uint32_t PrimitiveTree::build(std::uint32_t begin, std::uint32_t end) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    constexpr float kFar = std::numeric_limits<float>::max();
    glm::vec3 low(kFar), high(-kFar), lowCenter(kFar), highCenter(-kFar);
    for (std::uint32_t i = begin; i < end; ++i) {
        const Ball& ball = balls_[items_[i]];
        low = glm::min(low, ball.center - ball.radius);
        high = glm::max(high, ball.center + ball.radius);
        lowCenter = glm::min(lowCenter, ball.center);
        highCenter = glm::max(highCenter, ball.center);
    }
    nodes_.push_back({low, high, begin, end, 0});
    if (end - begin <= kLeafSize) return index;
    const glm::vec3 size = highCenter - lowCenter;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return balls_[a].center[axis] < balls_[b].center[axis]; });
    build(begin, middle);
    const std::uint32_t right = build(middle, end);
    nodes_[index].right = right;
    return index;
}

}  // namespace nacre
