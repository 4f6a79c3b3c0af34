#include "engine/passes/full_screen.h"

#include "shaders.h"

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

}  // namespace nacre::passes
