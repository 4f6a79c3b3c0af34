#pragma once
// Finds the sphere that is nearest at each pixel's centre, among millions of sub-pixel ones.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/lists/near_first.h"
#include "engine/software/front_band.h"
#include "engine/software/sphere_boxes.h"
#include "engine/software/tile_view.h"

namespace nacre {

/// Draws spheres on the host from near to far, and culls groups and boxes as a whole. Computes hits as shaders do, in
/// the same order: lavapipe 22.3 and SwiftShader find the same spheres. They compile fma() as two operations; where a
/// driver rounds otherwise, either of two spheres that are equally near may win. Several threads take one band of rows
/// each. Keeps its memory between frames, so that later frames allocate only the threads. Views are orthographic,
/// sampled at pixel centres, in one layer, without clipping planes or outlines.
class FrontSpheres {
public:
    /// @param lanes  number of spheres drawn at once
    explicit FrontSpheres(const FrontLanes& lanes = frontLanes().back()) : lanes_(lanes) {}

    /// Finds the nearest sphere of each pixel.
    void draw(const TileView& view, std::span<const Sphere> spheres, const SphereBoxes& boxes,
              std::span<const TileCall> calls);

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

    std::uint32_t width_ = 0, height_ = 0;
    std::uint32_t pitch_ = 0;  // pixels per row, including sentinels at its end that count as covered
    FrontLanes lanes_;
    FrontBand shared_;  // values common to all bands
    std::vector<TileCall> runs_;
    std::vector<FrontGroup> groups_, sorted_;
    std::vector<std::uint32_t> inRow_;
    std::vector<RowBand> bands_;
    std::vector<float> depth_;           // of each pixel's sphere
    std::vector<std::uint32_t> number_;  // its number, if any
};

}  // namespace nacre
