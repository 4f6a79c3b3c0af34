#pragma once
// What passes that draw one triangle over the whole screen have in common.

#include "engine/gpu/execute.h"

namespace nacre::passes {

struct FullScreenPass {
    gpu::ShaderWords fragment;
    gpu::Specialization constants;
    std::string_view detail;  ///< beside the pass's name, for captures
    gpu::Blend blend = gpu::Blend::replace;
    gpu::DepthUse depth = gpu::DepthUse::none;
};

/// The pass's pipeline, bound. @param layout  outlives what is recorded
void bindFullScreen(gpu::PassContext& context, const FullScreenPass& pass, const gpu::Layout& layout);
/// The same pipeline, wanted ahead.
void wantFullScreen(gpu::PipelineContext& context, const FullScreenPass& pass, const gpu::Layout& layout);

/// The triangle, with its push constants.
template <typename Push>
void drawFullScreen(gpu::PassContext& context, const gpu::Layout& layout, vk::ShaderStageFlags stages,
                    const Push& push) {
    context.commands.pushConstants<Push>(*layout.pipeline, stages, 0, push);
    context.commands.draw(3, 1, 0, 0);
}

/// Textures of set 0, binding 0 and up, sampled by the same filter, in a set of their own that is bound.
void bindTextures(gpu::PassContext& context, const gpu::Layout& layout, vk::Filter filter,
                  std::span<const vk::ImageView> textures);

}  // namespace nacre::passes
