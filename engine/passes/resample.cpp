#include "engine/passes/resample.h"

#include "engine/passes/bindings.h"
#include "shaders.h"
#include "shaders/common/layout.h"

namespace nacre::passes {

void resample(gpu::PassContext& context, vk::ImageView picture, const Resampling& how) {
    static constexpr Type kBindings[] = {kSampled};
    constexpr auto kStages = vk::ShaderStageFlagBits::eFragment;
    const std::array<float, 4> scale{1.0f / static_cast<float>(context.extent.width),
                                     1.0f / static_cast<float>(context.extent.height), how.share, 0};
    const gpu::Layout& layout = context.pipelines.layout({"resample layout", kBindings, kStages, sizeof(scale)});
    FullScreenPass pass{shaders::resampleFragment, {}, {}};
    pass.blend = how.add ? gpu::Blend::add : gpu::Blend::replace;
    pass.constants.set(layout::kSamplesId, how.samples);
    pass.constants.set(layout::kCodedId, how.coded);
    if (context.ahead) return wantFullScreen(context, pass, layout);
    bindFullScreen(context, pass, layout);
    bindTextures(context, layout, vk::Filter::eLinear, {&picture, 1});
    drawFullScreen(context, layout, kStages, scale);
}

}  // namespace nacre::passes
