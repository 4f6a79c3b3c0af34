#pragma once

#include <cmath>

#include "engine/scene/camera.h"
#include "shaders/common/layout.h"

namespace nacre::passes {

/// The push constants of a view: projection and depth range. Copy, atlas and shading are left 0.
/// @param snapPixels how far the rasteriser may move a vertex
/// @param centerX, centerY pixel of the picture's middle in the framebuffer
inline layout::ViewConstants viewConstants(const View& view, float snapPixels, double centerX, double centerY) {
    const bool perspective = view.projection == Projection::perspective;
    const double origin = perspective ? view.eyeDistance : view.radius;
    // Å of room on both ends: bonds may stand out of the bounding sphere of the atoms by a little.
    constexpr double kRoom = 1.0;
    const double range = 2.0 * (view.radius + kRoom);
    layout::ViewConstants c{};
    c.extent = view.width | view.height << 16;
    c.origin = static_cast<float>(origin);
    const double right = view.pan.x * view.pixelsPerAngstrom, down = -view.pan.y * view.pixelsPerAngstrom;
    constexpr double kTurned[4][4] = {{1, 0, 0, 1}, {0, -1, 1, 0}, {-1, 0, 0, -1}, {0, 1, -1, 0}};
    const double* turn = kTurned[view.quarterTurns & 3];
    // Whole 256ths, which floats hold exactly up to 65,536: a part of a picture meets the very rays of the whole.
    const auto pixel = [](double place) { return static_cast<float>(std::round(place * 256) / 256); };
    c.axisPixel =
        glm::vec2(pixel(centerX + turn[0] * right + turn[1] * down), pixel(centerY + turn[2] * right + turn[3] * down));
    c.pixel = static_cast<float>(1.0 / view.pixelsPerAngstrom);
    c.snap = static_cast<float>(snapPixels / view.pixelsPerAngstrom);
    c.depthStart = static_cast<float>(origin - view.radius - kRoom);
    c.perRange = static_cast<float>(1.0 / range);
    c.patchesInRow = 1 | 1 << 16;
    return c;
}

}  // namespace nacre::passes
