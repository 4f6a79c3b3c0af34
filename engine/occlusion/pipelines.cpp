#include "engine/occlusion/pipelines.h"

#include "shaders.h"
#include "shaders/common/layout.h"

namespace nacre::occlusion {
namespace {

using Type = vk::DescriptorType;
constexpr auto kCompute = vk::ShaderStageFlagBits::eCompute;
constexpr Type kAccumulate[] = {Type::eStorageBuffer, Type::eUniformBuffer, Type::eStorageBuffer, Type::eStorageBuffer,
                                Type::eCombinedImageSampler};
constexpr Type kThreeBuffers[] = {Type::eStorageBuffer, Type::eStorageBuffer, Type::eStorageBuffer};

}  // namespace

const gpu::Layout& accumulationLayout(gpu::PassContext& context) {
    return context.pipelines.layout(
        {"occlusion accumulation layout", kAccumulate, kCompute, sizeof(layout::OcclusionConstants)});
}

const gpu::Layout& finishLayout(gpu::PassContext& context) {
    return context.pipelines.layout({"occlusion finish layout", kThreeBuffers, kCompute, sizeof(std::uint32_t)});
}

const gpu::Layout& splatLayout(gpu::PassContext& context) {
    return context.pipelines.layout(
        {"depth splatting layout", kThreeBuffers, kCompute, sizeof(layout::SplatConstants)});
}

vk::Pipeline accumulationPipeline(gpu::PassContext& context, const Accumulation& accumulation) {
    gpu::ComputePipeline d{"occlusion accumulation, spheres",
                           shaders::occlusionAccumulateSphere,
                           {},
                           *accumulationLayout(context).pipeline};
    if (accumulation.texels == Texels::wholeSpheres) {
        d.name = "occlusion accumulation, whole spheres";
        d.code = shaders::occlusionAccumulateWhole;
    } else if (accumulation.texels == Texels::cylinders) {
        d.name = "occlusion accumulation, cylinders";
        d.code = shaders::occlusionAccumulateCylinder;
    }
    const graph::EncodedFormat& encoded = context.device.caps().encoded;
    d.constants.set(layout::kBatchId, accumulation.batch);
    d.constants.set(layout::kDepthChannelsId, accumulation.encoded ? encoded.channels : 1);
    d.constants.set(layout::kDepthStepsId, accumulation.encoded ? encoded.steps : 0);
    d.constants.set(layout::kMapsAcrossId, mapsAcross(accumulation.batch));
    if (accumulation.spread > 0) {
        d.constants.set(layout::kTapsId, 4u);
        d.constants.set(layout::kSpreadId, accumulation.spread);
    }
    return context.pipelines.compute(d);
}

vk::Pipeline finishPipeline(gpu::PassContext& context) {
    return context.pipelines.compute(
        {"occlusion finish", shaders::occlusionFinish, {}, *finishLayout(context).pipeline});
}

vk::Pipeline splatPipeline(gpu::PassContext& context, bool cylinders) {
    const vk::PipelineLayout layout = *splatLayout(context).pipeline;
    return cylinders
               ? context.pipelines.compute({"depth splatting, cylinders", shaders::occlusionSplatCylinder, {}, layout})
               : context.pipelines.compute({"depth splatting, spheres", shaders::occlusionSplatSphere, {}, layout});
}

}  // namespace nacre::occlusion
