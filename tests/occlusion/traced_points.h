#pragma once
// Points of a molecule's surface with the occlusion that rays say they have, and what the baked occlusion says there.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/renderer.h"
#include "engine/scene/build/representation.h"

namespace nacre::test {

struct TracedPoint {
    std::uint32_t view = 0, pixel = 0;  ///< of tracedViews()
    glm::dvec3 position{}, normal{};    ///< frame of the streams, Å
    double open = 0;                    ///< 1: every direction above the surface is open
};

/// Ten orthographic views of 384 x 384 pixels, turned at random.
std::vector<View> tracedViews(const Representation& scene);

/// Random covered pixels of tracedViews(), each traced with stratified, cosine-weighted rays.
std::vector<TracedPoint> tracePoints(Renderer& renderer, const Representation& scene, std::size_t count,
                                     std::size_t rays);

struct Difference {
    double rootMeanSquare = 0, mean = 0, worst = 0;
};

/// The renderer's occlusion at the points, less the traced one.
/// @param settings its view is replaced
Difference bakedDifference(Renderer& renderer, const Representation& scene, RenderSettings settings,
                           const std::vector<TracedPoint>& points);

/// What is baked from 128 directions, against rays: root mean square at most `bound`, mean at most 0.02 either way.
void expectNearRays(const Representation& scene, double bound);

/// A direction of light, and what a point gains that it reaches.
struct WeightedDirection {
    glm::dvec3 direction{};
    double weight = 0;
};
/// The original app's set: 22 rotations about x and y, each again with both angles advanced by pi/8, of weights 0.5/22
/// and 1.5/22, whatever the angle to the surface. Source: Larson's Molecules, SLSOpenGLES20Renderer.m.
std::vector<WeightedDirection> originalDirections();

/// What a set of directions with flat weights says of the points if its depth maps were perfect, less the traced one.
Difference directionsDifference(const Representation& scene, const std::vector<WeightedDirection>& directions,
                                const std::vector<TracedPoint>& points);

}  // namespace nacre::test
