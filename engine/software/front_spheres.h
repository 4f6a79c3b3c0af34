#pragma once
// Finds the few spheres that may be nearest at a pixel's centre, among millions of sub-pixel ones.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/lists/near_first.h"
#include "engine/software/front_band.h"
#include "engine/software/sphere_boxes.h"
#include "engine/software/tile_view.h"

namespace nacre {

/// Draws spheres on the host from near to far, and culls groups and boxes as a whole. Several threads take one band of
/// rows each. Keeps its memory between frames, so that later frames allocate only the threads.
/// Views are orthographic, sampled at pixel centres, in one layer, without clipping planes or outlines.
class FrontSpheres {
public:
    /// @param lanes  number of spheres drawn at once
    explicit FrontSpheres(const FrontLanes& lanes = frontLanes().back()) : lanes_(lanes) {}

    /// Finds, for each pixel, a sphere that may be nearest, and all others that may be, whatever a shader's rounding.
    void draw(const TileView& view, std::span<const Sphere> spheres, const SphereBoxes& boxes,
              std::span<const TileCall> calls);

    /// Further spheres that may be visible at some pixel, in the order of the calls.
    std::span<const TileCall> ambiguous() const { return ambiguousCalls_; }
    std::size_t shown() const { return shown_; }  ///< number of spheres found, including doubtful ones

    /// Whether a rectangle of pixels shows any sphere. Ends are exclusive.
    bool isSeen(std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY) const;
    /// Numbers of the spheres found for some pixels of a row; 0: none, or outside the picture.
    void write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const;

private:
    struct Scenery {
        std::span<const Sphere> spheres;
        const SphereBoxes& boxes;
        std::span<const TileCall> calls;
    };

    std::span<const TileCall> wholeRuns(const SphereBoxes& boxes, std::span<const TileCall> calls);
    void begin(const TileView& view, const Scenery& s);
    void list(const TileView& view, const Scenery& s);
    void listDoubts(std::span<const TileCall> drawn, std::span<const TileCall> calls);
    bool mark(std::uint32_t number);
    void countShown();

    std::uint32_t width_ = 0, height_ = 0;
    std::uint32_t pitch_ = 0;  // pixels per row, including sentinels at its end that count as covered
    FrontLanes lanes_;
    FrontBand shared_;  // values common to all bands
    std::vector<TileCall> runs_;
    std::vector<FrontGroup> groups_, sorted_;
    std::vector<std::uint32_t> inRow_;
    std::vector<RowBand> bands_;
    std::vector<std::vector<std::uint32_t>> ambiguous_;  // per band
    std::vector<float> z_;                               // of each pixel's sphere
    std::vector<std::uint32_t> number_;                  // its number, if any
    std::vector<std::uint64_t> marks_;                   // one bit per number
    std::vector<TileCall> ambiguousCalls_;
    std::size_t shown_ = 0;
};

}  // namespace nacre
