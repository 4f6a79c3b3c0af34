#include "engine/frame/effects/lens/lens_pass.h"

#include <algorithm>
#include <array>

#include "engine/passes/bindings.h"
#include "shaders.h"
#include "shaders/common/layout.h"

namespace nacre::passes {
namespace {

constexpr std::array kLensImages{kSampled, kSampled, kSampled};
constexpr auto kLensStages = vk::ShaderStageFlagBits::eFragment;

const gpu::Layout& lensLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"lens layout", kLensImages, kLensStages, sizeof(Lens)});
}

gpu::ShaderWords chooseShader(LensStep step) {
    switch (step) {
        case LensStep::circles:
            return shaders::lensCircles;
        case LensStep::reach:
            return shaders::lensReach;
        case LensStep::spread:
            return shaders::lensSpread;
        case LensStep::soft:
            return shaders::lensSoft;
        case LensStep::gather:
            break;
    }
    return shaders::lensGather;
}

FullScreenPass makePass(const LensPass& pass) {
    FullScreenPass drawn{chooseShader(pass.step), {}, {}};
    drawn.constants.set(layout::kCodedId, pass.coded);
    return drawn;
}

}  // namespace

void drawLens(gpu::PassContext& context, const LensPass& pass, const Lens& lens, std::span<const vk::ImageView> images,
              std::span<const PictureRect> parts) {
    // Always written, even if the shader reads fewer: lavapipe accesses all.
    std::array<vk::ImageView, kLensImages.size()> views;
    views.fill(images[0]);
    std::copy(images.begin(), images.end(), views.begin());
    const gpu::Layout& layout = lensLayout(context);
    bindFullScreen(context, makePass(pass), layout);
    bindTextures(context, layout, vk::Filter::eNearest, views);
    for (const PictureRect& part : parts) {
        const vk::Offset2D first(static_cast<std::int32_t>(part.x), static_cast<std::int32_t>(part.y));
        context.commands.setScissor(0, vk::Rect2D(first, {part.width, part.height}));
        drawFullScreen(context, layout, kLensStages, lens);
    }
}

void wantLens(gpu::PipelineContext& context, const LensPass& pass) {
    wantFullScreen(context, makePass(pass), lensLayout(context));
}

}  // namespace nacre::passes
