#include "engine/passes/primitives.h"
#include "engine/tiles/tile_bindings.h"
#include "engine/tiles/tiles.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

// Shapes, rows of copies, lists; numbers, which are written.
constexpr std::array kNumberTypes{kStorage, kStorage, kStorage, Type::eStorageImage};

const gpu::Layout& numberLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"numbers by tiles", kNumberTypes, kCompute, sizeof(layout::TileConstants)});
}

gpu::ComputePipeline numberPipeline(gpu::PipelineContext& context, const SceneView& view) {
    const TileScene scene = tileScene(*view.buffers);
    gpu::ComputePipeline d{context.pass, NACRE_TILE_SCENE(tileNumbers), {}, *numberLayout(context).pipeline};
    setTileView(d.constants, view);
    return d;
}

}  // namespace

void want(gpu::PipelineContext& context, const SceneView& view, const TileNumbers&) {
    if (!view.buffers->empty()) context.pipelines.want(numberPipeline(context, view));
}

void draw(gpu::PassContext& context, const SceneView& view, const TileNumbers& pass) {
    const ListedFrame& f = listedFrame(view);
    if (view.buffers->empty()) return;
    bindTiles(context, numberLayout(context), numberPipeline(context, view), f.constants, [&](TileBindings& to) {
        to.store(view.buffers->shapes);
        to.store(f.rows.buffer);
        to.store(f.words.buffer);
        to.store(pass.image);
    });
    dispatchTiles(context, f.tiles().tiles().size());
}

}  // namespace nacre::passes
