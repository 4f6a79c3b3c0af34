#include "engine/tiles/lanes/tile_edges.h"

#include "engine/tiles/lanes/lane_passes.h"
#include "engine/tiles/lanes/tile_spans.h"
#include "engine/tiles/tile_bindings.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

// Atlas, effects; shapes, rows of copies, looks; lists, numbers, edge pixels; colours, which are written; shadow map;
// cells of the atlas, if they are texels.
constexpr std::array kSampleTexels{
    kSampled, Type::eUniformBuffer, kTexel, kTexel, kTexel, kTexel, kTexel, kTexel, kStorage, kSampled, kTexel};
constexpr auto kSampleStorage = asStorage(kSampleTexels);
// Lists, numbers, colours; and the outputs: edge pixels and colours.
constexpr std::array kFindTexels{kTexel, kTexel, kTexel, kStorage, kStorage};
constexpr auto kFindStorage = asStorage(kFindTexels);
constexpr std::array kColorTexels{kTexel};
constexpr auto kColorStorage = asStorage(kColorTexels);

Stage sampleStage(bool texels, TileScene scene) { return {NACRE_TILE_SHADER(tileEdges)}; }

const gpu::Layout& findLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"edge pixels", context.device.caps().tiles.texels ? kFindTexels : kFindStorage,
                                     kCompute, sizeof(layout::TileConstants)});
}

gpu::ComputePipeline findPipeline(gpu::PipelineContext& context, const SceneView& view) {
    const gpu::TileCaps& caps = context.device.caps().tiles;
    gpu::ComputePipeline d{"edge pixels",
                           caps.texels ? shaders::tileEdgePixelsTexels : shaders::tileEdgePixelsStorage,
                           {},
                           *findLayout(context).pipeline};
    d.constants.set(layout::kLanesId, caps.lanes);
    setTileView(d.constants, view);
    d.constants.set(layout::kEverywhereId, listedFrame(view).edgeData.everywhere);
    d.constants.set(layout::kRowsId, listedFrame(view).shaded());
    return d;
}

const gpu::Layout& sampleLayout(gpu::PipelineContext& context, const SceneView& view) {
    const auto types =
        context.device.caps().tiles.texels ? std::span<const Type>(kSampleTexels) : std::span(kSampleStorage).first(10);
    return context.pipelines.layout(
        {"edges by tiles", types, kCompute, sizeof(layout::TileConstants), view.fragments != nullptr});
}

gpu::ComputePipeline samplePipeline(gpu::PipelineContext& context, const SceneView& view) {
    const gpu::TileCaps& caps = context.device.caps().tiles;
    const Stage stage = sampleStage(caps.texels, tileScene(*view.buffers));
    gpu::ComputePipeline d{"edge samples", stage.of(view), {}, *sampleLayout(context, view).pipeline};
    setTileView(d.constants, view);
    setShadingConstants(d.constants, view);
    d.constants.set(layout::kLanesId, caps.lanes);
    d.constants.set(layout::kListedId, listedFrame(view).edgeData.listed);
    if (tileScene(*view.buffers) == TileScene::triangles) {
        d.constants.set(layout::kSpheresId, view.buffers->sphereCount > 0);
        d.constants.set(layout::kCylindersId, view.buffers->cylinderCount > 0);
    }
    d.constants.set(layout::kRowsId, listedFrame(view).shaded());
    return d;
}

}  // namespace

void wantEdgesByTiles(gpu::PipelineContext& context, const SceneView& view) {
    context.pipelines.want(samplePipeline(context, view));  // this one takes a driver longer
    if (!listedFrame(view).edgeData.placed) context.pipelines.want(findPipeline(context, view));
}

void findEdgesByTiles(gpu::PassContext& context, const SceneView& view) {
    const ListedFrame& f = listedFrame(view);
    if (f.tiles().tiles().empty()) return;
    bindTiles(context, findLayout(context), findPipeline(context, view), f.constants, [&](TileBindings& to) {
        to.read(f.words);
        to.read(f.sights().buffer, f.sights().quads);
        to.read(f.numbers.buffer, f.numbers.quads);
        to.store(f.edgeData.pixels.buffer);
        to.store(f.shaded() ? f.edgeData.pixels.buffer : f.edgeData.colors.buffer);  // unused if shaded
    });
    dispatchTiles(context, f.tiles().tiles().size() / (TileSet::kTilesInBin * TileSet::kTilesInBin));
}

void drawEdgesByTiles(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas) {
    const ListedFrame& f = listedFrame(view);
    const SceneBuffers& scene = *view.buffers;
    if (f.tiles().tiles().empty()) return;
    const gpu::Layout& layout = sampleLayout(context, view);
    bindTiles(context, layout, samplePipeline(context, view), f.constants, [&](TileBindings& to) {
        to.sample(atlas);
        to.uniform(*view.effectConstants);
        to.read(scene.shapes, scene.shapeTexels);
        to.read(f.rows);
        to.read(scene.looks, scene.lookTexels);
        to.read(f.words);
        to.read(f.sights());
        to.read(f.edgeData.pixels);
        to.store(f.shaded() ? f.numbers.buffer : f.edgeData.colors.buffer);
        to.sample(describeShadow(context, view, atlas));
        // Always written, even if the shader reads none: lavapipe accesses it.
        if (context.device.caps().tiles.texels) to.read(view.occlusionCells ? view.occlusionCells : *scene.lookTexels);
    });
    bindCounter(context, view, layout, vk::PipelineBindPoint::eCompute);
    context.commands.dispatch(f.edgeData.groups, 1, 1);
}

/// Draws the rows with colours of a buffer. @param d  with its fragment stage and constants
static void drawColors(gpu::PassContext& context, const SceneView& view, const TileBuffer& colors,
                       gpu::GraphicsPipeline d) {
    const ListedFrame& f = listedFrame(view);
    if (f.tiles().spans().empty()) return;
    const gpu::Layout& layout =
        context.pipelines.layout({"colours of tiles", context.device.caps().tiles.texels ? kColorTexels : kColorStorage,
                                  kDraw, sizeof(layout::TileConstants)});
    d.detail = "tiles";
    d.vertex = shaders::tileSpanVertex;
    d.constants.set(layout::kTilesInBinId, TileSet::kTilesInBin);
    d.streams = spanStreams();
    d.layout = *layout.pipeline;
    d.colorsWritten = 1;
    bindTiles(context, layout, d, f.constants, [&](TileBindings& to) { to.read(colors); });
    drawSpans(context, f);
}

void drawEdgeColors(gpu::PassContext& context, const SceneView& view, const graph::Clear& clear) {
    gpu::GraphicsPipeline d = context.pipeline();
    d.fragment = context.device.caps().tiles.texels ? shaders::edgeColorTexels : shaders::edgeColorStorage;
    d.constants.set(layout::kCodedId, view.coded);
    for (int i = 0; i < 4; ++i) d.constants.set(layout::kClearId + i, clear.value[static_cast<std::size_t>(i)]);
    drawColors(context, view, listedFrame(view).edgeData.colors, std::move(d));
}

void drawLayerColor(gpu::PassContext& context, const SceneView& view, std::uint32_t layer) {
    gpu::GraphicsPipeline d = context.pipeline();
    d.fragment = context.device.caps().tiles.texels ? shaders::layerColorTexels : shaders::layerColorStorage;
    d.constants.set(layout::kLayerId, layer);
    d.blend = gpu::Blend::over;
    drawColors(context, view, listedFrame(view).numbers, std::move(d));
}

}  // namespace nacre::passes
