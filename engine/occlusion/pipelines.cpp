#include "engine/occlusion/pipelines.h"

#include "engine/gpu/resources.h"
#include "engine/passes/view_constants.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

using Type = vk::DescriptorType;
constexpr auto kCompute = vk::ShaderStageFlagBits::eCompute;
constexpr Type kAccumulate[] = {Type::eStorageBuffer, Type::eUniformBuffer, Type::eStorageBuffer, Type::eStorageBuffer,
                                Type::eCombinedImageSampler};
constexpr Type kThreeBuffers[] = {Type::eStorageBuffer, Type::eStorageBuffer, Type::eStorageBuffer};

}  // namespace

OcclusionPipelines::OcclusionPipelines(const gpu::Device& device)
    : device_(device),
      accumulateLayout_(gpu::makeLayout(device, kAccumulate, kCompute, sizeof(layout::OcclusionConstants),
                                        "occlusion accumulation layout")),
      finishLayout_(gpu::makeLayout(device, kThreeBuffers, kCompute, sizeof(std::uint32_t), "occlusion finish layout")),
      splatLayout_(
          gpu::makeLayout(device, kThreeBuffers, kCompute, sizeof(layout::SplatConstants), "depth splatting layout")),
      sampler_(gpu::makeSampler(device, vk::Filter::eNearest, "depth maps")) {}

vk::Pipeline OcclusionPipelines::accumulation(const Accumulation& key) {
    if (const auto it = accumulations_.find(key); it != accumulations_.end()) return *it->second;
    const graph::EncodedFormat& encoded = device_.caps().encoded;
    gpu::Specialization constants;
    constants.set(layout::kBatchId, key.batch);
    constants.set(layout::kDepthChannelsId, key.encoded ? encoded.channels : 1);
    constants.set(layout::kDepthStepsId, key.encoded ? encoded.steps : 0);
    constants.set(layout::kMapsAcrossId, mapsAcross(key.batch));
    if (key.spread > 0) {
        constants.set(layout::kTapsId, 4u);
        constants.set(layout::kSpreadId, key.spread);
    }
    const auto make = [&](std::span<const std::uint32_t> code, const char* name) {
        return *accumulations_
                    .emplace(key, gpu::makeComputePipeline(device_, code, constants, *accumulateLayout_.pipeline, name))
                    .first->second;
    };
    switch (key.texels) {
        case Texels::wholeSpheres:
            return make(shaders::occlusionAccumulateWhole, "occlusion accumulation, whole spheres");
        case Texels::cylinders:
            return make(shaders::occlusionAccumulateCylinder, "occlusion accumulation, cylinders");
        default:
            return make(shaders::occlusionAccumulateSphere, "occlusion accumulation, spheres");
    }
}

vk::Pipeline OcclusionPipelines::finish() {
    if (!*finish_)
        finish_ = gpu::makeComputePipeline(device_, shaders::occlusionFinish, {}, *finishLayout_.pipeline,
                                           "occlusion finish");
    return *finish_;
}

vk::Pipeline OcclusionPipelines::splatting(bool cylinders) {
    vk::raii::Pipeline& pipeline = cylinders ? cylinderSplats_ : sphereSplats_;
    if (!*pipeline)
        pipeline = cylinders ? gpu::makeComputePipeline(device_, shaders::occlusionSplatCylinder, {},
                                                        *splatLayout_.pipeline, "depth splatting, cylinders")
                             : gpu::makeComputePipeline(device_, shaders::occlusionSplatSphere, {},
                                                        *splatLayout_.pipeline, "depth splatting, spheres");
    return *pipeline;
}

}  // namespace nacre::passes
