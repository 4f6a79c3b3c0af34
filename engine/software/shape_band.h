#pragma once
// Spheres and cylinders that one thread draws on the host into a band of rows, several pixels at once: by as many lanes
// as the processor has. Lengths are pixels, along the view as well.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nacre {

/// A sphere or a cylinder in the picture, and how far rounding may move it, on the host or the device.
struct FrontShape {
    static constexpr std::uint32_t kStick = 0x80000000u;  ///< of a number: it is a cylinder's
    static constexpr std::uint32_t kDoubt = 0x40000000u;  ///< the device decides: index of the pixel among those

    static constexpr std::uint32_t kMostNumbers = kDoubt;

    std::uint32_t number = 0;
    float front = 0;                                         ///< depth before all of it
    std::uint16_t left = 0, top = 0, right = 0, bottom = 0;  ///< pixels that may show it, ends exclusive
    float x = 0, y = 0, Z = 0;    ///< a sphere's centre, or the middle of an end: from the centre of the first pixel
    float square = 0;             ///< of the radius
    float slack = 0;              ///< error of the height's square
    float room = 0, perRoot = 0;  ///< error of a depth: a constant, and what is divided by the height
    float edgeRoom = 0;           ///< error of a depth where the height is nearly nothing
    // Of a cylinder: its direction in the picture, unit.
    float aheadX = 0, aheadY = 0;
    float perSine = 0, steep = 0, fall = 0;  ///< 1 / sine of its angle to the view, tangent of the other, cosine
    float length = 0, alongRoom = 0, steepRoom = 0;
    // The cap that faces the viewer: how far along, how far around there, its depth, and that of its slope.
    float capAt = 0, capReach = 0, capZ = 0, capSlope = 0, capSink = 0, capSlack = 0, capRoom = 0;
    bool whole = false;  ///< nothing is certain of it: `Z` is before all of it
};

/// A shape that may be nearest at some pixel, beside what is found there.
struct ShapeMeeting {
    std::uint32_t at, number;
    float before;  ///< depth before which it does not show
};

/// Pixels, x | y << 16, each followed by the number of what it shows.
struct ShapePixels {
    std::vector<std::uint32_t> words;
    std::size_t count = 0;  ///< of pixels
};

/// Rows of a picture, and the nearest shapes of their pixels, which are counted from the first.
struct ShapeBand {
    std::uint32_t first = 0, end = 0;  ///< rows
    std::uint32_t pitch = 0;
    float* before = nullptr;  ///< bounds of the depth of each pixel's shape
    float* behind = nullptr;
    std::uint32_t* number = nullptr;  ///< its number; of pixels without one, whose bounds are kNothing, any
    std::vector<ShapeMeeting>* meetings = nullptr;

    static constexpr float kNothing = 3e38f;
    static constexpr std::uint32_t kPixelBytes = 12;
    void meet(std::size_t at, std::uint32_t shape, float from) const;
};

/// @param which  of the shapes are drawn
using DrawShapes = void (*)(const ShapeBand& band, const FrontShape* shapes, const std::uint32_t* which,
                            std::size_t count);

/// Tells which of a row's 16 pixels show something for certain, and clears all of them. @param x  of the first pixel
/// @param balls, sticks  with room for 32 more pixels
using TellShapes = void (*)(const ShapeBand& band, std::uint32_t x, std::uint32_t y, ShapePixels& balls,
                            ShapePixels& sticks);

}  // namespace nacre
