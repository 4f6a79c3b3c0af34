#pragma once

#include <optional>

#include "engine/graph/graph.h"
#include "engine/passes/output.h"
#include "engine/passes/primitives.h"

namespace nacre::passes {

struct DeferredRims {
    vk::ImageView image;  ///< as rims() leaves them
    graph::Clear clear;   ///< of the picture
};
/// Of a layer of translucent triangles: how it knows whether what is opaque hides it.
struct LayerOver {
    NearestFrom from = NearestFrom::depthBuffer;
    vk::ImageView nearest{};  ///< unless the depth test tells
    Encoding encoding{};
};
/// Shades every covered pixel once: the hit is rebuilt from the pixel and the record of the primitive whose number it
/// holds.
struct DeferredPass {
    Output output = Output::color;
    Reads reads;                         ///< `nearest` holds the numbers, as an input attachment or a texture
    std::optional<DeferredRims> rims{};  ///< lines and halos that are laid over
    std::optional<LayerOver> over{};     ///< the layer is laid over the picture
};
void draw(gpu::PassContext& context, const SceneView& view, const DeferredPass& pass);
/// Asks for the pipeline of that.
void want(gpu::PipelineContext& context, const SceneView& view, const DeferredPass& pass);

}  // namespace nacre::passes
