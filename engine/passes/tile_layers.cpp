#include "engine/passes/tile_layers.h"

#include "engine/passes/tile_bindings.h"
#include "engine/passes/tile_passes.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

// Shapes, rows of copies, lists; numbers, which are written.
constexpr vk::DescriptorType kTexels[] = {kTexel, kTexel, kTexel, kStorage};
constexpr vk::DescriptorType kBuffers[] = {kStorage, kStorage, kStorage, kStorage};

}  // namespace

void findLayersByTiles(gpu::PassContext& context, const SceneView& view) {
    constexpr auto kStage = vk::ShaderStageFlagBits::eCompute;
    constexpr auto kPoint = vk::PipelineBindPoint::eCompute;
    const TileFrame& f = *view.tiles;
    const gpu::TileCaps& caps = context.device.caps().tiles;
    if (f.lists.tiles().empty()) return;
    const gpu::Layout& layout = context.pipelines.layout(
        {"layers by tiles", caps.texels ? kTexels : kBuffers, kStage, sizeof(layout::TileConstants)});
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
    context.commands.pushConstants<layout::TileConstants>(*layout.pipeline, kStage, 0, f.constants);
    dispatchTiles(context, f.lists.tiles().size());
}

void shadeLayerByTiles(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas, std::uint32_t layer) {
    const bool texels = context.device.caps().tiles.texels;
    const Stage stage = texels ? Stage{shaders::tileTranslucentTexels, shaders::tileTranslucentTexelsCounting}
                               : Stage{shaders::tileTranslucentStorage, shaders::tileTranslucentStorageCounting};
    gpu::GraphicsPipeline d = context.pipeline();
    d.fragment = stage.of(view);
    d.constants.set(layout::kLayerId, layer);
    d.depth = gpu::DepthUse::test;
    d.blend = gpu::Blend::over;
    shadeSpans(context, view, atlas, d);
}

}  // namespace nacre::passes
