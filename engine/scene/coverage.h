#pragma once
// From which depth on parts of a picture are certainly covered: what lies wholly behind does not show.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "engine/scene/near_first.h"

namespace nacre {

/// Square cells of pixels, each with a depth. One sphere must cover all of a cell, so cells are smaller than spheres.
/// Kept from frame to frame, it allocates nothing once it has seen the largest. Threads may cover and ask bands of its
/// rows at the same time.
class Coverage {
public:
    /// Nothing is covered. @param radiusPixels  of a typical sphere
    void begin(const TileView& view, double radiusPixels);
    /// Covers what a sphere does. In perspective, too, its picture holds that of the disc about its centre which
    /// faces along z, and rays meet the sphere before they meet that.
    /// @param center  in view space, Å
    void cover(const TileView& view, const glm::vec3& center, float radius, RowBand rows);
    /// Whether each cell of some rows that a disc touches is covered before a depth. What is outside of the picture is
    /// no matter.
    /// @param at, reach  of the disc, pixels @param near  Z, Å
    bool hides(glm::vec2 at, float reach, float near, RowBand rows) {
        const CellDisc disc = discOf(at, reach);
        return disc.radius < 0.5f ? hidesSmall(disc, near, rows) : hidesLarge(disc, near, rows);
    }
    std::uint32_t rows() const { return down_; }  ///< of cells
    float side() const { return side_; }          ///< of a cell, pixels

private:
    struct CellDisc {
        glm::vec2 at;  // cells from the top left corner
        float radius, squared;
    };
    template <typename Work>
    bool eachRow(const CellDisc& disc, RowBand rows, const Work& work);
    CellDisc discOf(glm::vec2 at, float reach) const {
        const float radius = (reach + outset_) * perSide_;
        return {at * perSide_, radius, radius * radius};
    }
    /// Of a disc that holds the middle of no cell but the one it stands in: of a million spheres that are smaller than
    /// pixels nearly all are asked so.
    bool hidesSmall(const CellDisc& disc, float near, RowBand rows) const {
        if (!(disc.at.x >= 0) || !(disc.at.x < static_cast<float>(across_)) ||
            !(disc.at.y >= static_cast<float>(rows.first)) || !(disc.at.y < static_cast<float>(rows.end)))
            return true;
        const auto x = static_cast<std::uint32_t>(disc.at.x), y = static_cast<std::uint32_t>(disc.at.y);
        const float aside = disc.at.x - static_cast<float>(x) - 0.5f, above = disc.at.y - static_cast<float>(y) - 0.5f;
        return aside * aside + above * above > disc.squared || depths_[std::size_t{y} * across_ + x] < near;
    }
    bool hidesLarge(const CellDisc& disc, float near, RowBand rows);

    std::uint32_t across_ = 0, down_ = 0;  // cells
    float side_ = 1, perSide_ = 1;         // pixels; one over that
    float inset_ = 0;                      // by which a disc is smaller that holds the middles of the cells it covers
    float outset_ = 0;                     // by which one is larger that holds the middles of those it touches
    std::vector<float> depths_;            // Z; row by row
};

}  // namespace nacre
