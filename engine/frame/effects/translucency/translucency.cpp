#include "engine/frame/effects/translucency/translucency.h"

#include "engine/frame/record.h"
#include "engine/passes/deferred_shading.h"
#include "engine/passes/geometry_passes.h"
#include "engine/passes/select_opacity.h"
#include "engine/passes/tile_frame.h"
#include "engine/tiles/lanes/lane_passes.h"
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

void declareLayersByTiles(Frame& f, const FrameShape& shape) {
    const std::uint64_t pixels = TileBins::pixels(shape.extent.width, shape.extent.height);
    static_assert(kTranslucentLayers == 2);  // as shaders/tile_layers.comp
    f.layerNumbers = f.graph.importBuffer("translucent layers", 2 * sizeof(std::uint32_t) * pixels);
    f.graph.compute("translucent layers")
        .writes(*f.layerNumbers)
        .record(records(
            f, [](gpu::PassContext& c, const SceneView& scene) { passes::findLayersByTiles(c, *scene.translucent); }));
}

}  // namespace

void declareTranslucentLayers(Frame& f, const FrameShape& shape) {
    if (shape.choice.has(Effect::Kind::tileTranslucency)) return declareLayersByTiles(f, shape);
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

void declareTranslucentColor(Frame& f, std::uint32_t layer) {
    graph::PassBuilder pass = f.graph.graphics(kTranslucentColor + std::to_string(layer + 1));
    if (f.layerNumbers) {
        f.lit(pass.reads(*f.layerNumbers).depthTest(f.depth)).color(f.targets[0]);
        pass.record(records(f, [atlas = f.atlas, layer](gpu::PassContext& c, const SceneView& scene) {
            passes::draw(c, *scene.translucent,
                         passes::TileShading{c.view(atlas), passes::Output::color, false, layer});
        }));
        return;
    }
    f.lit(pass.samples(f.layers[layer]));
    f.encoding ? pass.input(f.nearest) : pass.depthTest(f.depth);
    pass.color(f.targets[0])
        .record(records(f, [atlas = f.atlas, numbers = f.layers[layer], encoding = f.encoding, nearest = f.nearest](
                               gpu::PassContext& c, const SceneView& scene) {
            passes::DeferredPass shading{passes::Output::color, makeReads(c, NearestFrom::texture, atlas, numbers)};
            shading.over = passes::LayerOver();
            if (encoding)
                shading.over = passes::LayerOver{fromEarlierPass(c), c.view(nearest), passes::Encoding(*encoding)};
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
