#pragma once
// For scenes with more copies than a device can hold: writes the few spheres that a view shows.

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "engine/lists/near_first.h"
#include "engine/lists/screen_view.h"
#include "engine/scene/instances/copies.h"
#include "engine/scene/instances/sphere_levels.h"

namespace nacre {

/// Draws copies on the host from near to far, each by the coarsest level whose error is small enough. Omits those
/// outside the picture and behind others. Threads take a band of rows each. Keeps its memory.
class SeenCopies {
public:
    struct Scenery {
        const SphereLevels& levels;
        const Copies& copies;
        glm::dmat3 rotation{1.0};  ///< as in View
        glm::dvec3 shift{0.0};     ///< likewise
    };
    struct LevelCount {
        float error = 0;            ///< Å
        std::uint64_t copies = 0;   ///< placed parts drawn by this level; twice at the borders of bands
        std::uint64_t spheres = 0;  ///< visible ones
    };

    /// Finds the spheres that are nearest at some place of the grid and, if requested, those that may be nearest
    /// between places.
    /// @param view   without outlines
    /// @param error  of outlines, pixels of the view
    /// @param grid   places per pixel side
    /// @param between  whether pixels are also sampled between the places
    void draw(const ScreenView& view, const Scenery& scenery, float error, std::uint32_t grid, bool between);

    /// The spheres without hidden ones, relative to the representation's centre.
    std::span<const Sphere> spheres() const { return spheres_; }
    std::span<const SphereLook> looks() const { return looks_; }
    std::span<const LevelCount> levels() const { return levelCounts_; }  ///< finest first, without empty ones

private:
    /// A placed part whose ball may be visible.
    struct Placed {
        float near = 0;                 // Z
        float x = 0, y = 0, reach = 0;  // of the ball, pixels
        std::uint32_t part = 0, copy = 0;
    };
    struct Found {
        std::uint32_t copy = 0, sphere = 0, step = 0;
    };
    /// Where a sphere is drawn.
    struct Reach {
        float near = 0;  // Z
        float left = 0, top = 0, right = 0, bottom = 0;
    };
    /// Rows that one thread draws.
    struct Band {
        std::uint32_t first = 0, end = 0;
        std::vector<Found> found;
        std::vector<Reach> reaches;  // of `found`, if samples lie between the places of the grid
        std::vector<std::uint64_t> copiesOfStep;
        std::vector<std::uint8_t> seen;
    };

    void placeAll(const ScreenView& view, const Scenery& s);
    bool isHidden(const Band& band, float near, float left, float top, float right, float bottom) const;
    void drawPlaced(const ScreenView& view, const Scenery& s, const Placed& placed, float error, Band& band);
    void drawSphere(const ScreenView& view, const glm::vec3& center, float radius, const Found& what, Band& band);
    void write(const Scenery& s, Band& band);

    bool between_ = false;
    std::uint32_t width_ = 0, height_ = 0;
    std::vector<std::vector<Placed>> placedOfSlices_;
    std::vector<Placed> sorted_;
    std::vector<std::uint32_t> inRow_;
    std::vector<RowBand> rows_;
    std::vector<Band> bands_;
    std::vector<float> z_;
    std::vector<std::uint32_t> nearest_;  // index in the band's `found`
    std::vector<Sphere> spheres_;
    std::vector<SphereLook> looks_;
    std::vector<LevelCount> levelCounts_;  // by their steps, while they are counted
};

}  // namespace nacre
