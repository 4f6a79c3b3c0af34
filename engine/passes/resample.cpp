#include "engine/passes/resample.h"

#include "shaders.h"
#include "shaders/common/layout.h"

namespace nacre::passes {
namespace {

constexpr vk::DescriptorType kBindings[] = {vk::DescriptorType::eCombinedImageSampler};

}  // namespace

Resample::Resample(const gpu::Device& device)
    : device_(device),
      sampler_(gpu::makeSampler(device, vk::Filter::eLinear, "picture")),
      layout_(gpu::makeLayout(device, kBindings, vk::ShaderStageFlagBits::eFragment, 16, "resample layout")) {}

vk::Pipeline Resample::pipeline(const gpu::PassContext& context, std::uint32_t samples, bool coded) {
    const auto key = std::make_tuple(static_cast<VkRenderPass>(context.renderPass), context.subpass, samples, coded);
    if (const auto it = pipelines_.find(key); it != pipelines_.end()) return *it->second;
    gpu::GraphicsPipeline d;
    d.name = "resample";
    d.vertex = shaders::screenVertex;
    d.fragment = shaders::resampleFragment;
    d.constants.set(layout::kSamplesId, samples);
    d.constants.set(layout::kCodedId, coded);
    d.layout = *layout_.pipeline;
    d.renderPass = context.renderPass;
    d.subpass = context.subpass;
    d.colorCount = d.colorsWritten = context.colorCount;
    d.strip = false;
    return *pipelines_.emplace(key, gpu::makePipeline(device_, d)).first->second;
}

void Resample::draw(gpu::PassContext& context, vk::ImageView picture, std::uint32_t samples, bool coded) {
    const vk::raii::CommandBuffer& commands = context.commands;
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline(context, samples, coded));
    const vk::DescriptorSet set = context.descriptors.allocate(layout_.set, "resample");
    const vk::DescriptorImageInfo image(*sampler_, picture, vk::ImageLayout::eShaderReadOnlyOptimal);
    device_->updateDescriptorSets(vk::WriteDescriptorSet(set, 0, 0, vk::DescriptorType::eCombinedImageSampler, image),
                                  {});
    commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout_.pipeline, 0, set, {});
    const std::array<float, 4> scale{1.0f / static_cast<float>(context.extent.width),
                                     1.0f / static_cast<float>(context.extent.height), 0, 0};
    commands.pushConstants<float>(*layout_.pipeline, vk::ShaderStageFlagBits::eFragment, 0, scale);
    commands.draw(3, 1, 0, 0);
}

}  // namespace nacre::passes
