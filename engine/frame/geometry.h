#pragma once
// Vertex work and memory traffic of a frame's passes, on GPUs that store vertex outputs. Makes no Vulkan calls.

#include <span>
#include <vector>

#include "engine/device_options.h"
#include "engine/frame/screen.h"
#include "engine/graph/plan.h"
#include "engine/results.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre {

/// Primitives that a view of a scene submits, after culling those outside of the picture as frames do.
/// @param meshError  screen-space error of meshes, pixels
SceneCounts countsOf(Representation representation, const View& view, double meshError = 0);

/// Geometry of a screen frame's passes that draw primitives, in order. @param plates, impostor  as requested
std::vector<PassGeometry> geometryOf(const graph::Graph& graph, const SceneCounts& counts,
                                     const graph::GeometryCaps& caps, PlateShape plates, ImpostorShape impostor);

/// As above, into an existing list.
void tellGeometry(const graph::Graph& graph, const SceneCounts& counts, const graph::GeometryCaps& caps,
                  PlateShape plates, ImpostorShape impostor, std::vector<PassGeometry>& list);

/// The total.
PassGeometry sumOf(std::span<const PassGeometry> passes);

}  // namespace nacre
