#include "engine/passes/resolve.h"

#include "engine/passes/bindings.h"
#include "shaders.h"
#include "shaders/common/layout.h"

namespace nacre::passes {
namespace {

constexpr std::array kOfImage{kSampled, kSampled};
constexpr std::array kOfWords{kTexel, kSampled};

/// As shaders/resolve.frag has them.
struct Push {
    std::int32_t x, y, fromX, fromY, pitch, samples;
};

const gpu::Layout& resolveLayout(gpu::PipelineContext& context, bool words, bool masked) {
    const std::span<const Type> types = words ? kOfWords : kOfImage;
    const char* const name = words ? (masked ? "resolve masked words" : "resolve words")
                                   : (masked ? "resolve masked pixels" : "resolve pixels");
    return context.pipelines.layout({name, types.first(masked ? 2 : 1), kDraw, sizeof(Push)});
}

FullScreenPass makePass(const Resolving& how, bool words) {
    FullScreenPass pass{words ? (how.masked ? shaders::resolveWordsMasked : shaders::resolveWords)
                              : (how.masked ? shaders::resolveImageMasked : shaders::resolveImage),
                        {},
                        {}};
    pass.constants.set(layout::kSamplesId, how.samples > 1);
    pass.constants.set(layout::kCodedId, how.coded);
    return pass;
}

}  // namespace

void resolve(gpu::PassContext& context, const Resolving& how, const ResolvePlace& place, const Resolved& what) {
    const bool words = what.tiles != nullptr;
    const gpu::Layout& layout = resolveLayout(context, words, how.masked);
    const auto at = [](std::uint32_t pixels) { return static_cast<std::int32_t>(pixels); };
    bindFullScreen(context, makePass(how, words), layout);
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    const vk::BufferView texels = words ? what.tiles->pixelTexels() : vk::BufferView();
    const auto sampled = [&](vk::ImageView image) {
        return vk::DescriptorImageInfo(context.pipelines.sampler(vk::Filter::eNearest), image,
                                       vk::ImageLayout::eShaderReadOnlyOptimal);
    };
    const vk::DescriptorImageInfo image = sampled(what.image), mask = sampled(what.mask.value_or(vk::ImageView()));
    const vk::WriteDescriptorSet writes[] = {
        words ? vk::WriteDescriptorSet(set, 0, 0, 1, kTexel, nullptr, nullptr, &texels)
              : vk::WriteDescriptorSet(set, 0, 0, 1, kSampled, &image),
        {set, 1, 0, 1, kSampled, &mask}};
    context.device->updateDescriptorSets(vk::ArrayProxy<const vk::WriteDescriptorSet>(how.masked ? 2 : 1, writes), {});
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, set, {});
    const Push push{at(place.rect.x), at(place.rect.y), place.x, place.y, words ? at(what.tiles->rowPixels()) : 0,
                    at(how.samples)};
    const std::span<const PictureRect> all(&place.rect, 1);
    for (const PictureRect& part : place.parts.empty() ? all : std::span(place.parts)) {
        context.commands.setScissor(0, vk::Rect2D({at(part.x), at(part.y)}, {part.width, part.height}));
        drawFullScreen(context, layout, kDraw, push);
    }
}

}  // namespace nacre::passes
