#include "engine/frame/debug_frame.h"

#include <array>

namespace nacre {
namespace {

using graph::Clear;
using passes::Nearest;
using passes::Writes;

constexpr ScreenTarget kSurface{"surface", VK_FORMAT_R32G32B32A32_SFLOAT, Writes::surface};
constexpr ScreenTarget kIdentity{"identity", VK_FORMAT_R32G32_UINT, Writes::identity};
constexpr ScreenTarget kShaded{"shaded", VK_FORMAT_R8G8B8A8_SRGB, Writes::color};

/// What the screen frame draws for a view.
std::span<const ScreenTarget> drawnFor(DebugView view) {
    switch (view) {
        case DebugView::depth:
        case DebugView::normals:
            return {&kSurface, 1};
        case DebugView::id:
        case DebugView::occlusion:
            return {&kIdentity, 1};
        case DebugView::plates:
            return {&kShaded, 1};
        default:
            return {};
    }
}

/// Adds the passes between the screen frame's and the picture.
DebugInputs inputsOf(DebugView view, ScreenFrame& frame, graph::Extent extent, const ScreenRecord& record,
                     const DebugRecord& show) {
    graph::Graph& g = frame.graph;
    if (view == DebugView::encoded) return {frame.nearest, {}};
    if (view == DebugView::patches) return {frame.atlas, {}};
    if (view == DebugView::plates) {
        // Once more, for themselves: on some paths the frame's own depth goes on to hold the impostors.
        const auto plates = g.image("plates", {VK_FORMAT_D32_SFLOAT, extent});
        auto pass = g.graphics(passes::nameOf(Writes::plates));
        pass.depth(plates, Clear{1.0f});
        if (record) pass.record(record(Writes::plates, {frame.atlas, frame.nearest}));
        return {plates, frame.targets[0], true};
    }
    if (view != DebugView::overdraw && view != DebugView::tiles) return {frame.targets[0], {}};
    const auto counts = g.image("overdraw", {VK_FORMAT_R8_UNORM, extent});
    auto pass = g.graphics(passes::nameOf(Writes::overdraw));
    pass.depthTest(frame.depth).color(counts, Clear{0.0f});
    if (record) pass.record(record(Writes::overdraw, {frame.atlas, frame.nearest}));
    if (view == DebugView::overdraw) return {counts, {}};
    const auto tilesAcross = [](std::uint32_t pixels) { return (pixels + kDebugTile - 1) / kDebugTile; };
    const auto tiles =
        g.image("tiles", {VK_FORMAT_R32_SFLOAT, {tilesAcross(extent.width), tilesAcross(extent.height)}});
    auto mean = g.graphics("tile mean");
    mean.samples(counts).color(tiles);
    if (show) mean.record(show({counts, {}, false, true}));
    return {tiles, counts, true};
}

}  // namespace

std::span<const char* const> debugViewNames() {
    static constexpr std::array kNames{"none",      "depth",   "encoded", "plates",  "overdraw",
                                       "occlusion", "patches", "id",      "normals", "tiles"};
    return kNames;
}

Nearest debugNearest(DebugView view, Nearest usual) {
    switch (view) {
        case DebugView::encoded:
            return Nearest::encoded;
        case DebugView::overdraw:
        case DebugView::tiles:
        case DebugView::patches:
            return Nearest::fragdepth;  // the prepass alone
        default:
            // A float picture beside the nearest depth would not fit the tile.
            return usual == Nearest::rasterOrder ? Nearest::fragdepth : usual;
    }
}

ScreenFrame debugFrame(DebugView view, const ScreenFrameOptions& options, const ScreenRecord& record,
                       const DebugRecord& show) {
    ScreenFrameOptions drawn = options;
    drawn.targets = drawnFor(view);
    ScreenFrame frame = screenFrame(drawn, record);
    const DebugInputs inputs = inputsOf(view, frame, options.extent, record, show);
    const ScreenTarget& target = options.targets[0];
    const graph::ImageDesc desc{target.format, options.extent};
    const graph::Image picture = target.window ? frame.graph.importImage(target.image, desc, kWindowState, true)
                                               : frame.graph.image(target.image, desc);
    graph::PassBuilder pass = frame.graph.graphics("debug view");
    pass.samples(inputs.source);
    if (inputs.hasUnder) pass.samples(inputs.under);
    pass.color(picture, target.clear);
    if (show) pass.record(show(inputs));
    frame.targets = {picture};
    frame.passes.clear();
    return frame;
}

}  // namespace nacre
