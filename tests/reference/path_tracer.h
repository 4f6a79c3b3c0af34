#pragma once
// Diffuse light that bounces, by paths: what the light of a picture's clefts is judged by.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre::reference {

/// Light that stays with the viewer. View space, linear.
struct Sky {
    glm::dvec3 level{1.0};            ///< what a surface gets that looks along the horizon
    glm::dvec3 slope{0.0};            ///< what one that looks up gets more, and one that looks down less
    glm::dvec3 sun{0.0};              ///< of a surface that faces it
    glm::dvec3 toSun{0.0, 0.0, 1.0};  ///< unit length
};

/// Light that leaves the surfaces that pixels show towards the viewer: linear, 1 where a white one gets 1. Each path
/// goes on in a random direction, cosine-weighted, until it finds the sky. All surfaces are diffuse, in their colours.
/// Spheres and triangles; on every core.
/// @param pixels  indices, row 0 on top @param paths  per pixel
/// @returns NaN where a pixel shows the background
/// @throws std::logic_error if the scene has cylinders
std::vector<glm::dvec3> tracePaths(const Representation& scene, const View& view,
                                   const std::vector<std::uint32_t>& pixels, const Sky& sky, std::size_t paths);

}  // namespace nacre::reference
