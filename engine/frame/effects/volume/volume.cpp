#include "engine/frame/effects/volume/volume.h"

#include <array>
#include <optional>

#include "engine/frame/effects/volume/volume_textures.h"
#include "engine/frame/record.h"
#include "engine/passes/bindings.h"
#include "engine/passes/full_screen.h"
#include "engine/passes/primitives.h"
#include "engine/passes/scene_view.h"
#include "shaders.h"

namespace nacre {
namespace {

using passes::kSampled;
using passes::NearestFrom;
using passes::SceneView;
using passes::VolumeTextures;
using Type = vk::DescriptorType;

constexpr auto kFragments = vk::ShaderStageFlagBits::eFragment;

/// Depths that limit a part of the volume.
struct Limits {
    graph::Image opaque;
    std::optional<graph::Image> behind, before;  ///< layers
};

/// A brick, effects, its constants, the opaque depth, and those of the two layers.
constexpr std::array<Type, 6> listBindings(Type opaque) {
    return {kSampled, Type::eUniformBuffer, Type::eUniformBuffer, opaque, kSampled, kSampled};
}
constexpr auto kInputBindings = listBindings(Type::eInputAttachment), kTextureBindings = listBindings(kSampled);

const gpu::Layout& passLayout(gpu::PipelineContext& context, NearestFrom from) {
    return context.pipelines.layout({"volume layout", from == NearestFrom::texture ? kTextureBindings : kInputBindings,
                                     kFragments, sizeof(layout::ViewConstants)});
}

passes::FullScreenPass makePass(const SceneView& view, NearestFrom from, const Limits& limits) {
    passes::FullScreenPass pass{from == NearestFrom::texture ? shaders::volumeSampled : shaders::volumeInput, {}, {}};
    pass.blend = gpu::Blend::premultiplied;
    passes::setGeometryConstants(pass.constants, view);
    pass.constants.set(layout::kFogId, view.effects.fog.range != Fog::Range::off);
    pass.constants.set(layout::kBehindLayerId, limits.behind.has_value());
    pass.constants.set(layout::kBeforeLayerId, limits.before.has_value());
    return pass;
}

/// The viewer, in nodes of the volume, for VolumeTextures::farthestFirst().
glm::dvec4 findEye(const SceneView& view, const Volume& volume) {
    const auto rows = std::array{glm::dvec4(view.still[0]), glm::dvec4(view.still[1]), glm::dvec4(view.still[2])};
    const auto turnBack = [&](const glm::dvec3& v) {
        return glm::dvec3(rows[0]) * v.x + glm::dvec3(rows[1]) * v.y + glm::dvec3(rows[2]) * v.z;
    };
    const glm::dvec3 shift(rows[0].w, rows[1].w, rows[2].w);
    const double one = view.perspective ? 1 : 0;
    const glm::dvec3 place =
        turnBack(view.perspective ? glm::dvec3(0, 0, view.constants.origin) - shift : glm::dvec3(0, 0, 1));
    return {volume.toNode * glm::dvec4(place, one), one};
}

void bindBrick(gpu::PassContext& c, const SceneView& view, const gpu::Layout& layout,
               const VolumeTextures::Brick& brick, NearestFrom from, const Limits& limits) {
    const vk::DescriptorSet set = c.descriptors.allocate(layout.set, c.pass);
    constexpr auto kRead = vk::ImageLayout::eShaderReadOnlyOptimal;
    const vk::Sampler nearestTexel = c.pipelines.sampler(vk::Filter::eNearest);
    const bool texture = from == NearestFrom::texture;
    const vk::DescriptorImageInfo nodes(c.pipelines.sampler(vk::Filter::eLinear), *brick.texture.view, kRead),
        opaque(texture ? nearestTexel : vk::Sampler(), c.view(limits.opaque), texture ? kRead : c.inputLayout);
    // Always written: a binding that the shader does not read takes any texture.
    const auto layerImage = [&](const std::optional<graph::Image>& layer) {
        return layer ? vk::DescriptorImageInfo(nearestTexel, c.view(*layer), kRead)
                     : vk::DescriptorImageInfo(nearestTexel, *view.volume->flat().view, kRead);
    };
    const vk::DescriptorImageInfo behind = layerImage(limits.behind), before = layerImage(limits.before);
    const vk::DescriptorBufferInfo effects(*view.effectConstants->handle, 0, VK_WHOLE_SIZE),
        constants(*brick.constants.handle, 0, VK_WHOLE_SIZE);
    const vk::WriteDescriptorSet writes[] = {
        {set, 0, 0, kSampled, nodes},
        {set, 1, 0, Type::eUniformBuffer, {}, effects},
        {set, 2, 0, Type::eUniformBuffer, {}, constants},
        {set, 3, 0, texture ? kSampled : Type::eInputAttachment, opaque},
        {set, 4, 0, kSampled, behind},
        {set, 5, 0, kSampled, before},
    };
    c.device->updateDescriptorSets(writes, {});
    c.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, set, {});
}

void drawVolume(gpu::PassContext& c, const SceneView& view, NearestFrom from, const Limits& limits) {
    if (!view.volume) return;
    const gpu::Layout& layout = passLayout(c, from);
    passes::bindFullScreen(c, makePass(view, from, limits), layout);
    layout::ViewConstants constants = view.constants;
    constants.row0 = view.still[0], constants.row1 = view.still[1], constants.row2 = view.still[2];
    for (const VolumeTextures::Brick* brick : view.volume->farthestFirst(findEye(view, view.volume->volume()))) {
        bindBrick(c, view, layout, *brick, from, limits);
        passes::drawFullScreen(c, layout, kFragments, constants);
    }
}

}  // namespace

void declareVolume(Frame& f, const FrameChoice& choice, std::uint32_t layer) {
    if (!choice.has(Effect::Kind::volume)) return;
    // Coarse encoded depth is settled by the depth buffer, which holds the exact depth.
    const bool encoded = f.encoding && !f.encoding->settles();
    Limits limits{encoded ? f.nearest : f.depth, {}, {}};
    if (layer > 0) limits.behind = f.layerDepths[layer - 1];
    if (layer < choice.layers()) limits.before = f.layerDepths[layer];
    graph::PassBuilder pass = f.graph.graphics("volume");
    encoded ? pass.input(limits.opaque) : pass.samples(limits.opaque);
    if (limits.behind) pass.samples(*limits.behind);
    if (limits.before) pass.samples(*limits.before);
    pass.color(f.targets[0]).record(records(f, [=](gpu::PassContext& c, const SceneView& view) {
        drawVolume(c, view, encoded ? fromEarlierPass(c) : NearestFrom::texture, limits);
    }));
}

}  // namespace nacre
