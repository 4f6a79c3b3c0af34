#pragma once
// Depths behind which parts of a picture are certainly covered, for occlusion culling.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "engine/lists/near_first.h"
#include "engine/software/tile_view.h"

namespace nacre {

/// Square cells of pixels, each with a depth. A cell counts only if one sphere covers all of it, so cells are smaller
/// than spheres. Keeps its memory between frames. Several threads may work on separate bands of rows.
class Coverage {
public:
    /// Clears all cells. @param radiusPixels  of a typical sphere
    void begin(const TileView& view, double radiusPixels);
    /// Adds a sphere. Even in perspective, its image contains that of the disc through its centre perpendicular to z,
    /// and rays meet the sphere before the disc.
    /// @param center  in view space, Å
    void cover(const TileView& view, const glm::vec3& center, float radius, RowBand rows);
    /// Whether every cell in these rows that a disc touches is covered before a depth. Ignores cells outside of the
    /// picture.
    /// @param at, reach  of the disc, pixels
    /// @param near  Z, Å
    bool hides(glm::vec2 at, float reach, float near, RowBand rows) {
        const CellDisc disc = boundingDisc(at, reach);
        return disc.radius < 0.5f ? hidesSmall(disc, near, rows) : hidesLarge(disc, near, rows);
    }
    std::uint32_t rows() const { return down_; }  ///< in cells
    float side() const { return side_; }          ///< of a cell, pixels

private:
    struct CellDisc {
        glm::vec2 at;  // cells from the top left corner
        float radius, squared;
    };
    template <typename Work>
    bool eachRow(const CellDisc& disc, RowBand rows, const Work& work);
    CellDisc boundingDisc(glm::vec2 at, float reach) const {
        const float radius = (reach + outset_) * perSide_;
        return {at * perSide_, radius, radius * radius};
    }
    /// For a disc that contains at most the centre of its own cell, like nearly all of a million sub-pixel spheres.
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
    float side_ = 1, perSide_ = 1;         // pixels; reciprocal
    float inset_ = 0;                      // a disc shrunk by this contains the centres of the cells it covers
    float outset_ = 0;                     // a disc enlarged by this contains the centres of the cells it touches
    std::vector<float> depths_;            // Z; row by row
};

}  // namespace nacre
