#pragma once
// Shared by passes over the whole screen, and the simplest such passes.

#include <array>
#include <optional>

#include "engine/gpu/execute.h"
#include "engine/passes/output.h"

namespace nacre::passes {

struct FullScreenPass {
    gpu::ShaderWords fragment;
    gpu::Specialization constants;
    std::string_view detail;  ///< added to the pass's name, for captures
    gpu::Blend blend = gpu::Blend::replace;
    gpu::DepthUse depth = gpu::DepthUse::none;
};

/// Binds the pass's pipeline. @param layout  outlives the recording
void bindFullScreen(gpu::PassContext& context, const FullScreenPass& pass, const gpu::Layout& layout);
/// Requests the same pipeline ahead.
void wantFullScreen(gpu::PipelineContext& context, const FullScreenPass& pass, const gpu::Layout& layout);

/// Draws a triangle, or the strip of several views, with its push constants.
template <typename Push>
void drawFullScreen(gpu::PassContext& context, const gpu::Layout& layout, vk::ShaderStageFlags stages,
                    const Push& push) {
    context.commands.pushConstants<Push>(*layout.pipeline, stages, 0, push);
    context.commands.draw(context.views > 1 ? 4 : 3, 1, 0, 0);
}

/// Binds a set with textures at set 0, binding 0 and up, all with the same sampler.
void bindTextures(gpu::PassContext& context, const gpu::Layout& layout, vk::Filter filter,
                  std::span<const vk::ImageView> textures);

struct Resampling {
    std::uint32_t samples = 0;  ///< n: the picture has n x n texels per pixel of the target; 0: any other ratio
    bool coded = false;         ///< the target takes sRGB-coded colour
    float share = 1;            ///< factor for the picture's values
    bool add = false;           ///< to the target's contents
    vk::Rect2D part{};          ///< of the target; without size: all
    NearestFrom from = NearestFrom::texture;  ///< an input attachment: each texel is a pixel of the target
    std::optional<std::uint32_t> layer{};     ///< of a picture that has several
    /// Shares of the picture's channels in each of the target's.
    std::array<std::array<float, 3>, 3> channels{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// Scales a picture to another resolution.
void resample(gpu::PassContext& context, vk::ImageView picture, const Resampling& how);
/// Requests the pipeline.
void wantResampling(gpu::PipelineContext& context, const Resampling& how);

}  // namespace nacre::passes
