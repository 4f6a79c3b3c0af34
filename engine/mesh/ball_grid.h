#pragma once
// Finds neighbouring balls.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/mesh/surface_field.h"

namespace nacre {

/// Balls in grid cells, with the neighbours of each.
class BallGrid {
public:
    /// @param margin  Å, added to every radius
    /// @throws Error if there are more pairs of neighbours than 32 million, and 256 per ball: a protein's atoms have
    /// about eighty each; for a crowd at one place, pairs grow with the square of its number
    BallGrid(const std::vector<SurfaceBall>& balls, double margin);

    /// Balls that overlap this one, nearest first.
    std::span<const std::uint32_t> neighbours(std::uint32_t ball) const {
        return {neighbours_.data() + offsets_[ball], neighbours_.data() + offsets_[ball + 1]};
    }

    /// Visits all balls whose centres may be within `distance` of a position, in a fixed order.
    template <typename Visit>
    void near(const glm::dvec3& place, double distance, const Visit& visit) const {
        const glm::ivec3 low = cellAt(place - distance), high = cellAt(place + distance);
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y) {
                const std::size_t row = (static_cast<std::size_t>(z) * cells_.y + y) * cells_.x;
                for (std::uint32_t i = cellStarts_[row + low.x]; i < cellStarts_[row + high.x + 1]; ++i)
                    visit(sorted_[i]);
            }
    }

private:
    glm::ivec3 cellAt(const glm::dvec3& place) const;
    void checkCrowd() const;
    void sortIntoCells(const std::vector<SurfaceBall>& balls);

    glm::dvec3 low_{};
    double cell_ = 1;
    glm::ivec3 cells_{1};
    std::vector<std::uint32_t> cellStarts_, sorted_, neighbours_;
    std::vector<std::size_t> offsets_;
};

/// Where a line leaves the union of balls in which it starts. Follows it from ball to ball.
struct BallExit {
    double share = 0;                ///< fraction of the line; 0 if it starts outside
    std::uint32_t ball = kNoSource;  ///< the last ball; none if it starts outside
};
/// @param widest  largest radius of a ball, Å
/// @param way  length of the search, plus the reach of a ball
BallExit findExit(const std::vector<SurfaceBall>& balls, const BallGrid& grid, double widest, const glm::dvec3& from,
                  const glm::dvec3& way);

}  // namespace nacre
