#include "engine/passes/debug_pass.h"

#include "shaders.h"

namespace nacre::passes {
namespace {

constexpr vk::DescriptorType kBindings[] = {vk::DescriptorType::eCombinedImageSampler,
                                            vk::DescriptorType::eCombinedImageSampler};

std::span<const std::uint32_t> shaderOf(const DebugPass::Draw& draw) {
    if (draw.tileMean) return shaders::tileMean;
    switch (draw.view) {
        case DebugView::none:
            return {};
        case DebugView::depth:
            return shaders::debugDepth;
        case DebugView::encoded:
            return shaders::debugEncoded;
        case DebugView::plates:
            return shaders::debugPlates;
        case DebugView::overdraw:
            return shaders::debugOverdraw;
        case DebugView::occlusion:
            return shaders::debugOcclusion;
        case DebugView::patches:
            return shaders::debugPatches;
        case DebugView::id:
            return shaders::debugId;
        case DebugView::normals:
            return shaders::debugNormals;
        case DebugView::tiles:
            return shaders::debugTiles;
    }
    return {};
}

}  // namespace

DebugPass::DebugPass(const gpu::Device& device)
    : device_(device),
      sampler_(gpu::makeSampler(device, vk::Filter::eNearest, "debug view")),
      layout_(gpu::makeLayout(device, kBindings, vk::ShaderStageFlagBits::eFragment, sizeof(layout::ViewConstants),
                              "debug view layout")) {}

vk::Pipeline DebugPass::pipeline(const gpu::PassContext& context, const Draw& draw) {
    const Key key{draw.view, draw.tileMean, draw.perspective, draw.quarterTurns, context.renderPass, context.subpass};
    if (const auto it = pipelines_.find(key); it != pipelines_.end()) return *it->second;
    gpu::GraphicsPipeline d;
    d.name = draw.tileMean ? "tile mean" : std::string("debug view, ") + debugViewNames()[static_cast<int>(draw.view)];
    d.vertex = shaders::screenVertex;
    d.fragment = shaderOf(draw);
    d.constants.set(layout::kPerspectiveId, draw.perspective);
    d.constants.set(layout::kDepthChannelsId, device_.caps().encoded.channels);
    d.constants.set(layout::kDepthStepsId, device_.caps().encoded.steps);
    d.constants.set(layout::kQuarterTurnsId, draw.quarterTurns);
    d.constants.set(layout::kTileId, draw.tile);
    d.layout = *layout_.pipeline;
    d.renderPass = context.renderPass;
    d.subpass = context.subpass;
    d.colorCount = d.colorsWritten = context.colorCount;
    d.strip = false;
    return *pipelines_.emplace(key, gpu::makePipeline(device_, d)).first->second;
}

void DebugPass::draw(gpu::PassContext& context, const Draw& draw, vk::ImageView source, vk::ImageView under) {
    const vk::raii::CommandBuffer& commands = context.commands;
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline(context, draw));
    const vk::DescriptorSet set = context.descriptors.allocate(layout_.set, "debug view");
    constexpr auto kRead = vk::ImageLayout::eShaderReadOnlyOptimal;
    // Never left unwritten, even where the shader reads one image: lavapipe looks at both.
    const vk::DescriptorImageInfo images[] = {{*sampler_, source, kRead}, {*sampler_, under ? under : source, kRead}};
    device_->updateDescriptorSets(vk::WriteDescriptorSet(set, 0, 0, vk::DescriptorType::eCombinedImageSampler, images),
                                  {});
    commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout_.pipeline, 0, set, {});
    commands.pushConstants<layout::ViewConstants>(*layout_.pipeline, vk::ShaderStageFlagBits::eFragment, 0,
                                                  draw.constants);
    commands.draw(3, 1, 0, 0);
}

}  // namespace nacre::passes
