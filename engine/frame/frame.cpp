#include "engine/frame/frame.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>

#include "engine/frame/debug/debug_frame.h"
#include "engine/frame/effects/lens/lens.h"
#include "engine/frame/effects/shadow/shadow.h"
#include "engine/frame/effects/translucency/translucency.h"
#include "engine/frame/effects/volume/volume.h"
#include "engine/frame/foveation.h"
#include "engine/frame/paths/paths.h"
#include "engine/frame/picture.h"
#include "engine/passes/read_back.h"

namespace nacre {

using graph::Clear;
using passes::Output;

namespace {

constexpr ScreenTarget kSrgb[] = {{"colour", VK_FORMAT_R8G8B8A8_SRGB, Output::color, "impostor colour"}};
constexpr ScreenTarget kCoded[] = {{"colour", VK_FORMAT_R8G8B8A8_UNORM, Output::color, "impostor colour"}};
constexpr ScreenTarget kLayers[] = {{"colour", VK_FORMAT_R32G32B32A32_SFLOAT, Output::color, "impostor colour"},
                                    {"surface", VK_FORMAT_R32G32B32A32_SFLOAT, Output::surface, "surface layer"},
                                    {"identity", VK_FORMAT_R32G32_UINT, Output::identity, "identity layer"}};

// Structured bindings name every member: a new one does not compile until it is compared.
auto tieMembers(const ScreenTarget& t) {
    const auto& [image, format, output, pass, clear, lent] = t;
    return std::tuple(std::string_view(image), format, output, std::string_view(pass), clear, lent);
}
auto tieMembers(const FrameShape& s) {
    const auto& [choice, extent, atlas, targets, name, picture, window, density, overlay, eye, rounds, merge,
                 transient] = s;
    return std::tuple(choice, extent, atlas, targets.size(), std::string_view(name), picture, window, density, overlay,
                      eye, rounds, merge, transient);
}

}  // namespace

graph::Clear opaqueClear(const std::array<float, 4>& background) {
    const float a = background[3];
    const auto channel = [&](std::size_t i) { return linearFromSrgb(background[i]) * a + 1.0f - a; };
    return {channel(0), channel(1), channel(2), 1.0f};
}

std::span<const ScreenTarget> screenTargets(const FrameChoice& choice) {
    const std::span<const ScreenTarget> layers(kLayers);
    switch (choice.part) {
        case Part::layers:
            return layers;
        case Part::solid:
            return layers.subspan(1);
        case Part::pick:
            return layers.subspan(2);
        case Part::distances:
            return kLensTargets;
        default:
            break;
    }
    switch (choice.color) {
        case ColorFormat::srgb:
            return kSrgb;
        case ColorFormat::coded:
            return kCoded;
        case ColorFormat::linear:
            break;
    }
    return layers.first(1);
}

bool settlesWhileShading(std::span<const ScreenTarget> targets) {
    constexpr std::uint32_t kNarrow = 8;  // bytes of colour
    return targets.size() == 1 && graph::bytesPerTexel(targets[0].format) <= kNarrow;
}

bool operator==(const FrameShape& a, const FrameShape& b) {
    return tieMembers(a) == tieMembers(b) && std::ranges::equal(a.targets, b.targets, [](const auto& x, const auto& y) {
               return tieMembers(x) == tieMembers(y);
           });
}

graph::Image& Frame::add(const ScreenTarget& target, const FrameShape& shape) {
    graph::ImageDesc desc{target.format, shape.extent};
    if (target.lent) desc.layers = shape.choice.views;
    targets.push_back(target.lent                ? graph.importImage(target.image, desc, *target.lent, true)
                      : shape.drawsIntoPicture() ? graph.importImage("picture", desc, passes::kTextureState, true)
                                                 : graph.image(target.image, desc));
    return targets.back();
}

graph::PassBuilder& Frame::draw(graph::PassBuilder& pass, const ScreenTarget& target, const FrameShape& shape,
                                const graph::Share& share) {
    const std::uint32_t count = shape.choice.attachmentSamples();
    const std::optional<Clear> clear = clearFirst(share, target.clear);
    if (share.index == 0) {
        add(target, shape);
        if (count > 1)
            samples = graph.image(std::string(target.image) + " samples", {target.format, shape.extent, count});
    }
    if (count == 1) return pass.color(targets.back(), clear);
    pass.color(*samples, clear);
    return share.index + 1 == share.count ? pass.resolve(targets.back()) : pass;
}

graph::PassBuilder Frame::graphics(const char* name, graph::SourceLine line) {
    graph::PassBuilder pass = graph.graphics(name, line);
    if (density) pass.density(*density);
    return pass;
}

graph::PassBuilder& Frame::lit(graph::PassBuilder& pass) const {
    pass.samples(atlas);
    return shadow ? pass.samples(*shadow) : pass;
}

void declarePath(Frame& frame, const FrameShape& shape) {
    constexpr std::array kPaths{declareEncoded,     declareEncoded,  declareFragdepth,
                                declareRasterOrder, declareDeferred, declareTiles};  // by Visibility
    kPaths[static_cast<std::size_t>(shape.choice.path)](frame, shape);
}

Frame declareFrame(const FrameShape& shape, std::shared_ptr<const ShownScene> shown) {
    const FrameChoice& choice = shape.choice;
    Frame frame;
    frame.graph = graph::Graph(shape.name, choice.views);
    frame.shown = std::move(shown);
    if (choice.ending == Ending::sumToWindow) return frame;
    frame.depth = frame.nearest =
        frame.graph.image("depth", {VK_FORMAT_D32_SFLOAT, shape.extent, choice.attachmentSamples()});
    if (choice.foveated) frame.density = frame.graph.importImage("fragment density", shape.density, kDensityState);
    frame.atlas = frame.graph.importImage("occlusion atlas", shape.atlas, passes::kTextureState);
    if (choice.debug != DebugView::none) {
        declareDebugView(frame, shape);
        return frame;
    }
    declareShadow(frame, choice);
    declareTranslucentLayers(frame, shape);
    declarePath(frame, shape);
    declareTranslucentRest(frame, shape);
    declareVolume(frame, choice, choice.layers());
    declareRestColor(frame, choice);
    for (std::uint32_t i = choice.layers(); i-- > 0;) {
        declareTranslucentColor(frame, i);
        declareVolume(frame, choice, i);
    }
    return frame;
}

graph::Graph paperFrame(graph::Extent extent) {
    graph::Graph g("paper");
    auto depth = g.image("depth", {VK_FORMAT_D16_UNORM, extent});
    auto texture = g.image("depth texture", {VK_FORMAT_R8G8B8A8_UNORM, extent});
    auto color = g.image("colour", {VK_FORMAT_R8G8B8A8_UNORM, extent});
    g.graphics("opaque prepass").depth(depth, Clear{1.0f});
    g.graphics("depth texture").depthTest(depth).color(texture, Clear{1.0f});
    g.graphics("picture").depthTest(depth).samples(texture).color(color, Clear{1.0f});
    g.output(color);
    return g;
}

}  // namespace nacre
