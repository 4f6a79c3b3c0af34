#include "engine/passes/deferred_shading.h"

#include "engine/passes/bindings.h"
#include "engine/passes/full_screen.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

// Atlas, effects, shadow map, numbers, shapes, looks, rows of copies.
constexpr Type kPlainInput[] = {kSampled, Type::eUniformBuffer, kSampled, Type::eInputAttachment, kStorage, kStorage,
                                kStorage};
constexpr Type kPlainTexture[] = {kSampled, Type::eUniformBuffer, kSampled, kSampled, kStorage, kStorage, kStorage};
// And what is about primitives.
constexpr Type kRimmedInput[] = {kSampled, Type::eUniformBuffer,  kSampled, Type::eInputAttachment, kStorage, kStorage,
                                 kStorage, Type::eInputAttachment};
constexpr Type kRimmedTexture[] = {kSampled, Type::eUniformBuffer, kSampled, kSampled, kStorage, kStorage, kStorage,
                                   kSampled};

Stage shaderOf(Output output, bool texture) {
    switch (output) {
        case Output::surface:
            return texture ? Stage{shaders::surfaceDeferredSampled, shaders::surfaceDeferredSampledCounting}
                           : Stage{shaders::surfaceDeferredInput, shaders::surfaceDeferredInputCounting};
        case Output::identity:
            return texture ? Stage{shaders::identityDeferredSampled, shaders::identityDeferredSampledCounting}
                           : Stage{shaders::identityDeferredInput, shaders::identityDeferredInputCounting};
        default:
            return texture ? Stage{shaders::colorDeferredSampled, shaders::colorDeferredSampledCounting}
                           : Stage{shaders::colorDeferredInput, shaders::colorDeferredInputCounting};
    }
}

/// @param rims  null: they are not read
void bindReads(gpu::PassContext& context, const SceneView& view, const gpu::Layout& layout, const Reads& reads,
               vk::ImageView rims) {
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    constexpr auto kRead = vk::ImageLayout::eShaderReadOnlyOptimal;
    const bool texture = reads.from == NearestFrom::texture;
    const vk::DescriptorImageInfo atlas(context.pipelines.sampler(vk::Filter::eLinear), reads.atlas, kRead);
    const vk::DescriptorImageInfo numbers(texture ? context.pipelines.sampler(vk::Filter::eNearest) : vk::Sampler(),
                                          reads.nearest, texture ? kRead : context.inputLayout);
    const vk::DescriptorBufferInfo shapes(*view.buffers->shapes.handle, 0, VK_WHOLE_SIZE),
        looks(*view.buffers->looks.handle, 0, VK_WHOLE_SIZE), rows(*view.copyRows->handle, 0, VK_WHOLE_SIZE),
        effects(*view.effectConstants->handle, 0, VK_WHOLE_SIZE);
    const vk::DescriptorImageInfo about(numbers.sampler, rims, kRead);
    const vk::DescriptorImageInfo shadow = shadowOf(context, view, reads.atlas);
    const vk::WriteDescriptorSet writes[] = {
        {set, 0, 0, Type::eCombinedImageSampler, atlas},
        {set, 1, 0, Type::eUniformBuffer, {}, effects},
        {set, 2, 0, Type::eCombinedImageSampler, shadow},
        {set, 3, 0, texture ? Type::eCombinedImageSampler : Type::eInputAttachment, numbers},
        {set, 4, 0, Type::eStorageBuffer, {}, shapes},
        {set, 5, 0, Type::eStorageBuffer, {}, looks},
        {set, 6, 0, Type::eStorageBuffer, {}, rows},
        {set, 7, 0, texture ? Type::eCombinedImageSampler : Type::eInputAttachment, about}};
    context.device->updateDescriptorSets(vk::ArrayProxy<const vk::WriteDescriptorSet>(rims ? 8 : 7, writes), {});
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, set, {});
}

const gpu::Layout& layoutOf(gpu::PipelineContext& context, const SceneView& view, const DeferredPass& pass) {
    const bool texture = pass.reads.from == NearestFrom::texture;
    if (pass.rims)
        return context.pipelines.layout({"deferred shading layout, rims", texture ? kRimmedTexture : kRimmedInput,
                                         kDraw, sizeof(layout::ViewConstants), view.fragments != nullptr});
    return context.pipelines.layout({"deferred shading layout", texture ? kPlainTexture : kPlainInput, kDraw,
                                     sizeof(layout::ViewConstants), view.fragments != nullptr});
}

FullScreenPass fullScreenOf(const SceneView& view, const DeferredPass& deferred) {
    const bool texture = deferred.reads.from == NearestFrom::texture;
    FullScreenPass pass{shaderOf(deferred.output, texture).of(view), {}, {}};
    if (deferred.rims) {
        const Stage stage = texture ? Stage{shaders::rimmedDeferredSampled, shaders::rimmedDeferredSampledCounting}
                                    : Stage{shaders::rimmedDeferredInput, shaders::rimmedDeferredInputCounting};
        pass.fragment = stage.of(view);
        for (int i = 0; i < 4; ++i)
            pass.constants.set(layout::kClearId + i, deferred.rims->clear.value[static_cast<std::size_t>(i)]);
    }
    setGeometryConstants(pass.constants, view);
    setShadingConstants(pass.constants, view);
    pass.constants.set(layout::kCopiesId, view.copies.rows.size() > 3);
    pass.constants.set(layout::kCylindersId, view.buffers->cylinderCount > 0);
    pass.constants.set(layout::kTrianglesId, view.buffers->triangleCount > 0);
    return pass;
}

}  // namespace

void draw(gpu::PassContext& context, const SceneView& view, const DeferredPass& pass) {
    if (view.buffers->empty()) return;
    const gpu::Layout& layout = layoutOf(context, view, pass);
    bindFullScreen(context, fullScreenOf(view, pass), layout);
    bindReads(context, view, layout, pass.reads, pass.rims ? pass.rims->image : vk::ImageView());
    bindCounter(context, view, layout);
    drawFullScreen(context, layout, kDraw, view.constants);
}

void want(gpu::PipelineContext& context, const SceneView& view, const DeferredPass& pass) {
    if (view.buffers->empty()) return;
    wantFullScreen(context, fullScreenOf(view, pass), layoutOf(context, view, pass));
}

}  // namespace nacre::passes
