#include "engine/frame/screen.h"

#include "engine/graph/plan.h"
#include "engine/passes/read_back.h"
#include "engine/software/tile_lists.h"

namespace nacre {

using graph::Clear;
using passes::NearestFrom;

graph::Image ScreenFrame::add(const ScreenTarget& target, graph::Extent extent) {
    const graph::ImageDesc desc{target.format, extent};
    targets.push_back(target.window ? graph.importImage(target.image, desc, kWindowState, true)
                      : intoPicture ? graph.importImage("picture", desc, passes::kTextureState, true)
                                    : graph.image(target.image, desc));
    return targets.back();
}

graph::PassBuilder& ScreenFrame::draw(graph::PassBuilder& pass, const ScreenTarget& target,
                                      const ScreenOptions& options) {
    const graph::Image image = add(target, options.extent);
    if (options.samples == 1) return pass.color(image, target.clear);
    samples = graph.image(std::string(target.image) + " samples", {target.format, options.extent, options.samples});
    return pass.color(*samples, target.clear).resolve(image);
}

graph::PassBuilder& ScreenFrame::lit(graph::PassBuilder& pass) const {
    pass.samples(atlas);
    return shadow ? pass.samples(*shadow) : pass;
}

namespace {

void addPrepass(ScreenFrame& f, const Recorder& draw) {
    f.graph.graphics("opaque prepass").depth(f.depth, Clear{1.0f}).record(draw.plates());
}

// One function per visibility path (tiles: own file). Each declares its passes into a frame that has its depth and
// atlas.

/// The paper's: opaque prepass, encoded depth, impostor colour; three subpasses, and colour alone leaves the tile.
void declareEncoded(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    const graph::EncodedFormat& format = options.encoded;
    addPrepass(f, draw);
    f.nearest = f.graph.image("encoded depth", {format.format, options.extent});
    graph::PassBuilder encoding = f.graph.graphics("depth encoding").depthTest(f.depth);
    if (format.ordered)
        encoding.ordered(f.nearest, Clear{format.farthest}).record(draw.encodedDepthInOrder(f.atlas, f.nearest));
    else
        encoding.color(f.nearest, Clear{format.farthest}).record(draw.encodedDepth(format));

    for (const ScreenTarget& target : options.targets) {
        const graph::Image image = f.add(target, options.extent);
        graph::PassBuilder shading = f.graph.graphics(target.pass);
        // Coarse encodings leave ties, which the depth buffer settles.
        format.settles() ? shading.depth(f.depth) : shading.depthTest(f.depth);
        f.lit(shading.input(f.nearest)).color(image, target.clear);
        shading.record(draw.impostorsAtEncodedDepth(target.output, f.atlas, f.nearest, format));
    }
}

/// Opaque prepass and impostor colour in one subpass; depth is settled by gl_FragDepth.
void declareFragdepth(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    std::optional<Clear> clear;
    options.prepass ? addPrepass(f, draw) : void(clear = Clear{1.0f});
    for (const ScreenTarget& target : options.targets) {
        f.draw(f.lit(f.graph.graphics(target.pass).depth(f.depth, clear)), target, options)
            .record(draw.impostors(target.output, NearestFrom::depthBuffer, f.atlas, {}, clear.has_value()));
        clear.reset();
    }
}

/// Numbers of the nearest primitives by gl_FragDepth, then every covered pixel is shaded once. With rims they are drawn
/// in between, where a pixel's nearest primitive is known and nothing has left the tile.
void declareDeferred(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    std::optional<Clear> clear;
    options.prepass ? addPrepass(f, draw) : void(clear = Clear{1.0f});
    f.nearest = options.rims ? f.graph.image("primitive number, distance", {VK_FORMAT_R32G32_UINT, options.extent})
                             : f.graph.image("primitive number", {VK_FORMAT_R32_UINT, options.extent});
    f.graph.graphics("nearest primitive")
        .depth(f.depth, clear)
        .color(f.nearest, Clear{0.0f})
        .record(draw.nearestPrimitive(options.rims, clear.has_value()));

    if (options.rims) {
        const graph::Image rims = f.graph.image(kRimPass, {VK_FORMAT_R8G8B8A8_UNORM, options.extent});
        f.graph.graphics(kRimPass)
            .depthTest(f.depth)
            .input(f.nearest)
            .color(rims, Clear{0.0f})
            .record(draw.rims(f.atlas, f.nearest));
        const ScreenTarget& target = options.targets[0];
        f.lit(f.graph.graphics(target.pass).input(f.nearest).input(rims))
            .color(f.add(target, options.extent), target.clear)
            .record(draw.rimmedPrimitives(f.atlas, f.nearest, rims, target.clear));
        return;
    }
    for (const ScreenTarget& target : options.targets)
        f.lit(f.graph.graphics(target.pass).input(f.nearest))
            .color(f.add(target, options.extent), target.clear)
            .record(draw.shadedPrimitives(target.output, f.atlas, f.nearest));
}

/// Nearest depth is read and written as an attachment in raster order: no blending, no second pass over the impostors.
void declareRasterOrder(ScreenFrame& f, const ScreenOptions& options, const Recorder& draw) {
    addPrepass(f, draw);
    f.nearest = f.graph.image("nearest depth", {VK_FORMAT_R32_SFLOAT, options.extent, options.samples});
    constexpr std::uint32_t kNarrow = 8;  // bytes of colour: the depth beside it fits every tile
    if (options.targets.size() == 1 && graph::bytesPerTexel(options.targets[0].format) <= kNarrow) {
        // It keeps the nearest depth itself.
        const ScreenTarget& target = options.targets[0];
        f.draw(f.lit(f.graph.graphics(target.pass).depthTest(f.depth)), target, options)
            .ordered(f.nearest, Clear{1.0f})
            .record(draw.impostors(target.output, NearestFrom::ownAttachment, f.atlas, f.nearest));
        return;
    }
    f.graph.graphics("depth encoding")
        .depthTest(f.depth)
        .ordered(f.nearest, Clear{1.0f})
        .record(draw.encodedDepthInOrder(f.atlas, f.nearest));
    for (const ScreenTarget& target : options.targets)  // share the previous pass's attachments
        f.lit(f.graph.graphics(target.pass).depthTest(f.depth))
            .color(f.add(target, options.extent), target.clear)
            .samples(f.nearest)
            .record(draw.impostors(target.output, NearestFrom::texture, f.atlas, f.nearest));
}

// On every path:

// Translucent triangles are found before opaque visibility; hidden ones are dropped during compositing. So the opaque
// frame is identical with and without them, in one piece.

/// Numbers of the nearest translucent triangles of each pixel, and of the next ones behind.
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
        pass.depth(depth, Clear{1.0f}).color(f.layers.back(), Clear{0.0f});
        pass.record(draw.translucentLayer(f.atlas, before));
        before = depth;
    }
}

/// Composites the layers over the path's result, farthest first.
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

}  // namespace

ScreenFrame screenFrame(const ScreenOptions& options, const Recorder& recorder) {
    ScreenFrame frame;
    frame.graph = graph::Graph(options.name);
    frame.intoPicture = options.intoPicture;
    frame.depth = frame.nearest = frame.graph.image("depth", {VK_FORMAT_D32_SFLOAT, options.extent, options.samples});
    frame.atlas = frame.graph.importImage(
        "occlusion atlas", options.atlas,
        {VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    if (options.shadowPixels > 0) {
        const std::uint32_t side = options.shadowPixels;
        frame.shadow = frame.graph.image("shadow map", {VK_FORMAT_D32_SFLOAT, {side, side}});
        frame.graph.graphics(kShadowPass).depth(*frame.shadow, Clear{1.0f}).record(recorder.shadowMap());
    }
    declareTranslucentLayers(frame, options, recorder);
    switch (options.visibility) {
        case Visibility::fragdepth:
            declareFragdepth(frame, options, recorder);
            break;
        case Visibility::deferred:
            declareDeferred(frame, options, recorder);
            break;
        case Visibility::rasterOrder:
            declareRasterOrder(frame, options, recorder);
            break;
        case Visibility::tiles:
            declareTiles(frame, options, recorder);
            break;
        case Visibility::automatic:
        case Visibility::encoded:
            declareEncoded(frame, options, recorder);
            break;
    }
    declareTranslucentColors(frame, options, recorder);
    return frame;
}

std::string lacksSamples(const Effects& effects, bool translucent) {
    if (effects.rims() || effects.contours.width > 0) return "outlines and halos have one sample per pixel";
    if (translucent) return "translucent surfaces have one sample per pixel";
    return {};
}

graph::Graph paperFrame(graph::Extent extent) {
    graph::Graph g("paper");
    const auto depth = g.image("depth", {VK_FORMAT_D16_UNORM, extent});
    const auto texture = g.image("depth texture", {VK_FORMAT_R8G8B8A8_UNORM, extent});
    const auto color = g.image("colour", {VK_FORMAT_R8G8B8A8_UNORM, extent});
    g.graphics("opaque prepass").depth(depth, Clear{1.0f});
    g.graphics("depth texture").depthTest(depth).color(texture, Clear{1.0f});
    g.graphics("picture").depthTest(depth).samples(texture).color(color, Clear{1.0f});
    g.output(color);
    return g;
}

}  // namespace nacre
