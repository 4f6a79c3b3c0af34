#include "engine/frame/screen.h"

namespace nacre {

using graph::Clear;

graph::Image ScreenFrame::add(const ScreenTarget& target, graph::Extent extent) {
    const graph::ImageDesc desc{target.format, extent};
    targets.push_back(target.window ? graph.importImage(target.image, desc, kWindowState, true)
                                    : graph.image(target.image, desc));
    return targets.back();
}

graph::PassBuilder& ScreenFrame::lit(graph::PassBuilder& pass) const {
    pass.samples(atlas);
    return shadow ? pass.samples(*shadow) : pass;
}

ScreenFrame screenFrame(const ScreenOptions& options, const Recorder& recorder) {
    ScreenFrame frame;
    frame.graph = graph::Graph(options.name);
    frame.depth = frame.nearest = frame.graph.image("depth", {VK_FORMAT_D32_SFLOAT, options.extent});
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
