#pragma once
// Fixed foveation: maps of how many fragments each part of a headset's image gets. No eye is tracked: an eye that turns
// by kGaze sees a fragment for each pixel, and beyond fragments are as wide as its acuity allows.

#include <span>
#include <vector>

#include "engine/graph/plan.h"
#include "engine/scene/view/camera.h"

namespace nacre {

constexpr double kGaze = 15;  ///< degrees by which eyes turn before the head follows

/// State of a map between frames. The host reads it while a render pass begins, so that its contents are there before.
inline const graph::State kDensityState = graph::verbState(graph::Verb::density, graph::PassKind::graphics);

/// A map for an image. @param views  of the image: each has a layer of the map @param texel  PlanCaps::densityTexel
graph::ImageDesc densityMapFor(graph::Extent image, std::uint32_t views, std::uint32_t texel);

/// Where an eye looks straight ahead in its picture.
struct EyeAxis {
    graph::Extent image;
    glm::dvec2 place{};  ///< pixels from the top left
    double pixels = 0;   ///< per tangent at the axis
};
EyeAxis findAxis(const View& perspective);
/// Whether a map for one does for the other: heads that move change them by rounding alone.
bool alike(const EyeAxis& a, const EyeAxis& b);

/// The texels of a map with a layer for each eye, two bytes each: fragments per pixel, across and down.
std::vector<std::uint8_t> fragmentDensities(std::span<const EyeAxis> eyes, std::uint32_t texel);

}  // namespace nacre
