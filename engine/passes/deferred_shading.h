#pragma once

#include <optional>

#include "engine/graph/graph.h"
#include "engine/passes/output.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

struct DeferredRims {
    vk::ImageView image;  ///< output of rims()
    graph::Clear clear;   ///< of the picture
};
/// Shades every covered pixel once: recomputes the hit from the pixel and the primitive whose number it holds.
struct DeferredPass {
    Output output = Output::color;
    Reads reads;                         ///< `nearest` holds the numbers, as an input attachment or a texture
    std::optional<DeferredRims> rims{};  ///< outlines and halos to composite
    bool over = false;   ///< composites a translucent layer over the picture where the depth test passes
    bool depth = false;  ///< of colour from a texture's numbers: also writes the depth buffer
};
void draw(gpu::PassContext& context, const SceneView& view, const DeferredPass& pass);
/// Requests the pipeline.
void want(gpu::PipelineContext& context, const SceneView& view, const DeferredPass& pass);

}  // namespace nacre::passes
