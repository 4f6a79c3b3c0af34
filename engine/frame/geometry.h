#pragma once
// Vertex work and memory traffic of a frame's passes, on GPUs that store vertex outputs. Makes no Vulkan calls.

#include <span>
#include <vector>

#include "engine/frame/frame.h"
#include "engine/graph/plan.h"
#include "engine/passes/placed_copies.h"
#include "engine/scene/build/representation.h"

namespace nacre {

struct SceneCounts : passes::PrimitiveCounts {
    passes::PrimitiveCounts light{};   ///< of the light's view
    passes::PrimitiveCounts layers{};  ///< of translucent layers, not included above
    std::vector<MeshLevelCount> meshLevels{};
    std::vector<CopyLevelCount> copyLevels{};
    TileCounts lists{};  ///< tile lists
};

/// Primitives that the settings' view of a scene submits, after the culling of frames.
/// @param facts  receives the facts about the view for choose()
SceneCounts countPrimitives(Representation representation, const RenderSettings& settings, SceneFacts& facts);

/// Geometry of a screen frame's passes that draw primitives, in order. @param plates, impostor  as requested
std::vector<PassGeometry> describeGeometry(const graph::Graph& graph, const SceneCounts& counts,
                                           const graph::GeometryCaps& caps, PlateShape plates, ImpostorShape impostor);

/// As above, into an existing list.
void tellGeometry(const graph::Graph& graph, const SceneCounts& counts, const graph::GeometryCaps& caps,
                  PlateShape plates, ImpostorShape impostor, std::vector<PassGeometry>& list);

/// Bytes of vertex outputs of each render pass; 0 for those that draw no primitives.
std::vector<std::uint64_t> countVertexBytes(const graph::Plan& plan, std::span<const PassGeometry> passes);

/// The total.
PassGeometry sumGeometry(std::span<const PassGeometry> passes);

}  // namespace nacre
