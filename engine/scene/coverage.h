#pragma once
// From which depth on parts of a picture are certainly covered: what lies wholly behind does not show.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "engine/scene/tile_view.h"

namespace nacre {

/// Square cells of pixels, each with a depth. One sphere must cover all of a cell, so cells are smaller than spheres.
/// Kept from frame to frame, it allocates nothing once it has seen the largest.
class Coverage {
public:
    /// Nothing is covered. @param radiusPixels  of a typical sphere
    void begin(const TileView& view, double radiusPixels);
    /// Covers what a sphere does. In perspective, too, its picture holds that of the disc about its centre which
    /// faces along z, and rays meet the sphere before they meet that.
    /// @param center  in view space, Å
    void cover(const TileView& view, const glm::vec3& center, float radius);
    /// Whether each cell that a box touches is covered before a depth. What is outside of the picture is no matter.
    /// @param low, high  pixels @param near  Z, Å
    bool hides(glm::vec2 low, glm::vec2 high, float near) const;

private:
    std::uint32_t across_ = 0, down_ = 0;  // cells
    float side_ = 1;                       // pixels
    bool centers_ = false;                 // a cell is the middle of a pixel
    float ask_ = 0;                        // where that is
    float inset_ = 0;                      // by which a disc is smaller that holds the middles of the cells it covers
    std::vector<float> depths_;            // Z; row by row
};

}  // namespace nacre
