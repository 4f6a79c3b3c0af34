#include "engine/passes/full_screen.h"

#include "engine/passes/bindings.h"
#include "shaders.h"
#include "shaders/common/layout.h"

namespace nacre::passes {
namespace {

gpu::GraphicsPipeline pipelineOf(const gpu::PipelineContext& context, const FullScreenPass& pass,
                                 const gpu::Layout& layout) {
    gpu::GraphicsPipeline d = context.pipeline();
    d.detail = pass.detail;
    d.vertex = shaders::screenVertex;
    d.fragment = pass.fragment;
    d.constants = pass.constants;
    d.layout = *layout.pipeline;
    d.colorsWritten = context.colorCount;
    d.blend = pass.blend;
    d.depth = pass.depth;
    d.strip = false;
    return d;
}

}  // namespace

void bindFullScreen(gpu::PassContext& context, const FullScreenPass& pass, const gpu::Layout& layout) {
    const vk::Pipeline pipeline = context.pipelines.graphics(pipelineOf(context, pass, layout));
    context.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline);
}

void wantFullScreen(gpu::PipelineContext& context, const FullScreenPass& pass, const gpu::Layout& layout) {
    context.pipelines.want(pipelineOf(context, pass, layout));
}

void bindTextures(gpu::PassContext& context, const gpu::Layout& layout, vk::Filter filter,
                  std::span<const vk::ImageView> textures) {
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    for (std::uint32_t i = 0; i < textures.size(); ++i) {
        const vk::DescriptorImageInfo info(context.pipelines.sampler(filter), textures[i],
                                           vk::ImageLayout::eShaderReadOnlyOptimal);
        context.device->updateDescriptorSets(
            vk::WriteDescriptorSet(set, i, 0, vk::DescriptorType::eCombinedImageSampler, info), {});
    }
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, set, {});
}

namespace {

constexpr Type kPicture[] = {kSampled};
constexpr auto kFragments = vk::ShaderStageFlagBits::eFragment;
using Scale = std::array<float, 4>;

const gpu::Layout& resampleLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"resample layout", kPicture, kFragments, sizeof(Scale)});
}

FullScreenPass passOf(const Resampling& how) {
    FullScreenPass pass{shaders::resampleFragment, {}, {}};
    pass.blend = how.add ? gpu::Blend::add : gpu::Blend::replace;
    pass.constants.set(layout::kSamplesId, how.samples);
    pass.constants.set(layout::kCodedId, how.coded);
    return pass;
}

}  // namespace

void resample(gpu::PassContext& context, vk::ImageView picture, const Resampling& how) {
    const Scale scale{1.0f / static_cast<float>(context.extent.width), 1.0f / static_cast<float>(context.extent.height),
                      how.share, 0};
    const gpu::Layout& layout = resampleLayout(context);
    bindFullScreen(context, passOf(how), layout);
    bindTextures(context, layout, vk::Filter::eLinear, {&picture, 1});
    drawFullScreen(context, layout, kFragments, scale);
}

void wantResampling(gpu::PipelineContext& context, const Resampling& how) {
    wantFullScreen(context, passOf(how), resampleLayout(context));
}

}  // namespace nacre::passes
