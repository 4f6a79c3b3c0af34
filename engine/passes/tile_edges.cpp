#include "engine/passes/tile_edges.h"

#include "engine/passes/tile_bindings.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

// Atlas, effects; shapes, rows of copies, looks; lists, numbers, edge pixels; colours, which are written; shadow map;
// cells of the atlas.
constexpr Type kSampleTexels[] = {Type::eCombinedImageSampler,
                                  Type::eUniformBuffer,
                                  kTexel,
                                  kTexel,
                                  kTexel,
                                  kTexel,
                                  kTexel,
                                  kTexel,
                                  kStorage,
                                  Type::eCombinedImageSampler,
                                  kTexel};
constexpr Type kSampleStorage[] = {Type::eCombinedImageSampler,
                                   Type::eUniformBuffer,
                                   kStorage,
                                   kStorage,
                                   kStorage,
                                   kStorage,
                                   kStorage,
                                   kStorage,
                                   kStorage,
                                   Type::eCombinedImageSampler};
// Lists, numbers, colours; edge pixels, and colours of none, which are written.
constexpr Type kFindTexels[] = {kTexel, kTexel, kTexel, kStorage, kStorage};
constexpr Type kFindStorage[] = {kStorage, kStorage, kStorage, kStorage, kStorage};
constexpr Type kColorTexels[] = {kTexel};
constexpr Type kColorStorage[] = {kStorage};

Stage sampleStage(bool texels, TileScene scene) {
    return {NACRE_TILE_STAGE(tileEdges, ), NACRE_TILE_STAGE(tileEdges, Counting)};
}

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
    d.constants.set(layout::kEverywhereId, view.tiles->edges.everywhere);
    d.constants.set(layout::kRowsId, view.tiles->shaded);
    return d;
}

const gpu::Layout& sampleLayout(gpu::PipelineContext& context, const SceneView& view) {
    const std::span<const Type> types =
        context.device.caps().tiles.texels ? std::span<const Type>(kSampleTexels) : kSampleStorage;
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
    d.constants.set(layout::kListedId, view.tiles->edges.listed);
    d.constants.set(layout::kRowsId, view.tiles->shaded);
    return d;
}

}  // namespace

void wantEdgesByTiles(gpu::PipelineContext& context, const SceneView& view) {
    context.pipelines.want(samplePipeline(context, view));  // which takes a driver longer
    context.pipelines.want(findPipeline(context, view));
}

void findEdgesByTiles(gpu::PassContext& context, const SceneView& view) {
    const TileFrame& f = *view.tiles;
    if (f.lists.tiles().empty()) return;
    const gpu::Layout& layout = findLayout(context);
    const gpu::ComputePipeline d = findPipeline(context, view);
    context.commands.bindPipeline(vk::PipelineBindPoint::eCompute, context.pipelines.compute(d));
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    TileBindings bindings(context, set, 0);
    bindings.read(f.words);
    bindings.read(f.sights().buffer, f.sights().quads);
    bindings.read(f.numbers.buffer, f.numbers.quads);
    bindings.store(f.edges.pixels.buffer);
    bindings.store(f.shaded ? f.edges.pixels.buffer : f.edges.colors.buffer);  // what is shaded has no use for it
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout.pipeline, 0, set, {});
    context.commands.pushConstants<layout::TileConstants>(*layout.pipeline, kCompute, 0, f.constants);
    dispatchTiles(context, f.lists.tiles().size() / (TileLists::kTilesInBin * TileLists::kTilesInBin));
}

void drawEdgesByTiles(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas) {
    const TileFrame& f = *view.tiles;
    const SceneBuffers& scene = *view.buffers;
    if (f.lists.tiles().empty()) return;
    const gpu::Layout& layout = sampleLayout(context, view);
    const gpu::ComputePipeline d = samplePipeline(context, view);
    context.commands.bindPipeline(vk::PipelineBindPoint::eCompute, context.pipelines.compute(d));
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    TileBindings bindings(context, set, 0);
    bindings.sample(atlas);
    bindings.uniform(*view.effectConstants);
    bindings.read(scene.shapes, scene.shapeTexels);
    bindings.read(f.rows);
    bindings.read(scene.looks, scene.lookTexels);
    bindings.read(f.words);
    bindings.read(f.sights());
    bindings.read(f.edges.pixels);
    bindings.store(f.shaded ? f.numbers.buffer : f.edges.colors.buffer);
    bindings.sample(shadowOf(context, view, atlas));
    // Never left unwritten, even where the shader reads none: lavapipe looks at it.
    if (context.device.caps().tiles.texels)
        bindings.read(view.occlusionCells ? view.occlusionCells : *scene.lookTexels);
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout.pipeline, 0, set, {});
    bindCounter(context, view, layout, vk::PipelineBindPoint::eCompute);
    context.commands.pushConstants<layout::TileConstants>(*layout.pipeline, kCompute, 0, f.constants);
    context.commands.dispatch(f.edges.groups, 1, 1);
}

void drawEdgeColors(gpu::PassContext& context, const SceneView& view, const graph::Clear& clear) {
    const TileFrame& f = *view.tiles;
    const bool texels = context.device.caps().tiles.texels;
    if (f.lists.spans().empty()) return;
    const gpu::Layout& layout = context.pipelines.layout(
        {"edge colours", texels ? kColorTexels : kColorStorage, kDraw, sizeof(layout::TileConstants)});
    gpu::GraphicsPipeline d = context.pipeline();
    d.detail = "tiles";
    d.vertex = shaders::tilePlaceVertex;
    d.fragment = texels ? shaders::edgeColorTexels : shaders::edgeColorStorage;
    d.constants.set(layout::kTilesInBinId, TileLists::kTilesInBin);
    d.constants.set(layout::kCodedId, view.coded);
    for (int i = 0; i < 4; ++i) d.constants.set(layout::kClearId + i, clear.value[static_cast<std::size_t>(i)]);
    d.streams = spanStreams();
    d.layout = *layout.pipeline;
    d.colorsWritten = 1;
    context.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, context.pipelines.graphics(d));
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    TileBindings(context, set, 0).read(f.edges.colors);
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, set, {});
    context.commands.pushConstants<layout::TileConstants>(*layout.pipeline, kDraw, 0, f.constants);
    drawSpans(context, f);
}

}  // namespace nacre::passes
