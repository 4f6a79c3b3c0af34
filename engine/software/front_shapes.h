#pragma once
// Finds the nearest sphere or cylinder at each pixel's centre: where shapes are a few pixels wide, in less time than a
// software device takes over lists.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "engine/lists/tile_view.h"
#include "engine/scene/build/representation.h"
#include "engine/software/front_band.h"
#include "engine/software/shape_band.h"

namespace nacre {

/// Draws spheres and cylinders on the host. Pixels where rounding may decide are left to the device, with all shapes
/// that may be nearest there. Keeps its memory between frames.
class FrontShapes {
public:
    static constexpr std::uint32_t kHeader = 4;  ///< words: pixels of balls, of sticks, and doubts
    static constexpr std::uint32_t kBlock = 16;  ///< pixels per side of the blocks that are drawn or not

    /// @param lanes  pixels that are drawn at once
    explicit FrontShapes(const FrontLanes& lanes = frontLanes().back()) : lanes_(lanes) {}

    /// Whether it supports a view: orthographic, sampled at pixel centres, without clipping planes or outlines.
    static bool tells(const TileView& view);

    void draw(const TileView& view, std::span<const Sphere> spheres, std::span<const TileCall> sphereCalls,
              std::span<const Cylinder> cylinders, std::span<const TileCall> cylinderCalls);

    /// Whether a block, counted row by row, may show anything.
    bool isSeen(std::size_t block) const { return marks_[block] != 0; }

    std::size_t balls() const;   ///< pixels that show a sphere for certain
    std::size_t sticks() const;  ///< likewise a cylinder
    std::size_t doubts() const;  ///< pixels that the device decides
    /// Size of the device's data in words, and the data: as shaders/tile_pixels.comp reads them.
    std::size_t words() const;
    void write(std::uint32_t* to) const;

private:
    /// What one thread draws, a strip of rows at a time, and tells.
    struct Part {
        ShapeBand band;
        std::vector<float> before, behind;  // bounds of the nearest depth, pixels
        std::vector<std::uint32_t> number;  // of the nearest
        std::vector<ShapeMeeting> meetings;
        ShapePixels balls, sticks;
        std::vector<std::uint32_t> doubts, begins, candidates;  // pixels; of each, where its candidates begin
        struct First {
            std::uint32_t at, number, meeting;  // what was found; of further ones the last
        };
        std::vector<First> firsts;         // of the strip's doubts
        std::vector<std::uint32_t> nexts;  // of each meeting the one before at its pixel
    };

    /// From a copy's coordinates to pixels, along the view as well.
    struct Placing {
        glm::dvec4 X, Y, Z;
        float terms;  // bound of the shift, as it is added
        Placing(const TileView& view, const glm::vec4* rows);
        glm::dvec3 operator()(const glm::vec3& p) const;
    };

    void begin(const TileView& view);
    void addSphere(const TileView& view, const Sphere& sphere, const Placing& placing, std::uint32_t number);
    void addCylinder(const TileView& view, const Cylinder& cylinder, const Placing& placing, std::uint32_t number);
    void add(const TileView& view, FrontShape& shape, glm::dvec2 at, glm::dvec2 low, glm::dvec2 high);
    void part(std::uint32_t height, std::size_t threads);
    void sort();
    void settle(Part& part) const;
    void tell(Part& part) const;
    void drawStrips(Part& part, std::size_t first, std::size_t end, std::uint32_t height) const;

    FrontLanes lanes_;
    std::uint32_t across_ = 0, down_ = 0, pitch_ = 0;
    double fixed_ = 0, fixedDepth_ = 0;  // errors of any shape, pixels
    struct Strips {
        std::uint16_t first, last;
    };
    std::vector<FrontShape> shapes_;
    std::vector<Strips> strips_;                           // of each shape
    std::vector<std::uint8_t> marks_;                      // per block: 1 where something may show
    std::uint32_t rows_ = kBlock;                          // of a strip
    std::vector<std::uint32_t> ofStrips_, begins_, ends_;  // shapes of each strip, and where they begin
    std::vector<Part> parts_;
};

}  // namespace nacre
