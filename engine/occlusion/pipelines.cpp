#include "engine/occlusion/pipelines.h"

#include <span>

#include "engine/passes/bindings.h"
#include "engine/software/software.h"
#include "shaders.h"
#include "shaders/common/layout.h"

namespace nacre::occlusion {
namespace {

using passes::kCompute;
using passes::kStorage;
using passes::kTexel;
using passes::Type;
constexpr std::array kAccumulate{kStorage, Type::eUniformBuffer, kStorage, kStorage, Type::eCombinedImageSampler};
constexpr std::array kAccumulateStorage{kStorage, Type::eUniformBuffer, kStorage, kStorage, kStorage};
constexpr std::array kAccumulateTexels{kTexel, kTexel, kStorage, kStorage, kTexel};
// Shapes, rows of copies, lists, heights for reading and for writing.
constexpr std::array kThreeBuffers{kStorage, kStorage, kStorage};

/// Whether heights are read as texels.
bool asTexels(const graph::TileCaps& caps) { return caps.texels && !caps.lists; }

}  // namespace

const gpu::Layout& accumulationLayout(gpu::PipelineContext& context, bool heights) {
    const auto types = [&]() -> std::span<const Type> {
        if (!heights) return kAccumulate;
        if (asTexels(context.device.caps().tiles)) return kAccumulateTexels;
        return kAccumulateStorage;
    }();
    return context.pipelines.layout(
        {"occlusion accumulation layout", types, kCompute, sizeof(layout::OcclusionConstants)});
}

const gpu::Layout& finishLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"occlusion finish layout", kThreeBuffers, kCompute, sizeof(std::uint32_t)});
}

/// The accumulation shader of a kind of texels that samples depth maps. Narrow directions come in pairs, except for
/// cylinders: pairs would need more registers than Mali has.
#define NACRE_ACCUMULATION(of)                            \
    (heights  ? shaders::occlusionAccumulate##of##Storage \
     : narrow ? shaders::occlusionAccumulate##of##Narrow  \
              : shaders::occlusionAccumulate##of)

bool asksByPairs(const Accumulation& accumulation) {
    return accumulation.narrow && accumulation.texels != Texels::cylinders;
}

gpu::ComputePipeline accumulationPipeline(gpu::PipelineContext& context, const Accumulation& accumulation) {
    const bool heights = accumulation.heights, narrow = accumulation.narrow;
    gpu::ComputePipeline d{"occlusion accumulation, spheres",
                           NACRE_ACCUMULATION(Sphere),
                           {},
                           *accumulationLayout(context, heights).pipeline};
    if (accumulation.texels == Texels::wholeSpheres) {
        d.name = "occlusion accumulation, whole spheres";
        d.code = NACRE_ACCUMULATION(Whole);
    } else if (accumulation.texels == Texels::cylinders) {
        d.name = "occlusion accumulation, cylinders";
        d.code = NACRE_ACCUMULATION(Cylinder);
    } else if (accumulation.texels == Texels::vertices) {
        d.name = "occlusion accumulation, vertices";
        d.code = NACRE_ACCUMULATION(Vertex);
    }
    const bool texels = heights && asTexels(context.device.caps().tiles);
    if (texels) d.code = questionsToTexelMaps(accumulation.texels);
    if (heights) d.constants.set(layout::kOrderedBitsId, context.device.caps().tiles.lists);
    const graph::EncodedFormat& encoded = context.device.caps().encodedMaps;
    d.constants.set(layout::kBatchId, accumulation.batch);
    d.constants.set(layout::kDepthChannelsId, accumulation.encoded ? encoded.channels : 1);
    d.constants.set(layout::kDepthStepsId, accumulation.encoded ? encoded.steps : 0);
    d.constants.set(layout::kMapsAcrossId, accumulation.across);
    d.constants.set(layout::kEllipsoidsId, accumulation.ellipsoids ? 1 : 0);
    if (texels) d.constants.set(layout::kLanesId, context.device.caps().tiles.lanes);
    if (accumulation.spread > 0) {
        d.constants.set(layout::kTapsId, accumulation.taps);
        d.constants.set(layout::kSpreadId, accumulation.spread);
    }
    return d;
}

gpu::ComputePipeline finishPipeline(gpu::PipelineContext& context) {
    return {"occlusion finish", shaders::occlusionFinish, {}, *finishLayout(context).pipeline};
}

}  // namespace nacre::occlusion
