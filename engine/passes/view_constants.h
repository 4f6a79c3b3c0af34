#pragma once

#include <cmath>

#include "engine/lists/screen_view.h"
#include "engine/scene/view/camera.h"
#include "shaders/common/layout.h"

namespace nacre::passes {

/// The push constants of a view: projection and depth range. Copy, atlas and shading stay 0.
/// @param centerX, centerY the picture's centre in the framebuffer, pixels
inline layout::ViewConstants viewConstants(const View& view, double centerX, double centerY) {
    const bool perspective = view.projection == Projection::perspective;
    const double origin = perspective ? view.eyeDistance : view.radius;
    // Margin at both ends, Å: bonds may extend slightly beyond the atoms' bounding sphere.
    constexpr double kRoom = 1.0;
    const double range = 2.0 * (view.radius + kRoom);
    layout::ViewConstants c{};
    c.extent = view.width | view.height << 16;
    c.origin = static_cast<float>(origin);
    const double right = view.pan.x * view.pixelsPerAngstrom, down = -view.pan.y * view.pixelsPerAngstrom;
    constexpr double kTurned[4][4] = {{1, 0, 0, 1}, {0, -1, 1, 0}, {-1, 0, 0, -1}, {0, 1, -1, 0}};
    const double* turn = kTurned[view.quarterTurns & 3];
    // Multiples of 1/256, exact in floats up to 65,536: a part of a picture has exactly the rays of the whole.
    const auto pixel = [](double place) { return static_cast<float>(std::round(place * 256) / 256); };
    c.axisPixel =
        glm::vec2(pixel(centerX + turn[0] * right + turn[1] * down), pixel(centerY + turn[2] * right + turn[3] * down));
    c.pixel = static_cast<float>(1.0 / view.pixelsPerAngstrom);
    c.wirePixel = c.pixel;
    c.depthStart = static_cast<float>(origin - view.radius - kRoom);
    c.perRange = static_cast<float>(1.0 / range);
    c.patchesInRow = 1u << 15 | 1u << 16;  // also without an atlas: for cells of all sphere numbers
    return c;
}

/// The camera of a view for the host's visibility tests, without clipping planes and outlines.
/// @param c  viewConstants() of the view @param width, height  of the image, pixels
inline ScreenView screenView(const layout::ViewConstants& c, const View& view, std::uint32_t width,
                             std::uint32_t height) {
    ScreenView v;
    v.width = width;
    v.height = height;
    v.perspective = view.projection == Projection::perspective;
    v.quarterTurns = view.quarterTurns;
    v.axis = c.axisPixel;
    v.pixels = static_cast<float>(view.pixelsPerAngstrom);
    v.pixel = c.pixel;
    v.origin = c.origin;
    v.nearest = c.depthStart;
    v.range = 1.0f / c.perRange;
    v.perRange = c.perRange;
    return v;
}

}  // namespace nacre::passes
