#pragma once
// Which spheres may be the nearest at the centre of a pixel: of millions as small as pixels, few.

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "engine/scene/near_first.h"
#include "engine/scene/sphere_boxes.h"
#include "engine/scene/tile_view.h"

namespace nacre {

/// Draws spheres on the host from near to far, by groups and boxes of a few: those that lie behind what is drawn are
/// left out together. Several threads take a part of the picture's rows each. Kept from frame to frame, it allocates
/// nothing but those threads once it has seen the most.
class FrontSpheres {
public:
    /// Whether it can tell of a view: along parallel rays, at the centres of pixels, of what no plane cuts and no line
    /// goes about.
    static bool tells(const TileView& view);

    /// Finds for each pixel a sphere that may be the nearest, and which others may be, whatever a shader rounds.
    void draw(const TileView& view, std::span<const Sphere> spheres, const SphereBoxes& boxes,
              std::span<const TileCall> calls);

    /// Spheres that may be seen at some pixel for which another one stands, in the order of the calls.
    std::span<const TileCall> doubts() const { return doubtCalls_; }
    std::size_t shown() const { return shown_; }  ///< spheres that stand for a pixel or are in doubt

    /// Whether a rectangle of pixels, to one past its end, shows any.
    bool isSeen(std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY) const;
    /// Numbers of those that stand for some pixels of a row, 0 where there is none; beyond the picture, too.
    void write(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const;

private:
    /// Into pixels and Z.
    struct Place {
        glm::vec4 x, y, z;
        glm::vec3 spanX, spanY, spanZ;  // of a box half as large as 1 Å
    };
    /// Boxes together at one place.
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
    std::size_t pitch_ = 0;  // of a row of pixels, which ends in some that hide all
    float pixels_ = 1, perPixel_ = 1;
    float room_ = 0;    // pixels that rounding may move a sphere by
    float margin_ = 0;  // Å likewise, where a sphere's Z is certain
    float edge_ = 0;    // share of a radius squared: nearer to its edge nothing is
    std::vector<Place> places_;
    std::vector<Group> groups_;
    std::vector<std::uint32_t> order_, inRow_;
    std::vector<RowBand> bands_;
    std::vector<std::vector<std::uint32_t>> doubts_;  // of each band
    std::vector<float> z_;                            // of each pixel's sphere
    std::vector<std::uint32_t> number_;               // its number, where there is one
    std::vector<std::uint64_t> marks_;                // a bit a number
    std::vector<TileCall> doubtCalls_;
    std::size_t shown_ = 0;
};

}  // namespace nacre
