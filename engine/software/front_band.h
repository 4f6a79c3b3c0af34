#pragma once
// Draws spheres on the host into a band of rows, one thread per band, with as many lanes as the processor has.

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "engine/scene/build/representation.h"
#include "engine/software/sphere_boxes.h"
#include "engine/software/tile_view.h"

namespace nacre {

/// A transform for boxes and for spheres.
struct FrontPlace {
    glm::vec4 x, y, z;                // of boxes: into pixels and Z
    glm::vec3 spanX, spanY, spanZ;    // of a box with half sides of 1 Å
    glm::vec4 right, down, toViewer;  // of spheres: into view space, turned like the picture, Å
};

/// Consecutive boxes with one transform.
struct FrontGroup {
    float near = 0;                                  // depth
    float left = 0, top = 0, right = 0, bottom = 0;  // pixels
    std::uint32_t call = 0, group = 0;
};

/// Where a box or a sphere may be visible.
struct FrontRectangle {
    float near = 0;  // depth
    float left = 0, top = 0, right = 0, bottom = 0;
};

/// Rows of a picture, and the nearest spheres of its pixels. Depths are the encoded ones of the shaders, 0 to 1.
struct FrontBand {
    std::uint32_t first = 0, end = 0;  ///< rows
    std::uint32_t width = 0, pitch = 0;
    float* depth = nullptr;           ///< of each pixel's sphere; `pitch` per row
    std::uint32_t* number = nullptr;  ///< its number, if any
    float pixels = 1;                 ///< per Å
    float room = 0;                   ///< largest shift of a sphere or box by rounding, pixels
    float margin = 0;                 ///< likewise in depth
    // As in ViewConstants:
    glm::vec2 axis{};
    float pixel = 1, origin = 0, perRange = 1;
    float start = 0;  ///< depthStart * perRange

    /// Whether everything from r.near on is hidden in all of a rectangle's pixels. True without a pixel centre.
    bool isHidden(const FrontRectangle& r) const;
};

/// Draws the spheres of a group of boxes.
using DrawFrontGroup = void (*)(const FrontBand& band, std::span<const Sphere> spheres, const SphereBoxes& boxes,
                                const TileCall& call, const FrontPlace& place, std::uint32_t group);

/// Finds where boxes may be visible. @param boxes  consecutive ones, as many as there are lanes
using FindFrontRectangles = void (*)(const FrontBand& band, const FrontPlace& place, const SphereBox* boxes,
                                     FrontRectangle* to);

struct FrontLanes {
    std::uint32_t lanes = 0;
    DrawFrontGroup draw = nullptr;
    FindFrontRectangles rectangles = nullptr;
};

/// Lane counts that this processor supports, ascending: 4, then 8.
std::span<const FrontLanes> frontLanes();

}  // namespace nacre
