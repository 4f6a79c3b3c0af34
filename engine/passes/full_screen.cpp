#include "engine/passes/full_screen.h"

#include <algorithm>

#include "engine/passes/bindings.h"
#include "shaders.h"
#include "shaders/common/layout.h"

namespace nacre::passes {
namespace {

gpu::GraphicsPipeline describePipeline(const gpu::PipelineContext& context, const FullScreenPass& pass,
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
    // A driver may lose the view of clipped primitives. A larger triangle would be clipped at its corners.
    if (context.views > 1) d.constants.set(layout::kCornersId, 4);
    d.strip = context.views > 1;
    return d;
}

}  // namespace

void bindFullScreen(gpu::PassContext& context, const FullScreenPass& pass, const gpu::Layout& layout) {
    const vk::Pipeline pipeline = context.pipelines.graphics(describePipeline(context, pass, layout));
    context.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline);
}

void wantFullScreen(gpu::PipelineContext& context, const FullScreenPass& pass, const gpu::Layout& layout) {
    context.pipelines.want(describePipeline(context, pass, layout));
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

constexpr Type kPicture[] = {kSampled}, kOwnPixel[] = {Type::eInputAttachment};
constexpr auto kFragments = vk::ShaderStageFlagBits::eFragment;
/// As shaders/resample.frag has them.
struct Resampled {
    std::array<float, 4> scale, red, green, blue;
};

const gpu::Layout& resampleLayout(gpu::PipelineContext& context, const Resampling& how) {
    const bool texture = how.from == NearestFrom::texture;
    return context.pipelines.layout({texture ? "resample layout" : "resample layout, own pixel",
                                     texture ? kPicture : kOwnPixel, kFragments, sizeof(Resampled)});
}

FullScreenPass makePass(const Resampling& how) {
    FullScreenPass pass{shaders::resampleFragment, {}, {}};
    if (how.from == NearestFrom::inputAttachment) pass.fragment = shaders::resampleInputFragment;
    if (how.layer) pass.fragment = shaders::resampleLayerFragment, pass.detail = "layer";
    pass.blend = how.add ? gpu::Blend::add : gpu::Blend::replace;
    pass.constants.set(layout::kSamplesId, how.samples);
    pass.constants.set(layout::kCodedId, how.coded);
    return pass;
}

/// Binds an input attachment at set 0, binding 0.
void bindInput(gpu::PassContext& context, const gpu::Layout& layout, vk::ImageView attachment) {
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    const vk::DescriptorImageInfo info({}, attachment, context.inputLayout);
    context.device->updateDescriptorSets(vk::WriteDescriptorSet(set, 0, 0, vk::DescriptorType::eInputAttachment, info),
                                         {});
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, set, {});
}

}  // namespace

void resample(gpu::PassContext& context, vk::ImageView picture, const Resampling& how) {
    const vk::Rect2D whole({}, {context.extent.width, context.extent.height});
    const vk::Rect2D part = how.part.extent.width == 0 ? whole : how.part;
    const auto at = [](auto pixels) { return static_cast<float>(pixels); };
    const auto row = [&](std::size_t i, float more) {
        return std::array{how.channels[i][0], how.channels[i][1], how.channels[i][2], more};
    };
    const Resampled push{{1 / at(part.extent.width), 1 / at(part.extent.height), how.share, 0},
                         row(0, at(part.offset.x)),
                         row(1, at(part.offset.y)),
                         row(2, at(how.layer.value_or(0)))};
    const gpu::Layout& layout = resampleLayout(context, how);
    bindFullScreen(context, makePass(how), layout);
    if (how.from == NearestFrom::texture)
        bindTextures(context, layout, vk::Filter::eLinear, {&picture, 1});
    else
        bindInput(context, layout, picture);
    const auto right = part.offset.x + static_cast<std::int32_t>(part.extent.width);
    const auto bottom = part.offset.y + static_cast<std::int32_t>(part.extent.height);
    const std::int32_t x = std::max(part.offset.x, 0), y = std::max(part.offset.y, 0);
    context.commands.setScissor(0, vk::Rect2D({x, y}, {static_cast<std::uint32_t>(std::max(right - x, 0)),
                                                       static_cast<std::uint32_t>(std::max(bottom - y, 0))}));
    drawFullScreen(context, layout, kFragments, push);
}

void wantResampling(gpu::PipelineContext& context, const Resampling& how) {
    wantFullScreen(context, makePass(how), resampleLayout(context, how));
}

}  // namespace nacre::passes
