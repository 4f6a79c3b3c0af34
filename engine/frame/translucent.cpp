#include <string>

#include "engine/frame/screen.h"
#include "engine/scene/tile_lists.h"

namespace nacre {

// The nearest triangles of all are found before anything opaque is: those of them that something opaque hides are left
// out when they are laid over it. So the frame of what is opaque is the same as without them, in one piece.

void declareTranslucentLayers(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    if (options.layersByTiles) {
        const std::uint64_t pixels = TileLists::pixelsOfBins(options.extent.width, options.extent.height);
        static_assert(kTranslucentLayers == 2);  // as shaders/tile_layers.comp
        f.layerNumbers = f.graph.importBuffer("translucent layers", 2 * sizeof(std::uint32_t) * pixels);
        f.graph.compute("translucent layers").writes(*f.layerNumbers).record(draw.layersByTiles());
        return;
    }
    std::optional<graph::Image> before;
    for (std::uint32_t i = 0; i < options.translucentLayers; ++i) {
        const std::string name = kTranslucentLayer + std::to_string(i + 1);
        const graph::Image depth = f.graph.image(name + " depth", {VK_FORMAT_D32_SFLOAT, options.extent});
        f.layers.push_back(f.graph.image(name, {VK_FORMAT_R32_UINT, options.extent}));
        graph::PassBuilder pass = f.graph.graphics(name);
        if (before) pass.samples(*before);
        pass.depth(depth, graph::Clear{1.0f}).color(f.layers.back(), graph::Clear{0.0f});
        pass.record(draw.translucentLayer(f.atlas, before));
        before = depth;
    }
}

void declareTranslucentColors(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    const bool ordered = options.visibility == Visibility::rasterOrder;
    const bool encodes = options.visibility == Visibility::encoded || ordered;
    const std::optional<graph::Image> nearest = encodes ? std::optional(f.nearest) : std::nullopt;
    for (std::uint32_t i = options.translucentLayers; i-- > 0;) {
        graph::PassBuilder pass = f.graph.graphics(kTranslucentColor + std::to_string(i + 1));
        if (f.layerNumbers) {
            f.lit(pass.reads(*f.layerNumbers).depthTest(f.depth)).color(f.targets[0]);
            pass.record(draw.layerOfTiles(f.atlas, i));
            continue;
        }
        f.lit(pass.samples(f.layers[i]));
        nearest ? pass.input(*nearest) : pass.depthTest(f.depth);
        pass.color(f.targets[0])
            .record(draw.translucentColor(f.atlas, f.layers[i], nearest,
                                          ordered ? graph::EncodedFormat() : options.encoded));
    }
}

}  // namespace nacre
