#pragma once
// Draws a scene by one exact ray through each pixel's centre: the independent judge of the GPU's pictures.

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"
#include "tests/reference/layers.h"
#include "tests/reference/solids.h"

namespace nacre::reference {

/// The line through a pixel's centre, in view space, as camera.h defines it. Orthographic: from the plane z = +R;
/// perspective: from the eye.
Line pixelLine(const View& view, std::uint32_t column, std::uint32_t row);

/// All layers, the ray caster's own included. Of two hits of equal depth the primitive that comes first wins.
Layers castRays(const Representation& scene, const View& view);

/// A point of the visible surface, in the frame of the scene's streams (Å, relative to Representation::center).
struct SurfacePoint {
    std::uint32_t primitive;  ///< spheres first, then cylinders
    glm::dvec3 position;
    glm::dvec3 normal;  ///< outward, unit length
};

/// The exact point that a pixel of castRays(scene, view) shows; empty for background.
std::optional<SurfacePoint> surfacePoint(const Representation& scene, const View& view, const Layers& layers,
                                         std::uint32_t column, std::uint32_t row);

}  // namespace nacre::reference
