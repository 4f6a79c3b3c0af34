#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "engine/scene/build/representation.h"

namespace nacre {

/// Bounding volume hierarchy of the spheres (numbered from 0) and cylinders (numbered after the spheres), for neighbour
/// queries, or of triangles as well (numbered after both), for rays. Primitives with other copies, and models that do
/// not occlude each other, are no neighbours: each group has its own tree. A grid would suit normal molecules, but its
/// cells overflow where all atoms share one point and one atom or bond end is a billion Å away.
class PrimitiveTree {
public:
    enum class Of : std::uint8_t { solids, everything };  ///< without or with triangles
    /// O(n log n) for any positions; a NaN coordinate counts as 0.
    explicit PrimitiveTree(const Representation& r, Of of = Of::solids);

    /// Calls visit(primitive) for each other primitive whose bounding sphere meets that of `self`, until it returns
    /// false. @param reach  Å, added to the radius of `self`
    template <typename Visit>
    void near(std::uint32_t self, Visit&& visit, float reach = 0) const {
        Ball mine = balls_[self];
        mine.radius += reach;
        std::array<std::uint32_t, 64> waiting;  // a tree of 2^32 balls is 30 levels deep
        std::size_t count = 0;
        waiting[count++] = roots_.empty() ? 0 : roots_[self];
        while (count > 0) {
            const std::uint32_t at = waiting[--count];
            const Node& node = nodes_[at];
            if (apart(node, mine)) continue;
            if (node.right != 0) {
                waiting[count++] = node.right;
                waiting[count++] = at + 1;
                continue;
            }
            for (std::uint32_t i = node.begin; i < node.end; ++i) {
                const std::uint32_t item = items_[i];
                const glm::vec3 d = balls_[item].center - mine.center;
                const float r = balls_[item].radius + mine.radius;
                if (item != self && d.x * d.x + d.y * d.y + d.z * d.z < r * r && !visit(item)) return;
            }
        }
    }

    /// Calls visit(primitive, far) for each primitive whose bounding sphere a ray from `self` may meet before `far`;
    /// that returns where to stop from then on. @param direction  unit length
    template <typename Visit>
    void along(std::uint32_t self, const glm::vec3& start, const glm::vec3& direction, Visit&& visit,
               float far = std::numeric_limits<float>::infinity()) const {
        const glm::vec3 inverse = 1.0f / direction;  // infinite where a direction lies in a plane of the boxes
        std::array<std::pair<std::uint32_t, float>, 64> waiting;  // and where the ray enters
        std::size_t count = 0;
        waiting[count++] = {roots_.empty() ? 0 : roots_[self], 0.0f};
        while (count > 0) {
            const auto [at, entered] = waiting[--count];
            if (entered >= far) continue;
            const Node& node = nodes_[at];
            if (node.right == 0) {
                for (std::uint32_t i = node.begin; i < node.end; ++i) {
                    const Ball& ball = balls_[items_[i]];
                    const glm::vec3 d = ball.center - start;
                    const float middle = glm::dot(d, direction), square = ball.radius * ball.radius;
                    if (middle + ball.radius < 0 || middle - ball.radius > far) continue;
                    if (glm::dot(d, d) - middle * middle <= square) far = visit(items_[i], far);
                }
                continue;
            }
            std::pair<std::uint32_t, float> first{at + 1, entry(nodes_[at + 1], start, inverse)};
            std::pair<std::uint32_t, float> second{node.right, entry(nodes_[node.right], start, inverse)};
            if (first.second < second.second) std::swap(first, second);
            if (first.second < far) waiting[count++] = first;
            if (second.second < far) waiting[count++] = second;
        }
    }

private:
    /// Bounding sphere of a primitive, Å.
    struct Ball {
        glm::vec3 center{};
        float radius = 0;
    };
    struct Node {
        glm::vec3 low, high;       ///< of its bounding spheres
        std::uint32_t begin, end;  ///< range in items_
        std::uint32_t right;       ///< index of the second child; the first child is the next node. 0: a leaf
    };

    static bool apart(const Node& node, const Ball& ball) {
        for (int i = 0; i < 3; ++i)
            if (ball.center[i] + ball.radius < node.low[i] || ball.center[i] - ball.radius > node.high[i]) return true;
        return false;
    }
    /// Distance at which a ray enters a node's box; infinite: never.
    static float entry(const Node& node, const glm::vec3& start, const glm::vec3& inverse) {
        float from = 0, to = std::numeric_limits<float>::infinity();
        for (int i = 0; i < 3; ++i) {
            const float a = (node.low[i] - start[i]) * inverse[i], b = (node.high[i] - start[i]) * inverse[i];
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        }
        return from <= to ? from : std::numeric_limits<float>::infinity();
    }
    std::uint32_t build(std::uint32_t begin, std::uint32_t end);

    std::vector<Ball> balls_;
    std::vector<std::uint32_t> items_;  ///< primitives in tree order
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> roots_;  ///< index by primitive; empty: one tree
};

}  // namespace nacre
