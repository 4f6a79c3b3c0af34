#include "engine/passes/lens.h"

#include <algorithm>
#include <array>

#include "engine/passes/bindings.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

constexpr std::array kLensImages{kSampled, kSampled, kSampled};
constexpr auto kLensStages = vk::ShaderStageFlagBits::eFragment;

const gpu::Layout& lensLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"lens layout", kLensImages, kLensStages, sizeof(Lens)});
}

FullScreenPass passOf(LensStep step) {
    switch (step) {
        case LensStep::circles:
            return {shaders::lensCircles, {}, {}};
        case LensStep::reach:
            return {shaders::lensReach, {}, {}};
        case LensStep::spread:
            return {shaders::lensSpread, {}, {}};
        case LensStep::gather:
            break;
    }
    return {shaders::lensGather, {}, {}};
}

}  // namespace

void drawLens(gpu::PassContext& context, LensStep step, const Lens& lens, std::span<const vk::ImageView> images) {
    // Always written, even if the shader reads fewer: lavapipe accesses all.
    std::array<vk::ImageView, kLensImages.size()> views;
    views.fill(images[0]);
    std::copy(images.begin(), images.end(), views.begin());
    const gpu::Layout& layout = lensLayout(context);
    bindFullScreen(context, passOf(step), layout);
    bindTextures(context, layout, vk::Filter::eNearest, views);
    drawFullScreen(context, layout, kLensStages, lens);
}

void wantLens(gpu::PipelineContext& context, LensStep step) {
    wantFullScreen(context, passOf(step), lensLayout(context));
}

}  // namespace nacre::passes
