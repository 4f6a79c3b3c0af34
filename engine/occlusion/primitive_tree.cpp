#include "engine/occlusion/primitive_tree.h"

#include <cmath>
#include <glm/common.hpp>
#include <numeric>

namespace nacre {
namespace {

constexpr std::uint32_t kLeafSize = 8;

/// A number per primitive: only primitives with equal numbers can be neighbours. Empty if all can.
std::vector<std::uint64_t> companies(const Representation& r, std::size_t count) {
    const bool triangles = count > r.spheres.size() + r.cylinders.size();
    const bool lists =
        r.copies.spheres.size() + r.copies.cylinders.size() + (triangles ? r.copies.triangles.size() : 0) > 1;
    if (!lists && r.sphereModels.empty() && (!triangles || r.triangleModels.empty())) return {};
    std::vector<std::uint64_t> companies(count, 0);
    const auto add = [&](std::size_t base, const auto& runs, const auto& getNumber) {
        for (const auto& run : runs)
            for (std::uint32_t i = 0; i < run.count; ++i) companies[base + run.first + i] += getNumber(run);
    };
    const auto list = [](const PrimitiveRun& run) { return std::uint64_t{run.list} << 32; };
    const auto model = [](const ModelRun& run) { return std::uint64_t{run.model}; };
    add(0, r.copies.spheres, list);
    add(r.spheres.size(), r.copies.cylinders, list);
    add(0, r.sphereModels, model);
    add(r.spheres.size(), r.cylinderModels, model);
    if (triangles) {
        add(r.spheres.size() + r.cylinders.size(), r.copies.triangles, list);
        add(r.spheres.size() + r.cylinders.size(), r.triangleModels, model);
    }
    return companies;
}

float finite(float value) { return std::isfinite(value) ? value : 0.0f; }

}  // namespace

PrimitiveTree::PrimitiveTree(const Representation& r, Of of) {
    balls_.reserve(r.spheres.size() + r.cylinders.size() + (of == Of::everything ? r.triangles.size() : 0));
    for (const Sphere& s : r.spheres) balls_.push_back({s.center, s.radius});
    for (const Cylinder& c : r.cylinders) {
        const glm::vec3 half = (c.b - c.a) * 0.5f;
        balls_.push_back({c.a + half, std::sqrt(glm::dot(half, half) + c.radius * c.radius)});
    }
    if (of == Of::everything)
        for (const Triangle& t : r.triangles) {
            const glm::vec3 a = decodePosition(r.meshVertices[t.a], t.step()),
                            b = decodePosition(r.meshVertices[t.b], t.step()),
                            c = decodePosition(r.meshVertices[t.c], t.step());
            const glm::vec3 middle = (glm::min(glm::min(a, b), c) + glm::max(glm::max(a, b), c)) * 0.5f;
            const auto away = [&](const glm::vec3& p) { return glm::length(p - middle); };
            balls_.push_back({middle, std::max({away(a), away(b), away(c)})});
        }
    for (Ball& ball : balls_)
        ball = {{finite(ball.center.x), finite(ball.center.y), finite(ball.center.z)}, finite(ball.radius)};
    items_.resize(balls_.size());
    std::iota(items_.begin(), items_.end(), 0u);
    nodes_.reserve(balls_.size() / 2 + 1);
    const auto count = static_cast<std::uint32_t>(balls_.size());
    const std::vector<std::uint64_t> company = companies(r, count);
    if (company.empty()) {
        build(0, count);
        return;
    }
    std::stable_sort(items_.begin(), items_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return company[a] < company[b]; });
    roots_.resize(count);
    for (std::uint32_t begin = 0, end = 0; begin < count; begin = end) {
        const std::uint64_t group = company[items_[begin]];
        while (end < count && company[items_[end]] == group) ++end;
        const std::vector<std::uint32_t> members(items_.begin() + begin, items_.begin() + end);
        const std::uint32_t root = build(begin, end);
        for (const std::uint32_t item : members) roots_[item] = root;
    }
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
