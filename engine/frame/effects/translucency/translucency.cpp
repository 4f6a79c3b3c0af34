#include "engine/frame/effects/translucency/translucency.h"

#include "engine/frame/record.h"
#include "engine/passes/bindings.h"
#include "engine/passes/deferred_shading.h"
#include "engine/passes/full_screen.h"
#include "engine/passes/geometry_passes.h"
#include "engine/passes/select_opacity.h"
#include "engine/passes/tile_frame.h"
#include "engine/tiles/lanes/lane_passes.h"
#include "engine/tiles/tiles.h"
#include "shaders.h"

namespace nacre {
namespace {

using graph::Clear;
using passes::NearestFrom;
using passes::SceneView;

/// A layer: the nearest primitives behind the previous layer. @param before  its depth; none: the first layer
passes::GeometryPass layerPass(const std::optional<passes::Reads>& before) {
    static const passes::PrimitiveShaders kFirst = NACRE_SHADERS(number, , identify, ),
                                          kNext = NACRE_SHADERS(number, Reads, peel, );
    passes::GeometryPass pass{before ? kNext : kFirst};
    pass.depth = gpu::DepthUse::write;
    pass.reads = before;
    return pass;
}

/// Further layers: each fragment adds to the sums of its pixel. @param last  depth of the last layer in order
passes::GeometryPass restPass(const passes::Reads& last) {
    static const passes::PrimitiveShaders kRest = NACRE_SHADERS(number, Reads, rest, );
    passes::GeometryPass pass{kRest};
    pass.reads = last;
    pass.streams = pass.lights = true;
    pass.blend = gpu::Blend::add;
    pass.colorsWritten = 2;
    return pass;
}

/// Compute shades all layers of a pixel.
void declareByTiles(Frame& f, const FrameShape& shape) {
    const std::uint64_t pixels = TileBins::pixels(shape.extent.width, shape.extent.height);
    static_assert(kTranslucentLayers == layout::kOrderedLayers);
    f.layerColors = f.graph.importBuffer(
        "translucent layers", passes::pixelWords(passes::TileResult::layers) * sizeof(std::uint32_t) * pixels);
    f.lit(f.graph.compute("translucent layers").samples(f.depth))
        .writes(*f.layerColors)
        .record(records(f, [atlas = f.atlas, opaque = f.depth](gpu::PassContext& c, const SceneView& scene) {
            passes::drawLayersByTiles(c, *scene.translucent, c.view(atlas), c.view(opaque));
        }));
}

/// @param layer  kOrderedLayers: the rest
void declareColorByTiles(Frame& f, graph::PassBuilder pass, std::uint32_t layer) {
    pass.reads(*f.layerColors).color(f.targets[0]);
    pass.record(records(f, [layer](gpu::PassContext& c, const SceneView& scene) {
        passes::drawLayerColor(c, *scene.translucent, layer);
    }));
}

/// A pass over the screen that reads what earlier passes left in its own pixels. @param images  one or two
void drawFromPixels(gpu::PassContext& c, const passes::FullScreenPass& pass, std::span<const vk::ImageView> images) {
    constexpr auto kInput = vk::DescriptorType::eInputAttachment;
    static constexpr std::array kInputs{kInput, kInput}, kTextures{passes::kSampled, passes::kSampled};
    const bool sampled = c.inputIsSampled;
    const std::span<const vk::DescriptorType> all = sampled ? kTextures : kInputs;
    const gpu::Layout& layout =
        c.pipelines.layout({"own pixel layout", all.first(images.size()), vk::ShaderStageFlagBits::eFragment});
    const vk::DescriptorSet set = c.descriptors.allocate(layout.set, c.pass);
    const vk::Sampler sampler = sampled ? c.pipelines.sampler(vk::Filter::eNearest) : vk::Sampler();
    for (std::uint32_t i = 0; i < images.size(); ++i) {
        const vk::DescriptorImageInfo image(sampler, images[i],
                                            sampled ? vk::ImageLayout::eShaderReadOnlyOptimal : c.inputLayout);
        c.device->updateDescriptorSets(vk::WriteDescriptorSet(set, i, 0, all[i], image), {});
    }
    passes::bindFullScreen(c, pass, layout);
    c.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, set, {});
    c.commands.draw(3, 1, 0, 0);
}

/// Where the nearest opaque depth is an attachment, the depth buffer has only that of plates.
void declareOpaqueDepth(Frame& f) {
    if (!f.encoding || f.encoding->settles()) return;
    f.graph.graphics(kOpaqueDepth)
        .input(f.nearest)
        .depth(f.depth)
        .record(records(f, [nearest = f.nearest, format = *f.encoding](gpu::PassContext& c, const SceneView&) {
            passes::FullScreenPass pass{
                c.inputIsSampled ? shaders::opaqueDepthSampled : shaders::opaqueDepthInput, {}, {}};
            pass.depth = gpu::DepthUse::write;
            pass.constants.set(layout::kDepthChannelsId, format.channels);
            pass.constants.set(layout::kDepthStepsId, format.steps);
            drawFromPixels(c, pass, std::array{c.view(nearest)});
        }));
}

}  // namespace

void declareTranslucentLayers(Frame& f, const FrameShape& shape) {
    if (shape.choice.has(Effect::Kind::tileTranslucency)) return;
    std::optional<graph::Image> before;
    for (std::uint32_t i = 0; i < shape.choice.layers(); ++i) {
        const std::string name = kTranslucentLayer + std::to_string(i + 1);
        graph::Image depth = f.graph.image(name + " depth", {VK_FORMAT_D32_SFLOAT, shape.extent});
        f.layers.push_back(f.graph.image(name, {VK_FORMAT_R32_UINT, shape.extent}));
        for (const graph::Share& share : shape.choice.vertices.layers.shares()) {
            graph::PassBuilder pass = f.graph.graphics(name).share(share);
            if (before) pass.samples(*before);
            pass.depth(depth, clearFirst(share, 1.0f)).color(f.layers.back(), clearFirst(share, 0.0f));
            pass.record(records(f, [atlas = f.atlas, before](gpu::PassContext& c, const SceneView& scene) {
                std::optional<passes::Reads> reads;
                if (before) reads = makeReads(c, NearestFrom::texture, atlas, before);
                if (c.share.index == 0) passes::drawCovers(c, *scene.translucent);
                passes::draw(c, *scene.translucent, layerPass(reads));
            }));
        }
        before = depth;
        f.layerDepths.push_back(depth);
    }
}

void declareTranslucentRest(Frame& f, const FrameShape& shape) {
    if (shape.choice.layers() == 0) return;
    if (shape.choice.has(Effect::Kind::tileTranslucency)) return declareByTiles(f, shape);
    declareOpaqueDepth(f);
    const bool fine = shape.choice.fineSums;
    f.restColors = f.graph.image(kTranslucentRest,
                                 {fine ? VK_FORMAT_R32G32B32A32_SFLOAT : VK_FORMAT_R16G16B16A16_SFLOAT, shape.extent});
    f.restDepths =
        f.graph.image("optical depth of the rest", {fine ? VK_FORMAT_R32_SFLOAT : VK_FORMAT_R16_SFLOAT, shape.extent});
    for (const graph::Share& share : shape.choice.vertices.layers.shares())
        f.lit(f.graph.graphics(kTranslucentRest).share(share).samples(f.layerDepths.back()))
            .depthTest(f.depth)
            .color(f.restColors, clearFirst(share, 0.0f))
            .color(f.restDepths, clearFirst(share, 0.0f))
            .record(
                records(f, [atlas = f.atlas, last = f.layerDepths.back()](gpu::PassContext& c, const SceneView& scene) {
                    passes::draw(c, *scene.translucent, restPass(makeReads(c, NearestFrom::texture, atlas, last)));
                }));
}

void declareRestColor(Frame& f, const FrameChoice& choice) {
    if (choice.layers() == 0) return;
    graph::PassBuilder pass = f.graph.graphics(kRestColor);
    if (f.layerColors) return declareColorByTiles(f, pass, layout::kOrderedLayers);
    pass.input(f.restColors).input(f.restDepths).color(f.targets[0]);
    pass.record(records(f, [sums = f.restColors, depths = f.restDepths](gpu::PassContext& c, const SceneView&) {
        passes::FullScreenPass over{c.inputIsSampled ? shaders::mixRestSampled : shaders::mixRestInput, {}, {}};
        over.blend = gpu::Blend::over;
        drawFromPixels(c, over, std::array{c.view(sums), c.view(depths)});
    }));
}

void declareTranslucentColor(Frame& f, std::uint32_t layer) {
    graph::PassBuilder pass = f.graph.graphics(kTranslucentColor + std::to_string(layer + 1));
    if (f.layerColors) return declareColorByTiles(f, pass, layer);
    f.lit(pass.samples(f.layers[layer])).depthTest(f.depth).color(f.targets[0]);
    pass.record(records(f, [atlas = f.atlas, numbers = f.layers[layer]](gpu::PassContext& c, const SceneView& scene) {
        passes::DeferredPass shading{passes::Output::color, makeReads(c, NearestFrom::texture, atlas, numbers)};
        shading.over = true;
        passes::draw(c, *scene.translucent, shading);
    }));
}

void viewTranslucent(passes::SceneView& view, const passes::SceneView& all, const TranslucentParts& parts) {
    view = all;
    passes::select(view.copies, parts, passes::Opacity::translucent);
    view.effects.contours.width = 0;
    view.rims = {};
    view.constants.contourWidth = 0;
    view.coded = false;  // layers are blended, in linear light
}

}  // namespace nacre
