#include "engine/frame/debug/debug_frame.h"

#include <array>

#include "engine/frame/paths/paths.h"
#include "engine/frame/record.h"
#include "engine/passes/bindings.h"
#include "engine/passes/full_screen.h"
#include "engine/passes/geometry_passes.h"
#include "shaders.h"

namespace nacre {
namespace passes {
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

/// Turns an image of the frame into a picture (shaders/debug_view.frag).
/// @param tile   tile width of DebugView::tiles, pixels
/// @param under  null if the view reads one image
void drawDebugView(gpu::PassContext& context, const SceneView& view, DebugView what, std::uint32_t tile,
                   vk::ImageView source, vk::ImageView under) {
    // Always written, even if the shader reads one image: lavapipe accesses both.
    const vk::ImageView images[] = {source, under ? under : source};
    FullScreenPass pass{chooseShader(what), {}, debugViewNames()[static_cast<std::size_t>(what)]};
    pass.constants.set(layout::kDebugViewId, static_cast<std::int32_t>(what));
    pass.constants.set(layout::kBounceId, view.bounced);
    drawShown(context, view, std::move(pass), tile, images);
}

/// The mean of each tile of an image, one pixel per tile.
void drawTileMean(gpu::PassContext& context, const SceneView& view, std::uint32_t tile, vk::ImageView source) {
    const vk::ImageView images[] = {source, source};
    drawShown(context, view, {shaders::tileMean, {}, {}}, tile, images);
}

}  // namespace
}  // namespace passes

namespace {

using graph::Clear;
using passes::Output;
using passes::SceneView;

constexpr ScreenTarget kSurface{"surface", VK_FORMAT_R32G32B32A32_SFLOAT, Output::surface, "surface layer"};
constexpr ScreenTarget kIdentity{"identity", VK_FORMAT_R32G32_UINT, Output::identity, "identity layer"};
constexpr ScreenTarget kShaded{"shaded", VK_FORMAT_R8G8B8A8_SRGB, Output::color, "impostor colour"};
constexpr ScreenTarget kCodedShaded{"shaded", VK_FORMAT_R8G8B8A8_UNORM, Output::color, "impostor colour"};

/// Targets of the screen frame that a view needs.
std::span<const ScreenTarget> drawnFor(DebugView view, bool coded) {
    switch (view) {
        case DebugView::depth:
        case DebugView::normals:
            return {&kSurface, 1};
        case DebugView::id:
        case DebugView::occlusion:
            return {&kIdentity, 1};
        case DebugView::plates:
            return {coded ? &kCodedShaded : &kShaded, 1};
        default:
            return {};
    }
}

/// Images that the view reads.
struct Shown {
    graph::Image source;
    std::optional<graph::Image> under;
};

/// Repeats the prepass with its own depth buffer: on some paths the frame's depth later holds the impostors.
graph::Image addPlates(Frame& f, graph::Extent extent, const Rounds& rounds) {
    graph::Image plates = f.graph.image("plates", {VK_FORMAT_D32_SFLOAT, extent});
    declarePrepass(f, plates, rounds);
    return plates;
}

/// Number of impostor fragments per pixel that pass the depth test, in steps of 1/255.
passes::GeometryPass overdraw() {
    passes::GeometryPass pass{NACRE_SHADERS(geometry, , overdraw, )};
    pass.blend = gpu::Blend::add;
    return pass;
}

graph::Image addOverdraw(Frame& f, graph::Extent extent, const Rounds& rounds) {
    graph::Image counts = f.graph.image("overdraw", {VK_FORMAT_R8_UNORM, extent});
    for (const graph::Share& share : rounds.shares())
        f.graph.graphics("overdraw")
            .share(share)
            .depthTest(f.depth)
            .color(counts, clearFirst(share, 0.0f))
            .record(
                records(f, [](gpu::PassContext& c, const SceneView& scene) { passes::draw(c, scene, overdraw()); }));
    return counts;
}

graph::Image addTileMeans(Frame& f, graph::Extent extent, graph::Image counts) {
    const auto tilesAcross = [](std::uint32_t pixels) { return (pixels + kDebugTile - 1) / kDebugTile; };
    graph::Image tiles =
        f.graph.image("tiles", {VK_FORMAT_R32_SFLOAT, {tilesAcross(extent.width), tilesAcross(extent.height)}});
    f.graph.graphics("tile mean")
        .samples(counts)
        .color(tiles)
        .record(records(f, [counts](gpu::PassContext& c, const SceneView& scene) {
            passes::drawTileMean(c, scene, kDebugTile, c.view(counts));
        }));
    return tiles;
}

/// Adds the passes between the screen frame's and the picture.
Shown addShown(DebugView view, Frame& f, graph::Extent extent, const VertexOutputs& vertices) {
    switch (view) {
        case DebugView::encoded:
            return {f.nearest, {}};
        case DebugView::patches:
            return {f.atlas, {}};
        case DebugView::plates:
            return {addPlates(f, extent, vertices.plating), f.targets[0]};
        case DebugView::overdraw:
            return {addOverdraw(f, extent, vertices.shading), {}};
        case DebugView::tiles: {
            const graph::Image counts = addOverdraw(f, extent, vertices.shading);
            return {addTileMeans(f, extent, counts), counts};
        }
        default:
            return {f.targets[0], {}};
    }
}

}  // namespace

std::span<const char* const> debugViewNames() {
    static constexpr std::array kNames{"none",      "depth",   "encoded", "plates",  "overdraw",
                                       "occlusion", "patches", "id",      "normals", "tiles"};
    return kNames;
}

void declareDebugView(Frame& f, const FrameShape& shape) {
    const DebugView view = shape.choice.debug;
    const ScreenTarget& target = shape.targets[0];
    FrameShape drawn = shape;
    drawn.choice.debug = DebugView::none;
    drawn.choice.ending = Ending::left;
    drawn.targets = drawnFor(view, target.format == VK_FORMAT_R8G8B8A8_UNORM);
    declarePath(f, drawn);
    const Shown shown = addShown(view, f, shape.extent, shape.choice.vertices);
    f.targets.clear();
    graph::Image& picture = f.add(target, shape);
    graph::PassBuilder pass = f.graph.graphics("debug view");
    pass.samples(shown.source);
    if (shown.under) pass.samples(*shown.under);
    pass.color(picture, target.clear).record(records(f, [=](gpu::PassContext& c, const SceneView& scene) {
        passes::drawDebugView(c, scene, view, kDebugTile, c.view(shown.source),
                              shown.under ? c.view(*shown.under) : vk::ImageView());
    }));
}

}  // namespace nacre
