#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/scene/representation.h"

namespace nacre {

/// A uniform grid over spheres (numbered from 0) and cylinders (numbered on from the number of spheres): which of them
/// come near another one.
class PrimitiveGrid {
public:
    explicit PrimitiveGrid(const Representation& r);

    /// A ball about a primitive: Å.
    struct Ball {
        glm::vec3 center{};
        float radius = 0;
    };
    const Ball& ball(std::uint32_t primitive) const { return balls_[primitive]; }

    /// Calls visit(primitive) for every other primitive whose ball meets that of `self`.
    template <typename Visit>
    void near(std::uint32_t self, Visit&& visit) const {
        const Ball& mine = balls_[self];
        const glm::ivec3 a = at(mine.center - (mine.radius + reach_)), b = at(mine.center + (mine.radius + reach_));
        for (int z = a.z; z <= b.z; ++z)
            for (int y = a.y; y <= b.y; ++y) {
                // Cells of a row lie one after the other.
                const std::size_t row = index(0, y, z);
                const std::uint32_t last = starts_[row + static_cast<std::size_t>(b.x) + 1];
                for (std::uint32_t i = starts_[row + static_cast<std::size_t>(a.x)]; i < last; ++i) {
                    const std::uint32_t item = items_[i];
                    const glm::vec3 d = balls_[item].center - mine.center;
                    const float r = balls_[item].radius + mine.radius;
                    if (item != self && d.x * d.x + d.y * d.y + d.z * d.z < r * r) visit(item);
                }
            }
    }

private:
    glm::ivec3 at(const glm::vec3& p) const;
    std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_.y) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(size_.x) +
               static_cast<std::size_t>(x);
    }

    std::vector<Ball> balls_;
    glm::vec3 low_{};
    float cell_ = 1, reach_ = 0;  // reach_: of the largest ball
    glm::ivec3 size_{1};
    std::vector<std::uint32_t> starts_, items_;  // items of cell c: starts_[c] .. starts_[c + 1]
};

}  // namespace nacre
