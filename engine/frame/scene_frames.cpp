#include "engine/frame/scene_frames.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/error.h"
#include "engine/frame/debug_frame.h"
#include "engine/passes/plates.h"
#include "engine/passes/read_back.h"
#include "engine/passes/translucent.h"

namespace nacre {

SceneFrames::SceneFrames(const gpu::Device& device, gpu::Executor& executor, const std::shared_ptr<const Scene>& scene,
                         FrameStats& stats)
    : device_(device),
      scene_(scene),
      stats_(stats),
      white_(passes::makeWhiteTexture(device, executor)),
      tiles_(device),
      layerTiles_(device),
      effectBuffers_(device, vk::BufferUsageFlagBits::eUniformBuffer, "effects"),
      copyRows_(device, vk::BufferUsageFlagBits::eStorageBuffer, "copies") {}

std::shared_ptr<const gpu::Buffer> SceneFrames::effectsOf(const RenderSettings& settings) const {
    const layout::EffectConstants wanted = effectConstants(settings, *scene_);
    if (effects_ && std::memcmp(&wanted, &lastEffects_, sizeof wanted) == 0) return effects_;
    lastEffects_ = wanted;
    return effects_ = effectBuffers_.upload(std::as_bytes(std::span(&wanted, 1)));
}

/// @throws Error if no layer can be laid over a picture of this format
void SceneFrames::checkBlending(VkFormat format) const {
    if (format != VK_FORMAT_R32G32B32A32_SFLOAT || device_.caps().blendsFloats) return;
    throw Error(
        "cannot draw translucent surfaces", device_.caps().deviceName,
        "it does not blend 32 bits a channel, which layers and pictures of 16 bits are made of; ask for 8 bits");
}

bool SceneFrames::hides(const passes::SceneView& seen, const RenderSettings& settings) {
    return settings.tuning.cull && seen.copies.sphereCount() >= settings.tuning.hideFrom;
}

const SphereBoxes* SceneFrames::boxesOf(const passes::SceneView& seen, const RenderSettings& settings, const View& view,
                                        bool edges) const {
    // Smaller than that, lists and tiles take longer over them.
    constexpr double kSmallPixels = 2.5;
    constexpr std::uint64_t kMany = 100'000;
    const SphereBoxes& boxes = scene_->chunks.sphereBoxes;
    const bool pays = settings.tuning.cull && seen.radiusPixels <= kSmallPixels && seen.copies.sphereCount() >= kMany;
    const bool drawn = (pays || hides(seen, settings)) && seen.copies.triangles.empty() && std::isfinite(boxes.reach) &&
                       FrontSpheres::tells(passes::tileView(seen, view, imageExtent(view), !edges));
    return drawn ? &boxes : nullptr;
}

void SceneFrames::dropHidden(passes::SceneView& seen, const RenderSettings& settings, const View& view,
                             bool edges) const {
    if (!hides(seen, settings)) return;
    hidden_.drop(seen.copies, scene_->representation, scene_->chunks,
                 passes::tileView(seen, view, imageExtent(view), !edges), seen.radiusPixels);
}

ScreenFrame SceneFrames::declare(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
                                 std::span<const ScreenTarget> targets, const char* name, gpu::Imports& imports,
                                 std::shared_ptr<passes::FragmentCounter> fragments, bool edges) const {
    return declareSeen(settings, atlas, view, targets, name, imports, std::move(fragments), edges, nullptr);
}

ScreenFrame SceneFrames::declareNext(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
                                     std::span<const ScreenTarget> targets, const char* name,
                                     gpu::Imports& imports) const {
    return declareSeen(settings, atlas, view, targets, name, imports, nullptr, false, &windowRadius_);
}

ScreenFrame SceneFrames::declareSeen(const RenderSettings& asked, const passes::Atlas& baked, const View& view,
                                     std::span<const ScreenTarget> targets, const char* name, gpu::Imports& imports,
                                     std::shared_ptr<passes::FragmentCounter> fragments, bool edges,
                                     double* lastRadius) const {
    RenderSettings settings = asked;
    const passes::Atlas used = settings.occlusion.directions > 0 ? baked : passes::Atlas{};
    const gpu::Image& atlas = used.image ? *used.image : white_;
    // Layers and picks take several targets or another one.
    const bool picture = targets.size() == 1 && targets[0].output == passes::Output::color;
    const bool debug = settings.debug != DebugView::none && picture;
    // What tells of a pixel's atom tells nothing of lines about it.
    if (!picture || debug) settings.effects.contours.width = settings.effects.halos.width = 0;
    const bool color = std::any_of(targets.begin(), targets.end(),
                                   [](const ScreenTarget& t) { return t.output == passes::Output::color; });
    if (debug || !color) settings.effects.shadow = {};
    const Visibility usual = device_.caps().visibility;
    Visibility path = debug ? debugVisibility(settings.debug, usual) : usual;
    const bool rims = settings.effects.rims();
    if (rims) path = Visibility::deferred;
    const auto seen = viewScene(device_, *scene_, settings, view, used);
    seen->owner = scene_;
    seen->coded = picture && targets[0].format == VK_FORMAT_R8G8B8A8_UNORM;
    seen->powers = !device_.caps().software;
    seen->fragments = std::move(fragments);
    if (lastRadius)
        seen->radiusPixels = *lastRadius =
            passes::steadyRadius(*lastRadius, seen->radiusPixels, device_.caps().plan.geometry);
    seen->effectConstants = effectsOf(settings);
    const bool layered = picture && !debug && translucent();
    if (layered) checkBlending(targets[0].format);
    if (path == Visibility::deferred || layered)
        seen->copyRows = copyRows_.upload(std::as_bytes(std::span(std::as_const(seen->copies.rows))));
    const std::vector<MeshLevelCount> drawnLevels = seen->copies.triangleLevels(scene_->representation);
    if (layered) seen->translucent = passes::translucentView(*seen, scene_->translucent);
    seen->copies.triangles = passes::chosen(seen->copies.triangles, scene_->translucent,
                                            layered ? passes::Triangles::opaque : passes::Triangles::solid);
    const graph::Extent image = imageExtent(view);
    const bool drawnEdges = edges && drawsEdges() && !debug;
    if (path == Visibility::tiles) {
        const SphereBoxes* boxes = debug ? nullptr : boxesOf(*seen, settings, view, drawnEdges);
        if (!debug && !boxes) dropHidden(*seen, settings, view, drawnEdges);
        const bool shaded = seen->coded && !debug && !seen->fragments && device_.caps().tiles.shade;
        seen->tiles = tiles_.prepare(scene_->representation, *seen, view, image, {shaded, drawnEdges, 1, boxes});
        if (!seen->tiles) path = Visibility::fragdepth;
        if (!seen->tiles && boxes) dropHidden(*seen, settings, view, drawnEdges);
        if (seen->tiles && layered)
            seen->translucent->tiles = layerTiles_.prepare(scene_->representation, *seen->translucent, view, image,
                                                           {false, false, kTranslucentLayers, nullptr});
    }
    stats_.lists = seen->tiles ? passes::countsOf(seen->tiles->lists) : TileCounts();
    stats_.spheres = seen->copies.sphereCount();
    if (seen->tiles) stats_.spheres = seen->tiles->lists.shownSpheres().value_or(stats_.spheres);
    stats_.cylinders = seen->copies.cylinderCount();
    const std::uint64_t translucentCount = layered ? seen->translucent->copies.triangleCount() : 0;
    stats_.triangles = seen->copies.triangleCount() + translucentCount;
    stats_.meshLevels = drawnLevels;
    // Without plates the passes that write depth themselves need no pass before them.
    const bool plates =
        seen->plates != PlateShape::none || (path != Visibility::fragdepth && path != Visibility::deferred);
    const bool prepass = plates && graph::platesReject(path, device_.caps().plan);
    ScreenOptions options{image, path, device_.caps().encoded, atlas.desc, targets, prepass, name};
    options.shadedByTiles = seen->tiles && seen->tiles->shaded;
    options.edges = seen->tiles && seen->tiles->edges.drawn;
    options.shadowPixels = shadowPixels(settings);
    options.rims = rims;
    options.translucentLayers = layered ? kTranslucentLayers : 0;
    options.layersByTiles = layered && seen->translucent->tiles;
    ScreenFrame frame =
        debug ? debugFrame(settings.debug, options, Recorder(seen)) : screenFrame(options, Recorder(seen));
    seen->shadow = frame.shadow;
    if (layered) seen->translucent->shadow = frame.shadow;
    frame.counts = {stats_.spheres,     stats_.cylinders,  seen->copies.triangleCount(),
                    seen->radiusPixels, seen->perspective, translucentCount};
    imports.bind(frame.atlas, atlas);
    if (seen->tiles) imports.bind(frame.numbers, seen->tiles->numbers.buffer);
    if (options.shadedByTiles) frame.colors = seen->tiles;
    if (frame.layerNumbers) imports.bind(*frame.layerNumbers, seen->translucent->tiles->numbers.buffer);
    if (frame.edges) {
        imports.bind(*frame.edges, seen->tiles->edgeBuffer().buffer);
        imports.bind(frame.edgePixels, seen->tiles->edges.pixels.buffer);
    }
    return frame;
}

graph::PlanCaps SceneFrames::planCaps(const FrameTuning& tuning) const {
    graph::PlanCaps caps = device_.caps().plan;
    caps.merge = caps.merge && tuning.merge;
    caps.transient = caps.transient && tuning.transient;
    caps.storeAll = caps.storeAll || !tuning.transient;
    return caps;
}

}  // namespace nacre
