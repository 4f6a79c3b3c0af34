#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/scene/build/representation.h"

namespace nacre {

/// Bounding volume hierarchy of the spheres (numbered from 0) and cylinders (numbered after the spheres), for neighbour
/// queries. Primitives with other copies, and models that do not occlude each other, are no neighbours: each group has
/// its own tree. A grid would suit normal molecules, but its cells overflow where all atoms share one point and one
/// atom or bond end is a billion Å away.
class PrimitiveTree {
public:
    /// O(n log n) for any positions; a NaN coordinate counts as 0.
    explicit PrimitiveTree(const Representation& r);

    /// Calls visit(primitive) for each other primitive whose bounding sphere meets that of `self`, until it returns
    /// false.
    template <typename Visit>
    void near(std::uint32_t self, Visit&& visit) const {
        const Ball mine = balls_[self];
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
    std::uint32_t build(std::uint32_t begin, std::uint32_t end);

    std::vector<Ball> balls_;
    std::vector<std::uint32_t> items_;  ///< primitives in tree order
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> roots_;  ///< index by primitive; empty: one tree
};

}  // namespace nacre
