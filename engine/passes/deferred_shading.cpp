#include "engine/passes/deferred_shading.h"

#include <array>
#include <span>

#include "engine/gpu/two_view_shader.h"
#include "engine/passes/bindings.h"
#include "engine/passes/full_screen.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

/// Atlas, effects, shadow map, numbers, shapes, looks, rows of copies; where there are any, rims.
constexpr std::array<Type, 8> listBindings(Type image) {
    return {kSampled, Type::eUniformBuffer, kSampled, image, kStorage, kStorage, kStorage, image};
}
constexpr auto kAllInput = listBindings(Type::eInputAttachment), kAllSampled = listBindings(kSampled);

#define NACRE_NUMBERS(name) (texture ? NACRE_STAGE(name##Sampled) : NACRE_STAGE(name##Input))

Stage chooseShader(const DeferredPass& pass) {
    const bool texture = pass.reads.from == NearestFrom::texture;
    if (pass.over) return NACRE_STAGE(translucentLayer);
    if (pass.rims) return NACRE_NUMBERS(rimmedDeferred);
    if (pass.depth) return NACRE_STAGE(colorDeferredDepth);
    if (pass.output == Output::surface) return NACRE_NUMBERS(surfaceDeferred);
    return pass.output == Output::identity ? NACRE_NUMBERS(identityDeferred) : NACRE_NUMBERS(colorDeferred);
}

const gpu::Layout& passLayout(gpu::PipelineContext& context, const SceneView& view, const DeferredPass& pass) {
    const std::span<const Type> all = pass.reads.from != NearestFrom::texture ? kAllInput : kAllSampled;
    return context.pipelines.layout({"deferred shading layout", all.first(pass.rims ? 8 : 7), kDraw,
                                     sizeof(layout::ViewConstants), view.fragments != nullptr});
}

void bindReads(gpu::PassContext& context, const SceneView& view, const gpu::Layout& layout, const DeferredPass& pass) {
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    constexpr auto kRead = vk::ImageLayout::eShaderReadOnlyOptimal;
    const vk::Sampler nearestTexel = context.pipelines.sampler(vk::Filter::eNearest);
    const bool texture = pass.reads.from == NearestFrom::texture;
    const vk::DescriptorImageInfo atlas(context.pipelines.sampler(vk::Filter::eLinear), pass.reads.atlas, kRead),
        shadow = describeShadow(context, view, pass.reads.atlas),
        numbers(texture ? nearestTexel : vk::Sampler(), pass.reads.nearest, texture ? kRead : context.inputLayout),
        rims(texture ? nearestTexel : vk::Sampler(), pass.rims ? pass.rims->image : vk::ImageView(), kRead);
    const vk::DescriptorBufferInfo shapes(*view.buffers->shapes.handle, 0, VK_WHOLE_SIZE),
        looks(*view.buffers->looks.handle, 0, VK_WHOLE_SIZE), rows(*view.copyRows->handle, 0, VK_WHOLE_SIZE),
        effects(*view.effectConstants->handle, 0, VK_WHOLE_SIZE);
    const vk::WriteDescriptorSet writes[] = {
        {set, 0, 0, kSampled, atlas},      {set, 1, 0, Type::eUniformBuffer, {}, effects},
        {set, 2, 0, kSampled, shadow},     {set, 3, 0, texture ? kSampled : Type::eInputAttachment, numbers},
        {set, 4, 0, kStorage, {}, shapes}, {set, 5, 0, kStorage, {}, looks},
        {set, 6, 0, kStorage, {}, rows},   {set, 7, 0, texture ? kSampled : Type::eInputAttachment, rims}};
    context.device->updateDescriptorSets(vk::ArrayProxy<const vk::WriteDescriptorSet>(rims.imageView ? 8 : 7, writes),
                                         {});
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, set, {});
}

FullScreenPass makeFullScreen(const gpu::PipelineContext& context, const SceneView& view,
                              const DeferredPass& deferred) {
    FullScreenPass pass{gpu::forViews(chooseShader(deferred).of(view), context.views), {}, {}};
    if (deferred.depth) pass.depth = gpu::DepthUse::write;
    if (deferred.rims)
        for (int i = 0; i < 4; ++i)
            pass.constants.set(layout::kClearId + i, deferred.rims->clear.value[static_cast<std::size_t>(i)]);
    if (deferred.over) {
        pass.detail = "layer";
        pass.blend = gpu::Blend::over;
        pass.depth = gpu::DepthUse::test;
    }
    setGeometryConstants(pass.constants, view);
    setShadingConstants(pass.constants, view);
    pass.constants.set(layout::kCopiesId, view.copies.rows.size() > 3);
    pass.constants.set(layout::kCylindersId, view.buffers->cylinderCount > 0);
    pass.constants.set(layout::kTrianglesId, view.buffers->triangleCount > 0);
    return pass;
}

bool isEmpty(const SceneView& view, const DeferredPass& pass) {
    const PlacedCopies& drawn = view.copies;
    return pass.over ? drawn.spheres.empty() && drawn.cylinders.empty() && drawn.triangles.empty()
                     : view.buffers->empty();
}

}  // namespace

void draw(gpu::PassContext& context, const SceneView& view, const DeferredPass& pass) {
    if (isEmpty(view, pass)) return;
    const gpu::Layout& layout = passLayout(context, view, pass);
    bindFullScreen(context, makeFullScreen(context, view, pass), layout);
    bindReads(context, view, layout, pass);
    bindCounter(context, view, layout);
    layout::ViewConstants constants = view.constants;
    if (context.views > 1) {
        constants.numberBefore = static_cast<std::uint32_t>(view.copies.rows.size());
        constants.contourDepth = view.otherAxis;
    }
    drawFullScreen(context, layout, kDraw, constants);
}

void want(gpu::PipelineContext& context, const SceneView& view, const DeferredPass& pass) {
    if (isEmpty(view, pass)) return;
    wantFullScreen(context, makeFullScreen(context, view, pass), passLayout(context, view, pass));
}

}  // namespace nacre::passes
