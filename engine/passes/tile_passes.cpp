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

}  // namespace

gpu::VertexStreams spanStreams() { return {kSpanBindings, kSpanAttributes}; }

void findNearestByTiles(gpu::PassContext& context, const SceneView& view, std::optional<vk::ImageView> atlas) {
    const TileFrame& f = *view.tiles;
    const SceneBuffers& scene = *view.buffers;
    const gpu::TileCaps& caps = context.device.caps().tiles;
    if (f.lists.tiles().empty()) return;
    const std::span<const Type> types = atlas         ? std::span<const Type>(kNearestShaded)
                                        : caps.texels ? kNearestTexels
                                                      : kNearestStorage;
    const gpu::Layout& layout =
        context.pipelines.layout({"nearest primitive by tiles", types, kCompute, sizeof(layout::TileConstants)});
    if (f.edges.drawn && context.pipelines.makesAhead()) wantEdgesByTiles(context, view);
    const gpu::ShaderWords code = nearestShader(caps.texels, tileScene(scene), atlas.has_value());
    gpu::ComputePipeline d{context.pass, code, {}, *layout.pipeline};
    setTileView(d.constants, view);
    if (atlas) {
        setShadingConstants(d.constants, view);
        d.constants.set(layout::kSpheresId, scene.sphereCount > 0);
        d.constants.set(layout::kCylindersId, scene.cylinderCount > 0);
        d.constants.set(layout::kTrianglesId, scene.triangleCount > 0);
    }
    d.constants.set(layout::kNumberedId, f.edges.drawn);
    d.constants.set(layout::kSeededId, f.lists.seeded());
    d.constants.set(layout::kLanesId, caps.lanes);
    if (context.ahead) return context.pipelines.want(d);
    context.commands.bindPipeline(vk::PipelineBindPoint::eCompute, context.pipelines.compute(d));
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    TileBindings bindings(context, set, 0);
    bindings.read(scene.shapes, scene.shapeTexels);
    bindings.read(f.rows);
    bindings.read(f.words);
    bindings.store(f.numbers.buffer);
    if (atlas) {
        bindings.read(scene.looks, scene.lookTexels);
        bindings.sample(*atlas);
        bindings.uniform(*view.effectConstants);
        // Never left unwritten, even where the shader reads none: lavapipe looks at it.
        bindings.read(view.occlusionCells ? view.occlusionCells : *scene.lookTexels);
        bindings.store(f.edges.drawn ? f.edges.numbers.buffer : f.numbers.buffer);
        bindings.sample(shadowOf(context, view, *atlas));
    }
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout.pipeline, 0, set, {});
    context.commands.pushConstants<layout::TileConstants>(*layout.pipeline, kCompute, 0, f.constants);
    dispatchTiles(context, f.lists.tiles().size());
}

void shadeTiles(gpu::PassContext& context, const SceneView& view, Output output, vk::ImageView atlas, bool depth) {
    gpu::GraphicsPipeline d = context.pipeline();
    const bool texels = context.device.caps().tiles.texels;
    d.fragment = shadeShader(output, texels, tileScene(*view.buffers), depth).of(view);
    if (depth) d.depth = gpu::DepthUse::write;
    shadeSpans(context, view, atlas, d);
}

void shadeSpans(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas, gpu::GraphicsPipeline d) {
    const TileFrame& f = *view.tiles;
    const SceneBuffers& scene = *view.buffers;
    const bool texels = context.device.caps().tiles.texels;
    if (f.lists.spans().empty()) return;
    const gpu::Layout& layout =
        context.pipelines.layout({"shading by tiles", texels ? kShadeTexels : kShadeStorage, kDraw,
                                  sizeof(layout::TileConstants), view.fragments != nullptr});
    d.detail = "tiles";
    d.vertex = shaders::tileSpanVertex;
    setTileView(d.constants, view);
    setShadingConstants(d.constants, view);
    d.streams = spanStreams();
    d.layout = *layout.pipeline;
    d.colorsWritten = 1;
    if (context.ahead) return context.pipelines.want(d);
    context.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, context.pipelines.graphics(d));
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    TileBindings bindings(context, set, 0);
    bindings.sample(atlas);
    bindings.uniform(*view.effectConstants);
    bindings.sample(shadowOf(context, view, atlas));
    bindings.read(f.numbers);
    bindings.read(scene.shapes, scene.shapeTexels);
    bindings.read(f.rows);
    bindings.read(scene.looks, scene.lookTexels);
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout.pipeline, 0, set, {});
    bindCounter(context, view, layout);
    context.commands.pushConstants<layout::TileConstants>(*layout.pipeline, kDraw, 0, f.constants);
    drawSpans(context, f);
}

}  // namespace nacre::passes
