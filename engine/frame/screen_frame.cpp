#include "engine/frame/screen_frame.h"

#include "engine/scene/representation.h"

namespace nacre {
namespace {

using graph::Clear;
using passes::Nearest;
using passes::Writes;

constexpr Fetch kPositions{sizeof(Sphere), sizeof(Cylinder)};
constexpr Fetch kPlates{sizeof(Sphere), 0};
constexpr Fetch kRecords{sizeof(Sphere) + sizeof(SphereLook), sizeof(Cylinder) + sizeof(CylinderLook)};
constexpr Fetch kRecordsOfPixel{kRecords.sphere, kRecords.cylinder, true};

constexpr const char* kPrecisionPlates = "fp32: positions; no fragment arithmetic";
constexpr const char* kPrecisionHit = "fp32: positions, hit, depth (a half tells 0.06 A apart at 100 A)";
constexpr const char* kPrecisionShade =
    "fp32: positions, hit, depth, atlas address; fp16 would do: normal, occlusion, light, colour";

/// Depth of a pass that writes the hit's own depth.
constexpr const char* kConservative =
    "gl_FragDepth is declared depth_greater: what the polygon hides is rejected early, the hit itself is tested late";

ScreenPass notesOf(Writes writes, Nearest nearest, bool settles) {
    switch (writes) {
        case Writes::plates:
            return {
                writes, DepthTiming::early, "depth comes from the plate's corners; the shader has no output", kPlates,
                {},     kPrecisionPlates};
        case Writes::encoded:
            return {writes,
                    DepthTiming::early,
                    "depth is only tested; outside the outline MIN's neutral value is "
                    "written instead of a discard",
                    kPositions,
                    kPositions,
                    kPrecisionHit};
        case Writes::depth:
        case Writes::number:
            return {writes, DepthTiming::conservative, kConservative, kPositions, kPositions, kPrecisionHit};
        case Writes::overdraw:  // of debug views alone
        case Writes::color:
        case Writes::surface:
        case Writes::identity:
            break;
    }
    if (nearest == Nearest::deferred)
        return {writes, DepthTiming::none, "one triangle over the screen; each covered pixel is shaded once",
                {},     kRecordsOfPixel,   kPrecisionShade};
    if (nearest == Nearest::fragdepth || settles)
        return {writes, DepthTiming::conservative, kConservative, kPositions, kRecords, kPrecisionShade};
    return {writes,     DepthTiming::early, "depth is only tested, so that a discard cannot delay it",
            kPositions, kRecords,           kPrecisionShade};
}

}  // namespace

ScreenFrame screenFrame(const ScreenFrameOptions& options, const ScreenRecord& record) {
    ScreenFrame frame{graph::Graph(options.name), {}, {}, {}, {}, {}};
    graph::Graph& g = frame.graph;
    const Nearest nearest = options.nearest;
    const bool settles = nearest == Nearest::encoded && options.encoded.settles();
    // In raster order one target keeps the nearest depth itself; several (the layers) share what a pass before them
    // kept.
    const bool ordered = nearest == Nearest::rasterOrder;
    const bool shared = ordered && options.targets.size() > 1;
    frame.depth = frame.nearest = g.image("depth", {VK_FORMAT_D32_SFLOAT, options.extent});
    frame.atlas = g.importImage(
        "occlusion atlas", options.atlas,
        {VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    const auto pass = [&](Writes writes) {
        frame.passes.push_back(notesOf(writes, nearest, settles));
        graph::PassBuilder builder = g.graphics(passes::nameOf(writes));
        if (record) builder.record(record(writes, {frame.atlas, frame.nearest, shared && passes::shades(writes)}));
        return builder;
    };

    pass(Writes::plates).depth(frame.depth, Clear{1.0f});
    if (nearest == Nearest::encoded) {
        frame.nearest = g.image("encoded depth", {options.encoded.format, options.extent});
        pass(Writes::encoded).depthTest(frame.depth).color(frame.nearest, Clear{options.encoded.farthest});
    } else if (nearest == Nearest::deferred) {
        frame.nearest = g.image("primitive number", {VK_FORMAT_R32_UINT, options.extent});
        pass(Writes::number).depth(frame.depth).color(frame.nearest, Clear{0.0f});
    }
    if (ordered) frame.nearest = g.image("nearest depth", {VK_FORMAT_R32_SFLOAT, options.extent});
    if (shared) pass(Writes::encoded).depthTest(frame.depth).ordered(frame.nearest, Clear{1.0f});
    for (const ScreenTarget& target : options.targets) {
        const graph::ImageDesc desc{target.format, options.extent};
        frame.targets.push_back(target.window ? g.importImage(target.image, desc, kWindowState, true)
                                              : g.image(target.image, desc));
        graph::PassBuilder shading = pass(target.writes);
        if (nearest == Nearest::fragdepth || settles)
            shading.depth(frame.depth);
        else if (nearest != Nearest::deferred)
            shading.depthTest(frame.depth);
        if (nearest == Nearest::encoded || nearest == Nearest::deferred) shading.input(frame.nearest);
        shading.samples(frame.atlas).color(frame.targets.back(), target.clear);
        if (shared)
            shading.samples(frame.nearest);
        else if (ordered)
            shading.ordered(frame.nearest, Clear{1.0f});
    }
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

const char* depthTimingName(DepthTiming timing) {
    switch (timing) {
        case DepthTiming::none:
            return "none";
        case DepthTiming::early:
            return "early";
        case DepthTiming::conservative:
            return "conservative";
    }
    return "";
}

Nearest nearestOf(Visibility visibility) {
    switch (visibility) {
        case Visibility::fragdepth:
            return Nearest::fragdepth;
        case Visibility::deferred:
            return Nearest::deferred;
        case Visibility::rasterOrder:
            return Nearest::rasterOrder;
        default:
            return Nearest::encoded;
    }
}

}  // namespace nacre
