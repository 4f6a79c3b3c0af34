#include "engine/passes/translucent.h"

#include <algorithm>
#include <utility>

#include "engine/passes/bindings.h"
#include "engine/passes/full_screen.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

using Call = PlacedCopies::Call;
/// Atlas, effects, shadow map, numbers, shapes, looks, rows of copies, nearest depth.
std::span<const Type> bindingsOf(NearestFrom from) {
    static constexpr Type kTested[] = {kSampled, Type::eUniformBuffer, kSampled, kSampled, kStorage, kStorage,
                                       kStorage};
    static constexpr Type kInput[] = {kSampled, Type::eUniformBuffer,  kSampled, kSampled, kStorage, kStorage,
                                      kStorage, Type::eInputAttachment};
    static constexpr Type kTexture[] = {
        kSampled, Type::eUniformBuffer, kSampled, kSampled, kStorage, kStorage, kStorage, kSampled};
    switch (from) {
        case NearestFrom::inputAttachment:
            return kInput;
        case NearestFrom::texture:
            return kTexture;
        default:
            return kTested;
    }
}

Stage shaderOf(NearestFrom from) {
    switch (from) {
        case NearestFrom::inputAttachment:
            return {shaders::translucentNearestInput, shaders::translucentNearestInputCounting};
        case NearestFrom::texture:
            return {shaders::translucentNearestSampled, shaders::translucentNearestSampledCounting};
        default:
            return {shaders::translucentTested, shaders::translucentTestedCounting};
    }
}

/// The part of a call from one triangle to another, if there is one.
void addPart(const Call& call, std::uint32_t first, std::uint32_t end, std::vector<Call>& list) {
    first = std::max(first, call.first);
    end = std::min(end, call.first + call.count);
    if (first < end) list.push_back({call.copy, first, end - first});
}

void bindLayer(gpu::PassContext& context, const SceneView& view, const gpu::Layout& layout, vk::ImageView atlas,
               vk::ImageView numbers, const Opaque& opaque) {
    constexpr auto kRead = vk::ImageLayout::eShaderReadOnlyOptimal;
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    const vk::Sampler nearestTexel = context.pipelines.sampler(vk::Filter::eNearest);
    const bool texture = opaque.from == NearestFrom::texture;
    const vk::DescriptorImageInfo light(context.pipelines.sampler(vk::Filter::eLinear), atlas, kRead),
        shadow = shadowOf(context, view, atlas), layer(nearestTexel, numbers, kRead),
        nearest(texture ? nearestTexel : vk::Sampler(), opaque.nearest, kRead);
    const vk::DescriptorBufferInfo shapes(*view.buffers->shapes.handle, 0, VK_WHOLE_SIZE),
        looks(*view.buffers->looks.handle, 0, VK_WHOLE_SIZE), rows(*view.copyRows->handle, 0, VK_WHOLE_SIZE),
        effects(*view.effectConstants->handle, 0, VK_WHOLE_SIZE);
    const vk::WriteDescriptorSet writes[] = {
        {set, 0, 0, kSampled, light},      {set, 1, 0, Type::eUniformBuffer, {}, effects},
        {set, 2, 0, kSampled, shadow},     {set, 3, 0, kSampled, layer},
        {set, 4, 0, kStorage, {}, shapes}, {set, 5, 0, kStorage, {}, looks},
        {set, 6, 0, kStorage, {}, rows},   {set, 7, 0, texture ? kSampled : Type::eInputAttachment, nearest}};
    const bool tested = opaque.from == NearestFrom::depthBuffer;
    context.device->updateDescriptorSets(vk::ArrayProxy<const vk::WriteDescriptorSet>(tested ? 7 : 8, writes), {});
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, set, {});
}

}  // namespace

void choose(std::vector<Call>& calls, const TranslucentRuns& runs, Triangles which) {
    if (runs.empty() && which == Triangles::translucent) calls.clear();
    if (runs.empty()) return;
    std::vector<Call> list;
    for (const Call& call : calls) {
        std::uint32_t at = call.first;
        for (const TranslucentRun& run : runs) {
            if (which == Triangles::solid && run.kind == Translucency::dense) continue;
            if (which == Triangles::translucent) {
                addPart(call, run.first, run.first + run.count, list);
                continue;
            }
            addPart(call, at, run.first, list);
            at = std::max(at, run.first + run.count);
        }
        if (which != Triangles::translucent) addPart(call, at, call.first + call.count, list);
    }
    calls = std::move(list);
}

void seeTranslucent(SceneView& view, const SceneView& all, const TranslucentRuns& runs) {
    view = all;
    view.copies.spheres.clear();
    view.copies.cylinders.clear();
    choose(view.copies.triangles, runs, Triangles::translucent);
    view.effects.contours.width = 0;
    view.rims = {};
    view.constants.contourWidth = 0;
    view.coded = false;  // layers are blended, in linear light
}

void shadeTranslucentLayer(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas, vk::ImageView numbers,
                           const Opaque& opaque) {
    if (view.copies.triangles.empty()) return;
    const gpu::Layout& layout = context.pipelines.layout({"translucent shading layout", bindingsOf(opaque.from), kDraw,
                                                          sizeof(layout::ViewConstants), view.fragments != nullptr});
    FullScreenPass pass{shaderOf(opaque.from).of(view), {}, "layer"};
    pass.blend = gpu::Blend::over;
    pass.depth = opaque.from == NearestFrom::depthBuffer ? gpu::DepthUse::test : gpu::DepthUse::none;
    setGeometryConstants(pass.constants, view);
    setShadingConstants(pass.constants, view);
    pass.constants.set(layout::kDepthChannelsId, opaque.encoding.channels);
    pass.constants.set(layout::kDepthStepsId, opaque.encoding.steps);
    bindFullScreen(context, pass, layout);
    bindLayer(context, view, layout, atlas, numbers, opaque);
    bindCounter(context, view, layout);
    drawFullScreen(context, layout, kDraw, view.constants);
}

}  // namespace nacre::passes
