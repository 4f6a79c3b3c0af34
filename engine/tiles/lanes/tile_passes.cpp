#include "engine/passes/primitives.h"
#include "engine/tiles/lanes/lane_passes.h"
#include "engine/tiles/lanes/tile_edges.h"
#include "engine/tiles/lanes/tile_spans.h"
#include "engine/tiles/tile_bindings.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

// Shapes, rows of copies, lists; numbers, which are written.
constexpr std::array kNearestTexels{kTexel, kTexel, kTexel, kStorage};
constexpr auto kNearestStorage = asStorage(kNearestTexels);
// With shading: also looks, atlas, effects and cells of the atlas, numbers next to the colours, and the shadow map.
constexpr std::array kShadedTexels{kTexel, kTexel,   kTexel,  kStorage, kTexel, kSampled, Type::eUniformBuffer,
                                   kTexel, kStorage, kSampled};
constexpr auto kShadedStorage = asStorage(kShadedTexels);
// Of translucent layers: the opaque depth in place of the second numbers.
constexpr std::array kLayerTexels{kTexel, kTexel,   kTexel,  kStorage, kTexel, kSampled, Type::eUniformBuffer,
                                  kTexel, kSampled, kSampled};
constexpr auto kLayerStorage = asStorage(kLayerTexels);
// Atlas, effects, shadow map, numbers, shapes, rows of copies, looks.
constexpr std::array kShadeTexels{kSampled, Type::eUniformBuffer, kSampled, kTexel, kTexel, kTexel, kTexel};
constexpr auto kShadeStorage = asStorage(kShadeTexels);

constexpr vk::VertexInputBindingDescription kSpanBindings[] = {
    {0, sizeof(TileSpanVertex), vk::VertexInputRate::eInstance}};
constexpr vk::VertexInputAttributeDescription kSpanAttributes[] = {{0, 0, vk::Format::eR32G32B32A32Sfloat, 0}};

gpu::ShaderWords nearestShader(bool texels, TileScene scene, bool shaded, bool rims) {
    if (shaded && rims) return NACRE_TILE_SHADER(tileRimmed);
    if (shaded) return NACRE_TILE_SHADER(tileShaded);
    return NACRE_TILE_SHADER(tileNearest);
}

Stage shadeShader(Output output, bool texels, TileScene scene, bool depth) {
    if (depth) return {NACRE_TILE_SHADER(tileColorDepth)};
    switch (output) {
        case Output::surface:
            return {NACRE_TILE_SHADER(tileSurface)};
        case Output::identity:
            return {NACRE_TILE_SHADER(tileIdentity)};
        case Output::color:
            break;
    }
    return {NACRE_TILE_SHADER(tileColor)};
}

const gpu::Layout& nearestLayout(gpu::PipelineContext& context, bool shades) {
    using Types = std::span<const Type>;
    const bool texels = context.device.caps().tiles.texels;
    const Types types =
        shades ? Types(texels ? kShadedTexels : kShadedStorage) : Types(texels ? kNearestTexels : kNearestStorage);
    return context.pipelines.layout({"nearest primitive by tiles", types, kCompute, sizeof(layout::TileConstants)});
}

gpu::ComputePipeline nearestPipeline(gpu::PipelineContext& context, const SceneView& view, bool shades) {
    const ListedFrame& f = listedFrame(view);
    const SceneBuffers& scene = *view.buffers;
    const gpu::TileCaps& caps = context.device.caps().tiles;
    gpu::ComputePipeline d{context.pass,
                           nearestShader(caps.texels, tileScene(scene), shades, view.rims.any()),
                           {},
                           *nearestLayout(context, shades).pipeline};
    setTileView(d.constants, view, view.rims.widest());
    if (shades) setShadingConstants(d.constants, view);
    if (tileScene(scene) != TileScene::spheres) {
        d.constants.set(layout::kSpheresId, scene.sphereCount > 0);
        d.constants.set(layout::kCylindersId, scene.cylinderCount > 0);
        d.constants.set(layout::kTrianglesId, scene.triangleCount > 0);
    }
    d.constants.set(layout::kNumberedId, f.edgeData.drawn && !f.edgeData.alone);
    d.constants.set(layout::kSeededId, f.seeded());
    const bool found = f.seeded() && tileScene(scene) == TileScene::spheres;  // by the host, at all pixels
    d.constants.set(layout::kListedId, !found);
    d.constants.set(layout::kClearsId, f.byDevice != nullptr);
    d.constants.set(layout::kLanesId, caps.lanes);
    return d;
}

const gpu::Layout& spanLayout(gpu::PipelineContext& context, const SceneView& view) {
    return context.pipelines.layout({"shading by tiles",
                                     context.device.caps().tiles.texels ? kShadeTexels : kShadeStorage, kDraw,
                                     sizeof(layout::TileConstants), view.fragments != nullptr});
}

gpu::GraphicsPipeline spanPipeline(gpu::PipelineContext& context, const SceneView& view, const TileShading& shading) {
    const bool texels = context.device.caps().tiles.texels;
    gpu::GraphicsPipeline d = context.pipeline();
    d.detail = "tiles";
    d.vertex = shaders::tileSpanVertex;
    d.fragment = shadeShader(shading.output, texels, tileScene(*view.buffers), shading.depth).of(view);
    if (shading.depth) d.depth = gpu::DepthUse::write;
    setTileView(d.constants, view);
    setShadingConstants(d.constants, view);
    d.streams = spanStreams();
    d.layout = *spanLayout(context, view).pipeline;
    d.colorsWritten = 1;
    return d;
}

}  // namespace

gpu::VertexStreams spanStreams() { return {kSpanBindings, kSpanAttributes}; }

void want(gpu::PipelineContext& context, const SceneView& view, const NearestByTiles& pass) {
    if (listedFrame(view).tiles().tiles().empty()) return;
    if (listedFrame(view).edgeData.drawn) wantEdgesByTiles(context, view);
    context.pipelines.want(nearestPipeline(context, view, pass.atlas.has_value()));
}

void draw(gpu::PassContext& context, const SceneView& view, const NearestByTiles& pass) {
    const ListedFrame& f = listedFrame(view);
    const SceneBuffers& scene = *view.buffers;
    if (f.tiles().tiles().empty()) return;
    const bool shades = pass.atlas.has_value();
    if (f.edgeData.drawn && context.pipelines.makesAhead()) wantEdgesByTiles(context, view);
    const auto write = [&](TileBindings& to) {
        to.read(scene.shapes, scene.shapeTexels);
        to.read(f.rows);
        to.read(f.words);
        to.store(f.edgeData.alone ? f.edgeData.numbers.buffer : f.numbers.buffer);
        if (!shades) return;
        to.read(scene.looks, scene.lookTexels);
        to.sample(*pass.atlas);
        to.uniform(*view.effectConstants);
        // Always written, even if the shader reads none: lavapipe accesses it.
        if (context.device.caps().tiles.texels)
            to.read(view.occlusionCells ? view.occlusionCells : *scene.lookTexels);
        else
            to.store(scene.looks);
        to.store(f.edgeData.drawn ? f.edgeData.numbers.buffer : f.numbers.buffer);
        to.sample(describeShadow(context, view, *pass.atlas));
    };
    bindTiles(context, nearestLayout(context, shades), nearestPipeline(context, view, shades), f.constants, write);
    dispatchTiles(context, shades ? f.groups : f.tiles().tiles().size());
}

void want(gpu::PipelineContext& context, const SceneView& view, const TileShading& pass) {
    if (!listedFrame(view).tiles().spans().empty()) context.pipelines.want(spanPipeline(context, view, pass));
}

void draw(gpu::PassContext& context, const SceneView& view, const TileShading& pass) {
    const ListedFrame& f = listedFrame(view);
    const SceneBuffers& scene = *view.buffers;
    if (f.tiles().spans().empty()) return;
    const gpu::Layout& layout = spanLayout(context, view);
    bindTiles(context, layout, spanPipeline(context, view, pass), f.constants, [&](TileBindings& to) {
        to.sample(pass.atlas);
        to.uniform(*view.effectConstants);
        to.sample(describeShadow(context, view, pass.atlas));
        to.read(f.numbers);
        to.read(scene.shapes, scene.shapeTexels);
        to.read(f.rows);
        to.read(scene.looks, scene.lookTexels);
    });
    bindCounter(context, view, layout);
    drawSpans(context, f);
}

void drawLayersByTiles(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas, vk::ImageView opaque) {
    const ListedFrame& f = listedFrame(view);
    const SceneBuffers& scene = *view.buffers;
    const gpu::TileCaps& caps = context.device.caps().tiles;
    if (f.tiles().tiles().empty()) return;
    const gpu::Layout& layout =
        context.pipelines.layout({"translucent layers by tiles", caps.texels ? kLayerTexels : kLayerStorage, kCompute,
                                  sizeof(layout::TileConstants)});
    gpu::ComputePipeline d{
        context.pass, caps.texels ? shaders::tileLayersTexels : shaders::tileLayersStorage, {}, *layout.pipeline};
    setTileView(d.constants, view);
    setShadingConstants(d.constants, view);
    d.constants.set(layout::kSpheresId, !view.copies.spheres.empty());
    d.constants.set(layout::kCylindersId, !view.copies.cylinders.empty());
    d.constants.set(layout::kTrianglesId, !view.copies.triangles.empty());
    d.constants.set(layout::kLanesId, caps.lanes);
    const vk::DescriptorImageInfo depth(context.pipelines.sampler(vk::Filter::eNearest), opaque,
                                        vk::ImageLayout::eShaderReadOnlyOptimal);
    bindTiles(context, layout, d, f.constants, [&](TileBindings& to) {
        to.read(scene.shapes, scene.shapeTexels);
        to.read(f.rows);
        to.read(f.words);
        to.store(f.numbers.buffer);
        to.read(scene.looks, scene.lookTexels);
        to.sample(atlas);
        to.uniform(*view.effectConstants);
        if (caps.texels)
            to.read(view.occlusionCells ? view.occlusionCells : *scene.lookTexels);
        else
            to.store(scene.looks);
        to.sample(depth);
        to.sample(describeShadow(context, view, atlas));
    });
    dispatchTiles(context, f.tiles().tiles().size());
}

}  // namespace nacre::passes
