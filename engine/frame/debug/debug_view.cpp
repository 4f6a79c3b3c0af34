#include "engine/frame/debug/debug_view.h"

#include "engine/passes/bindings.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

constexpr Type kLayers[] = {kSampled, kSampled};
static_assert(layout::kDebugEncoded == int(DebugView::encoded) && layout::kDebugPlates == int(DebugView::plates) &&
              layout::kDebugOverdraw == int(DebugView::overdraw) && layout::kDebugPatches == int(DebugView::patches) &&
              layout::kDebugId == int(DebugView::id) && layout::kDebugNormals == int(DebugView::normals));

gpu::ShaderWords chooseShader(DebugView view) {
    switch (view) {
        case DebugView::occlusion:
        case DebugView::id:
            return shaders::debugNumbers;
        case DebugView::plates:
        case DebugView::tiles:
            return shaders::debugTwoImages;
        default:
            return shaders::debugImage;
    }
}

void drawShown(gpu::PassContext& context, const SceneView& view, FullScreenPass pass, std::uint32_t tile,
               std::span<const vk::ImageView> images) {
    constexpr auto kStages = vk::ShaderStageFlagBits::eFragment;
    const gpu::Layout& layout =
        context.pipelines.layout({"debug view layout", kLayers, kStages, sizeof(layout::ViewConstants)});
    const graph::EncodedFormat& encoded = context.device.caps().encoded;
    pass.constants.set(layout::kPerspectiveId, view.perspective);
    pass.constants.set(layout::kDepthChannelsId, encoded.channels);
    pass.constants.set(layout::kDepthStepsId, encoded.steps);
    pass.constants.set(layout::kQuarterTurnsId, view.quarterTurns);
    pass.constants.set(layout::kTileId, tile);
    pass.constants.set(layout::kCodedId, view.coded);
    bindFullScreen(context, pass, layout);
    bindTextures(context, layout, vk::Filter::eNearest, images);
    drawFullScreen(context, layout, kStages, view.constants);
}

}  // namespace

void drawDebugView(gpu::PassContext& context, const SceneView& view, DebugView what, std::uint32_t tile,
                   vk::ImageView source, vk::ImageView under) {
    // Always written, even if the shader reads one image: lavapipe accesses both.
    const vk::ImageView images[] = {source, under ? under : source};
    FullScreenPass pass{chooseShader(what), {}, debugViewNames()[static_cast<std::size_t>(what)]};
    pass.constants.set(layout::kDebugViewId, static_cast<std::int32_t>(what));
    drawShown(context, view, std::move(pass), tile, images);
}

void drawTileMean(gpu::PassContext& context, const SceneView& view, std::uint32_t tile, vk::ImageView source) {
    const vk::ImageView images[] = {source, source};
    drawShown(context, view, {shaders::tileMean, {}, {}}, tile, images);
}

}  // namespace nacre::passes
