#pragma once
// What the passes of a frame ask of the vertex stage, and of memory on GPUs that store what it hands on. Pure.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/device_options.h"
#include "engine/frame/screen.h"
#include "engine/graph/plan.h"
#include "engine/results.h"
#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre {

/// What a view of a scene submits: what lies outside of the picture is left out, as frames do.
/// @param meshError  pixels that meshes may be off by
SceneCounts countsOf(Representation representation, const View& view, double meshError = 0);

/// Of the passes of a screen frame that draw primitives, in their order. @param plates, impostor  as asked for
std::vector<PassGeometry> geometryOf(const graph::Graph& graph, const SceneCounts& counts,
                                     const graph::GeometryCaps& caps, PlateShape plates, ImpostorShape impostor);

/// The same, into what an earlier frame was told in.
void tellGeometry(const graph::Graph& graph, const SceneCounts& counts, const graph::GeometryCaps& caps,
                  PlateShape plates, ImpostorShape impostor, std::vector<PassGeometry>& list);

/// In all.
PassGeometry sumOf(std::span<const PassGeometry> passes);

}  // namespace nacre
