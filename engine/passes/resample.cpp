#include "engine/passes/resample.h"

#include "engine/passes/bindings.h"
#include "shaders.h"
#include "shaders/common/layout.h"

namespace nacre::passes {
namespace {

constexpr Type kPicture[] = {kSampled};
constexpr auto kFragments = vk::ShaderStageFlagBits::eFragment;
using Scale = std::array<float, 4>;

const gpu::Layout& resampleLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"resample layout", kPicture, kFragments, sizeof(Scale)});
}

FullScreenPass passOf(const Resampling& how) {
    FullScreenPass pass{shaders::resampleFragment, {}, {}};
    pass.blend = how.add ? gpu::Blend::add : gpu::Blend::replace;
    pass.constants.set(layout::kSamplesId, how.samples);
    pass.constants.set(layout::kCodedId, how.coded);
    return pass;
}

}  // namespace

void resample(gpu::PassContext& context, vk::ImageView picture, const Resampling& how) {
    const Scale scale{1.0f / static_cast<float>(context.extent.width), 1.0f / static_cast<float>(context.extent.height),
                      how.share, 0};
    const gpu::Layout& layout = resampleLayout(context);
    bindFullScreen(context, passOf(how), layout);
    bindTextures(context, layout, vk::Filter::eLinear, {&picture, 1});
    drawFullScreen(context, layout, kFragments, scale);
}

void wantResampling(gpu::PipelineContext& context, const Resampling& how) {
    wantFullScreen(context, passOf(how), resampleLayout(context));
}

}  // namespace nacre::passes
