#pragma once
// Finds the few of millions of sub-pixel spheres that may be nearest at a pixel's centre.

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "engine/scene/near_first.h"
#include "engine/scene/sphere_boxes.h"
#include "engine/scene/tile_view.h"

namespace nacre {

/// Draws spheres on the host from near to far, in groups and boxes that are culled as a whole. Several threads take one
/// band of rows each. Keeps its memory between frames, so that later frames allocate only the threads.
class FrontSpheres {
public:
    /// Whether it supports a view: orthographic, sampled at pixel centres, without clipping planes or outlines.
    static bool tells(const TileView& view);

    /// Finds per pixel a sphere that may be nearest, and all others that may be, whatever a shader's rounding.
    void draw(const TileView& view, std::span<const Sphere> spheres, const SphereBoxes& boxes,
              std::span<const TileCall> calls);

    /// Further spheres that may be visible at some pixel, in the order of the calls.
    std::span<const TileCall> doubts() const { return doubtCalls_; }
    std::size_t shown() const { return shown_; }  ///< number of spheres found, including doubtful ones

    /// Whether a rectangle of pixels shows any sphere. Ends are exclusive.
    bool isSeen(std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY) const;
    /// Numbers of the spheres found for some pixels of a row, 0: none; 0 beyond the picture as well.
    void write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const;

private:
    /// Transform into pixels and Z.
    struct Place {
        glm::vec4 x, y, z;
        glm::vec3 spanX, spanY, spanZ;  // of a box with half sides of 1 Å
    };
    /// Consecutive boxes with one transform.
    struct Group {
        float near = 0;  // Z
        float left = 0, top = 0, right = 0, bottom = 0;
        std::uint32_t call = 0, group = 0;
    };
    /// Four boxes in the picture.
    struct Rectangles;
    /// Rows of pixels that one thread draws.
    struct Band {
        std::uint32_t first, end;
        std::vector<std::uint32_t>& doubts;
    };
    struct Scenery {
        std::span<const Sphere> spheres;
        const SphereBoxes& boxes;
        std::span<const TileCall> calls;
    };

    void begin(const TileView& view, const Scenery& s);
    void list(const Scenery& s);
    Rectangles rectanglesOf(const Place& place, const SphereBox* boxes) const;
    bool isHidden(const Band& band, float near, float left, float top, float right, float bottom) const;
    void drawGroup(const Band& band, const Scenery& s, const Group& group);
    void drawSpheres(const Band& band, const Scenery& s, const TileCall& call, const Place& place, std::uint32_t first,
                     std::uint32_t end);
    void meet(const Band& band, std::size_t at, float Z, bool certain, std::uint32_t number);
    void listDoubts(const Scenery& s);

    std::uint32_t width_ = 0, height_ = 0;
    std::size_t pitch_ = 0;  // pixels per row, including sentinels at its end that hide everything
    float pixels_ = 1, perPixel_ = 1;
    float room_ = 0;    // pixels that rounding may move a sphere by
    float margin_ = 0;  // as above in Z, Å
    float edge_ = 0;    // as a fraction of the squared radius: hits nearer to the edge do not count
    std::vector<Place> places_;
    std::vector<Group> groups_;
    std::vector<std::uint32_t> order_, inRow_;
    std::vector<RowBand> bands_;
    std::vector<std::vector<std::uint32_t>> doubts_;  // per band
    std::vector<float> z_;                            // of each pixel's sphere
    std::vector<std::uint32_t> number_;               // its number, if any
    std::vector<std::uint64_t> marks_;                // one bit per number
    std::vector<TileCall> doubtCalls_;
    std::size_t shown_ = 0;
};

}  // namespace nacre
