#include "engine/frame/debug_frame.h"

#include <array>

namespace nacre {
namespace {

using graph::Clear;
using passes::Output;

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

/// Images that the view is made from.
struct Shown {
    graph::Image source;
    std::optional<graph::Image> under;
};

/// The prepass once more, for itself: on some paths the frame's own depth goes on to hold the impostors.
graph::Image addPlates(ScreenFrame& f, graph::Extent extent, const Recorder& draw) {
    const auto plates = f.graph.image("plates", {VK_FORMAT_D32_SFLOAT, extent});
    f.graph.graphics("opaque prepass").depth(plates, Clear{1.0f}).record(draw.plates());
    return plates;
}

graph::Image addOverdraw(ScreenFrame& f, graph::Extent extent, const Recorder& draw) {
    const auto counts = f.graph.image("overdraw", {VK_FORMAT_R8_UNORM, extent});
    f.graph.graphics("overdraw").depthTest(f.depth).color(counts, Clear{0.0f}).record(draw.overdraw());
    return counts;
}

graph::Image addTileMeans(ScreenFrame& f, graph::Extent extent, graph::Image counts, const Recorder& draw) {
    const auto tilesAcross = [](std::uint32_t pixels) { return (pixels + kDebugTile - 1) / kDebugTile; };
    const auto tiles =
        f.graph.image("tiles", {VK_FORMAT_R32_SFLOAT, {tilesAcross(extent.width), tilesAcross(extent.height)}});
    f.graph.graphics("tile mean").samples(counts).color(tiles).record(draw.tileMean(kDebugTile, counts));
    return tiles;
}

/// Adds the passes between the screen frame's and the picture.
Shown addShown(DebugView view, ScreenFrame& f, graph::Extent extent, const Recorder& draw) {
    switch (view) {
        case DebugView::encoded:
            return {f.nearest, {}};
        case DebugView::patches:
            return {f.atlas, {}};
        case DebugView::plates:
            return {addPlates(f, extent, draw), f.targets[0]};
        case DebugView::overdraw:
            return {addOverdraw(f, extent, draw), {}};
        case DebugView::tiles: {
            const graph::Image counts = addOverdraw(f, extent, draw);
            return {addTileMeans(f, extent, counts, draw), counts};
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

Visibility debugVisibility(DebugView view, Visibility usual) {
    switch (view) {
        case DebugView::encoded:
            return Visibility::encoded;
        case DebugView::overdraw:
        case DebugView::tiles:
        case DebugView::patches:
            return Visibility::fragdepth;  // the prepass alone
        default:
            // A float picture in addition to the nearest depth would not fit the tile.
            return usual == Visibility::rasterOrder ? Visibility::fragdepth : usual;
    }
}

ScreenFrame debugFrame(DebugView view, const ScreenOptions& options, const Recorder& recorder) {
    ScreenOptions drawn = options;
    drawn.targets = drawnFor(view, options.targets[0].format == VK_FORMAT_R8G8B8A8_UNORM);
    drawn.prepass = true;  // views show it
    ScreenFrame frame = screenFrame(drawn, recorder);
    const Shown shown = addShown(view, frame, options.extent, recorder);
    frame.targets.clear();
    const ScreenTarget& target = options.targets[0];
    const graph::Image picture = frame.add(target, options.extent);
    graph::PassBuilder pass = frame.graph.graphics("debug view");
    pass.samples(shown.source);
    if (shown.under) pass.samples(*shown.under);
    pass.color(picture, target.clear).record(recorder.debugView(view, kDebugTile, shown.source, shown.under));
    return frame;
}

}  // namespace nacre
