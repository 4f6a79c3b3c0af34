#include "engine/frame/scene_frames.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/error.h"
#include "engine/frame/debug_frame.h"
#include "engine/graph/visibility.h"
#include "engine/passes/covers.h"
#include "engine/passes/plates.h"
#include "engine/passes/read_back.h"
#include "engine/passes/translucent.h"

namespace nacre {
namespace {

bool isPicture(const FrameRequest& request) {
    return request.targets.size() == 1 && request.targets[0].output == passes::Output::color;
}

/// Whether shaders code its colour as sRGB themselves.
bool isCoded(const FrameRequest& request) {
    return isPicture(request) && request.targets[0].format == VK_FORMAT_R8G8B8A8_UNORM;
}

}  // namespace

SceneFrames::SceneFrames(const gpu::Device& device, gpu::Executor& executor, const std::shared_ptr<const Scene>& scene)
    : device_(device),
      scene_(scene),
      white_(passes::makeWhiteTexture(device, executor)),
      tiles_(device),
      layerTiles_(device),
      effectBuffers_(device, vk::BufferUsageFlagBits::eUniformBuffer, "effects"),
      copyRows_(device, vk::BufferUsageFlagBits::eStorageBuffer, "copies"),
      covers_(device, vk::BufferUsageFlagBits::eVertexBuffer, "covers") {}

std::shared_ptr<const gpu::Buffer> SceneFrames::effectsOf(const RenderSettings& settings, bool subsamples) {
    layout::EffectConstants wanted = effectConstants(settings, *shown_);
    wanted.subsamples = subsamples ? 1 : 0;
    if (effects_ && std::memcmp(&wanted, &lastEffects_, sizeof wanted) == 0) return effects_;
    lastEffects_ = wanted;
    return effects_ = effectBuffers_.upload(std::as_bytes(std::span(&wanted, 1)));
}

/// @throws Error if layers cannot be blended into this format
void SceneFrames::checkBlending(VkFormat format) const {
    if (format != VK_FORMAT_R32G32B32A32_SFLOAT || device_.caps().blendsFloats) return;
    throw Error("cannot draw translucent surfaces", device_.caps().deviceName,
                "it does not blend 32 bits per channel, which layers and 16-bit pictures need; use 8 bits");
}

bool SceneFrames::isFineMesh(const View& view) const {
    constexpr std::uint32_t kLargest = 384;  // a side: one block of samples
    constexpr std::uint64_t kPixels = 8;     // per triangle
    return std::max(view.width, view.height) <= kLargest &&
           scene_->representation.triangles.size() * kPixels > std::uint64_t{view.width} * view.height;
}

std::string SceneFrames::lacksSamples(const RenderSettings& settings) const {
    if (settings.debug != DebugView::none) return "debug views show single samples";
    if (settings.fine) return "16 bits per channel and sample do not fit the tile";
    return nacre::lacksSamples(settings.effects, translucent());
}

bool SceneFrames::hides(const passes::SceneView& seen, const RenderSettings& settings, Visibility path) const {
    // Where depth is tested late, a processor takes longer to shade what is hidden than to find it.
    const bool late = device_.caps().software && !graph::platesReject(path, device_.caps().plan);
    const bool many = path == Visibility::tiles && seen.copies.sphereCount() >= settings.tuning.hideFrom;
    return settings.tuning.cull && (late || many);
}

const SphereBoxes* SceneFrames::boxesOf(const passes::SceneView& seen, const RenderSettings& settings, const View& view,
                                        bool edges) const {
    // Smaller than that, lists and tiles take longer over them.
    constexpr double kSmallPixels = 2.5;
    constexpr std::uint64_t kMany = 100'000;
    const SphereBoxes& boxes = shown_->chunks.sphereBoxes;
    const bool pays = settings.tuning.cull && seen.radiusPixels <= kSmallPixels && seen.copies.sphereCount() >= kMany;
    const bool drawn = (pays || hides(seen, settings, Visibility::tiles)) && seen.copies.triangles.empty() &&
                       std::isfinite(boxes.reach) &&
                       FrontSpheres::tells(passes::tileView(seen, view, imageExtent(view), !edges));
    return drawn ? &boxes : nullptr;
}

bool SceneFrames::drawsShapes(const passes::SceneView& seen, const View& view) const {
    constexpr std::uint64_t kMost = 1'000'000;  // memory of 200 bytes each
    const Representation& r = shown_->representation;
    return !r.cylinders.empty() && r.wires.empty() && seen.copies.triangles.empty() && !seen.rims.any() &&
           seen.copies.sphereCount() + seen.copies.cylinderCount() <= kMost &&
           seen.copies.rows.size() / 3 * seen.constants.primitives < FrontShape::kMostNumbers &&
           FrontShapes::tells(passes::tileView(seen, view, imageExtent(view), true));
}

void SceneFrames::dropHidden(passes::SceneView& seen, const View& view, bool edges) {
    hidden_.drop(seen.copies, shown_->representation, shown_->chunks,
                 passes::tileView(seen, view, imageExtent(view), !edges), seen.radiusPixels);
}

/// Whether compute shades by tiles what is asked for, if it is no debug view.
bool SceneFrames::shadesByTiles(const FrameRequest& request) const {
    return pathOf(request.finer) == Visibility::tiles && device_.caps().tiles.shade && isCoded(request) &&
           !request.fragments;
}

/// Leaves out of the settings what such a frame does not draw. @returns the path that it takes
Visibility SceneFrames::settle(RenderSettings& settings, const FrameRequest& request) const {
    // Layers and picks take several targets or another one.
    const bool picture = isPicture(request);
    if (!picture) settings.debug = DebugView::none;
    const bool debug = settings.debug != DebugView::none;
    // Passes that report a pixel's atom ignore outlines.
    if (!picture || debug) settings.effects.contours.width = settings.effects.halos.width = 0;
    const bool color = std::any_of(request.targets.begin(), request.targets.end(),
                                   [](const ScreenTarget& t) { return t.output == passes::Output::color; });
    if (debug || !color) settings.effects.shadow = {};
    const Visibility usual = pathOf(request.finer);
    if (settings.effects.rims()) return shadesByTiles(request) ? Visibility::tiles : Visibility::deferred;
    return debug ? debugVisibility(settings.debug, usual) : usual;
}

/// The tiles' lists, where the path takes them and they are short enough.
void SceneFrames::addLists(SeenFrame& seen, const RenderSettings& settings, const FrameRequest& request) {
    ScreenOptions& options = seen.shape.options;
    passes::SceneView& view = *seen.view;
    const bool debug = seen.shape.debug != DebugView::none;
    if (options.visibility != Visibility::tiles) {
        if (!debug && hides(view, settings, options.visibility)) dropHidden(view, request.view, request.samples > 1);
        return;
    }
    const bool edges = request.edges && drawsEdges(request.finer) && !debug;
    const SphereBoxes* boxes = debug ? nullptr : boxesOf(view, settings, request.view, edges);
    if (!debug && !boxes && hides(view, settings, Visibility::tiles)) dropHidden(view, request.view, edges);
    const bool shaded = !debug && shadesByTiles(request);
    // The device finds edges by whole bins.
    const TileMask* mask = edges && !(shaded && request.places) ? nullptr : request.mask;
    const bool drawn = shaded && !edges && !boxes && !request.mask && drawsShapes(view, request.view);
    view.tiles = tiles_.prepare(shown_->representation, view, request.view, options.extent,
                                {shaded, edges, view.rims.any() && request.subsamples, 1, mask, boxes, drawn,
                                 shown_->chunks.triangles, request.places});
    if (!view.tiles) {
        const Visibility usual = device_.caps().visibility;
        options.visibility = view.rims.any()              ? Visibility::deferred
                             : usual == Visibility::tiles ? Visibility::fragdepth
                                                          : usual;
        if (hides(view, settings, options.visibility)) dropHidden(view, request.view, edges);
        return;
    }
    if (view.translucent)
        view.translucent->tiles =
            layerTiles_.prepare(shown_->representation, *view.translucent, request.view, options.extent,
                                {false, false, false, kTranslucentLayers, request.mask, nullptr});
    options.shadedByTiles = view.tiles->shaded;
    options.edges = view.tiles->edges.drawn;
    options.edgesPlaced = options.edges && view.tiles->edges.placed;
    options.edgesAlone = options.edgesPlaced && view.tiles->edges.alone;
    options.layersByTiles = view.translucent && view.translucent->tiles;
}

/// Covers what a mask leaves out, for passes that test depth.
void SceneFrames::addCovers(SeenFrame& seen, const TileMask& mask) {
    const std::vector<glm::vec4> covers = passes::coversOf(mask, seen.shape.options.extent);
    if (covers.empty()) return;
    seen.view->covers = covers_.upload(std::as_bytes(std::span(covers)));
    seen.view->coverCount = static_cast<std::uint32_t>(covers.size());
    if (!seen.view->translucent) return;
    seen.view->translucent->covers = seen.view->covers;
    seen.view->translucent->coverCount = seen.view->coverCount;
}

/// Submitted primitives; mesh levels are counted before culling.
void SceneFrames::count(SeenFrame& seen) {
    const passes::SceneView& view = *seen.view;
    SceneCounts& counts = seen.counts;
    const std::uint64_t spheres = view.copies.sphereCount();
    counts.spheres = view.tiles ? view.tiles->lists.shownSpheres().value_or(spheres) : spheres;
    counts.cylinders = view.copies.cylinderCount();
    counts.triangles = view.copies.triangleCount();
    counts.radiusPixels = view.radiusPixels;
    counts.flat = view.flat();
    counts.translucent = view.translucent ? view.translucent->copies.triangleCount() : 0;
    if (view.tiles) counts.lists = passes::countsOf(view.tiles->lists);
}

void SceneFrames::letGo() {
    shown_ = nullptr;
    for (int held = 0; held < 2; ++held)  // a view holds the light's view, and the translucent one
        views_.eachFree([](passes::SceneView& view) { view.clear(); });
}

SeenFrame SceneFrames::see(const FrameRequest& request) {
    letGo();
    RenderSettings settings = request.settings.ofFrame();
    shown_ = scene_;
    const bool levels = SeenScenes::draws(scene_->representation, settings);
    if (levels) settings.occlusion.directions = 0;
    const passes::Atlas used = settings.occlusion.directions > 0 ? request.atlas : passes::Atlas{};
    const Visibility path = settle(settings, request);
    SeenFrame seen;
    seen.atlas = used.image ? used.image : &white_;
    if (levels) {
        const bool several = (request.edges && drawsEdges(request.finer)) || request.samples > 1;
        shown_ = seenScenes_.see(device_, scene_, settings, request.view, several && settings.debug == DebugView::none);
        seen.counts.copyLevels = seenScenes_.counts();
    }
    seen.shape.debug = settings.debug;
    seen.shape.end = request.end;
    seen.shape.merge = settings.tuning.merge;
    seen.shape.transient = settings.tuning.transient;
    seen.view = viewScene(*shown_, settings, request.view, used, views_);
    passes::SceneView& view = *seen.view;
    const graph::GeometryCaps& geometry = device_.caps().plan.geometry;
    view.owner = shown_;
    view.coded = isCoded(request);
    view.powers = !device_.caps().software;
    view.fragments = request.fragments;
    if (request.radiusBefore)
        view.radiusPixels = passes::steadyRadius(*request.radiusBefore, view.radiusPixels, geometry);
    view.effectConstants = effectsOf(settings, settings.effects.rims() && request.subsamples);
    const bool layered = isPicture(request) && settings.debug == DebugView::none && translucent();
    if (layered) checkBlending(request.targets[0].format);
    const bool rims = settings.effects.rims();
    if (path == Visibility::deferred || layered || rims)
        view.copyRows = copyRows_.upload(std::as_bytes(std::span(std::as_const(view.copies.rows))));
    seen.counts.meshLevels = view.copies.triangleLevels(shown_->representation);
    if (layered) {
        const auto over = nextView(views_);
        passes::seeTranslucent(*over, view, scene_->translucent);
        view.translucent = over;
    }
    passes::choose(view.copies.triangles, scene_->translucent,
                   layered ? passes::Triangles::opaque : passes::Triangles::solid);
    ScreenOptions& options = seen.shape.options;
    options = {
        imageExtent(request.view), path, device_.caps().encoded, seen.atlas->desc, request.targets, true, request.name};
    addLists(seen, settings, request);
    if (request.mask && (options.visibility != Visibility::tiles || (layered && !options.layersByTiles)))
        addCovers(seen, *request.mask);
    // Without plates the passes that write depth themselves need no pass before them.
    const bool plates = view.plates != PlateShape::none ||
                        (options.visibility != Visibility::fragdepth && options.visibility != Visibility::deferred);
    options.prepass = plates && graph::platesReject(options.visibility, device_.caps().plan);
    options.shadowPixels = shadowPixels(settings);
    options.rims = rims;
    options.samples = isPicture(request) && lacksSamples(settings).empty() ? request.samples : 1;
    view.samples = options.samples;
    options.translucentLayers = layered ? kTranslucentLayers : 0;
    count(seen);
    return seen;
}

void SceneFrames::bind(DeclaredFrame& declared, const SeenFrame& seen) {
    const ScreenFrame& frame = declared.frame;
    passes::SceneView& view = *seen.view;
    declared.shown->scene = &view;
    view.shadow = frame.shadow;
    if (view.translucent) view.translucent->shadow = frame.shadow;
    gpu::Imports& imports = declared.imports;
    imports.clear();
    imports.bind(frame.atlas, *seen.atlas);
    if (view.tiles) imports.bind(frame.numbers, view.tiles->numbers.buffer);
    if (frame.layerNumbers) imports.bind(*frame.layerNumbers, view.translucent->tiles->numbers.buffer);
    if (frame.edges) {
        imports.bind(*frame.edges, view.tiles->edgeBuffer().buffer);
        imports.bind(frame.edgePixels, view.tiles->edges.pixels.buffer);
    }
}

}  // namespace nacre
