#include "engine/passes/tile_passes.h"

#include "engine/passes/primitives.h"
#include "engine/passes/tile_bindings.h"
#include "engine/passes/tile_edges.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

// Shapes, rows of copies, lists; numbers, which are written.
constexpr Type kNearestTexels[] = {kTexel, kTexel, kTexel, kStorage};
constexpr Type kNearestStorage[] = {kStorage, kStorage, kStorage, kStorage};
// Where it shades: looks, atlas, effects and cells of the atlas, too, numbers beside the colours, and the shadow map.
constexpr Type kNearestShaded[] = {kTexel, kTexel,   kTexel,  kStorage, kTexel, kSampled, Type::eUniformBuffer,
                                   kTexel, kStorage, kSampled};
// Atlas, effects, shadow map, numbers, shapes, rows of copies, looks.
constexpr Type kShadeTexels[] = {kSampled, Type::eUniformBuffer, kSampled, kTexel, kTexel, kTexel, kTexel};
constexpr Type kShadeStorage[] = {kSampled, Type::eUniformBuffer, kSampled, kStorage, kStorage, kStorage, kStorage};

constexpr vk::VertexInputBindingDescription kSpanBindings[] = {
    {0, sizeof(TileSpanVertex), vk::VertexInputRate::eInstance}};
constexpr vk::VertexInputAttributeDescription kSpanAttributes[] = {{0, 0, vk::Format::eR32G32B32A32Sfloat, 0}};

gpu::ShaderWords nearestShader(bool texels, TileScene scene, bool shaded) {
    if (shaded) return NACRE_TILE_SCENE(tileShaded, );
    return NACRE_TILE_STAGE(tileNearest, );
}

Stage layerShader(bool texels) {
    return texels ? NACRE_STAGE(tileTranslucentTexels) : NACRE_STAGE(tileTranslucentStorage);
}

Stage shadeShader(Output output, bool texels, TileScene scene, bool depth) {
    if (depth) return {NACRE_TILE_STAGE(tileColorDepth, ), NACRE_TILE_STAGE(tileColorDepth, Counting)};
    switch (output) {
        case Output::surface:
            return {NACRE_TILE_STAGE(tileSurface, ), NACRE_TILE_STAGE(tileSurface, Counting)};
        case Output::identity:
            return {NACRE_TILE_STAGE(tileIdentity, ), NACRE_TILE_STAGE(tileIdentity, Counting)};
        case Output::color:
            break;
    }
    return {NACRE_TILE_STAGE(tileColor, ), NACRE_TILE_STAGE(tileColor, Counting)};
}

const gpu::Layout& nearestLayout(gpu::PipelineContext& context, bool shades) {
    const std::span<const Type> types = shades                               ? std::span<const Type>(kNearestShaded)
                                        : context.device.caps().tiles.texels ? kNearestTexels
                                                                             : kNearestStorage;
    return context.pipelines.layout({"nearest primitive by tiles", types, kCompute, sizeof(layout::TileConstants)});
}

gpu::ComputePipeline nearestPipeline(gpu::PipelineContext& context, const SceneView& view, bool shades) {
    const TileFrame& f = *view.tiles;
    const SceneBuffers& scene = *view.buffers;
    const gpu::TileCaps& caps = context.device.caps().tiles;
    gpu::ComputePipeline d{context.pass,
                           nearestShader(caps.texels, tileScene(scene), shades),
                           {},
                           *nearestLayout(context, shades).pipeline};
    setTileView(d.constants, view);
    if (shades) {
        setShadingConstants(d.constants, view);
        d.constants.set(layout::kSpheresId, scene.sphereCount > 0);
        d.constants.set(layout::kCylindersId, scene.cylinderCount > 0);
        d.constants.set(layout::kTrianglesId, scene.triangleCount > 0);
    }
    d.constants.set(layout::kNumberedId, f.edges.drawn);
    d.constants.set(layout::kSeededId, f.lists.seeded());
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
    if (shading.layer) {
        d.fragment = layerShader(texels).of(view);
        d.constants.set(layout::kLayerId, *shading.layer);
        d.depth = gpu::DepthUse::test;
        d.blend = gpu::Blend::over;
    } else {
        d.fragment = shadeShader(shading.output, texels, tileScene(*view.buffers), shading.depth).of(view);
        if (shading.depth) d.depth = gpu::DepthUse::write;
    }
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
    if (view.tiles->lists.tiles().empty()) return;
    if (view.tiles->edges.drawn) wantEdgesByTiles(context, view);
    context.pipelines.want(nearestPipeline(context, view, pass.atlas.has_value()));
}

void draw(gpu::PassContext& context, const SceneView& view, const NearestByTiles& pass) {
    const TileFrame& f = *view.tiles;
    const SceneBuffers& scene = *view.buffers;
    if (f.lists.tiles().empty()) return;
    const gpu::Layout& layout = nearestLayout(context, pass.atlas.has_value());
    if (f.edges.drawn && context.pipelines.makesAhead()) wantEdgesByTiles(context, view);
    const gpu::ComputePipeline d = nearestPipeline(context, view, pass.atlas.has_value());
    context.commands.bindPipeline(vk::PipelineBindPoint::eCompute, context.pipelines.compute(d));
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    TileBindings bindings(context, set, 0);
    bindings.read(scene.shapes, scene.shapeTexels);
    bindings.read(f.rows);
    bindings.read(f.words);
    bindings.store(f.numbers.buffer);
    if (pass.atlas) {
        bindings.read(scene.looks, scene.lookTexels);
        bindings.sample(*pass.atlas);
        bindings.uniform(*view.effectConstants);
        // Never left unwritten, even where the shader reads none: lavapipe looks at it.
        bindings.read(view.occlusionCells ? view.occlusionCells : *scene.lookTexels);
        bindings.store(f.edges.drawn ? f.edges.numbers.buffer : f.numbers.buffer);
        bindings.sample(shadowOf(context, view, *pass.atlas));
    }
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout.pipeline, 0, set, {});
    context.commands.pushConstants<layout::TileConstants>(*layout.pipeline, kCompute, 0, f.constants);
    dispatchTiles(context, f.lists.tiles().size());
}

void want(gpu::PipelineContext& context, const SceneView& view, const TileShading& pass) {
    if (!view.tiles->lists.spans().empty()) context.pipelines.want(spanPipeline(context, view, pass));
}

void draw(gpu::PassContext& context, const SceneView& view, const TileShading& pass) {
    const TileFrame& f = *view.tiles;
    const SceneBuffers& scene = *view.buffers;
    if (f.lists.spans().empty()) return;
    const gpu::Layout& layout = spanLayout(context, view);
    const gpu::GraphicsPipeline d = spanPipeline(context, view, pass);
    context.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, context.pipelines.graphics(d));
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    TileBindings bindings(context, set, 0);
    bindings.sample(pass.atlas);
    bindings.uniform(*view.effectConstants);
    bindings.sample(shadowOf(context, view, pass.atlas));
    bindings.read(f.numbers);
    bindings.read(scene.shapes, scene.shapeTexels);
    bindings.read(f.rows);
    bindings.read(scene.looks, scene.lookTexels);
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, set, {});
    bindCounter(context, view, layout);
    context.commands.pushConstants<layout::TileConstants>(*layout.pipeline, kDraw, 0, f.constants);
    drawSpans(context, f);
}

void findLayersByTiles(gpu::PassContext& context, const SceneView& view) {
    constexpr auto kPoint = vk::PipelineBindPoint::eCompute;
    const TileFrame& f = *view.tiles;
    const gpu::TileCaps& caps = context.device.caps().tiles;
    if (f.lists.tiles().empty()) return;
    const gpu::Layout& layout = context.pipelines.layout(
        {"layers by tiles", caps.texels ? kNearestTexels : kNearestStorage, kCompute, sizeof(layout::TileConstants)});
    gpu::ComputePipeline d{
        context.pass, caps.texels ? shaders::tileLayersTexels : shaders::tileLayersStorage, {}, *layout.pipeline};
    setTileView(d.constants, view);
    d.constants.set(layout::kLanesId, caps.lanes);
    context.commands.bindPipeline(kPoint, context.pipelines.compute(d));
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    TileBindings bindings(context, set, 0);
    bindings.read(view.buffers->shapes, view.buffers->shapeTexels);
    bindings.read(f.rows);
    bindings.read(f.words);
    bindings.store(f.numbers.buffer);
    context.commands.bindDescriptorSets(kPoint, *layout.pipeline, 0, set, {});
    context.commands.pushConstants<layout::TileConstants>(*layout.pipeline, kCompute, 0, f.constants);
    dispatchTiles(context, f.lists.tiles().size());
}

}  // namespace nacre::passes
