#include "engine/frame/scene_frames.h"

#include <cstring>

#include "engine/frame/effects/translucency/translucency.h"
#include "engine/frame/foveation.h"
#include "engine/passes/covers.h"
#include "engine/passes/plates.h"
#include "engine/passes/read_back.h"
#include "engine/passes/select_opacity.h"

namespace nacre {

SceneFrames::SceneFrames(const gpu::Device& device, gpu::Executor& executor, const std::shared_ptr<const Scene>& scene)
    : device_(device),
      scene_(scene),
      white_(passes::makeWhiteTexture(device, executor)),
      volumes_(device, executor),
      tiles_(passes::makeTileFrames(device, passes::makeHostLister())),
      layerTiles_(passes::makeTileFrames(device, passes::makeHostLister())),
      hidden_(passes::makeHiddenSpheres()),
      effectBuffers_(device, vk::BufferUsageFlagBits::eUniformBuffer, "effects"),
      copyRows_(device, vk::BufferUsageFlagBits::eStorageBuffer, "copies"),
      covers_(device, vk::BufferUsageFlagBits::eVertexBuffer, "covers") {}

SceneFacts SceneFrames::sceneFacts(const Scene& scene) {
    return collectFacts(scene.representation, scene.chunks, scene.translucent);
}

SceneFacts SceneFrames::facts(const RenderSettings& settings) const {
    SceneFacts facts = sceneFacts(*scene_);
    facts.leveled = LevelScenes::draws(scene_->representation, settings);
    return facts;
}

passes::PrimitiveCounts SceneFrames::countPrimitives(const passes::SceneView& view) {
    return {view.copies.sphereCount(),
            view.copies.cylinderCount(),
            view.copies.triangleCount(),
            view.radiusPixels,
            view.flat(),
            view.buffers->ellipsoidOffset > 0};
}

void SceneFrames::addViewFacts(SceneFacts& facts, const passes::SceneView& view) {
    static_cast<passes::PrimitiveCounts&>(facts) = countPrimitives(view);
    if (view.light) facts.light = countPrimitives(*view.light);
    if (view.translucent) facts.layers = countPrimitives(*view.translucent);
    facts.smallestPixels = view.smallestPixels;
}

std::shared_ptr<const gpu::Buffer> SceneFrames::uploadEffects(const RenderSettings& settings, bool subsamples) {
    layout::EffectConstants wanted = effectConstants(settings, *shown_);
    wanted.subsamples = subsamples ? 1 : 0;
    if (effects_ && std::memcmp(&wanted, &lastEffects_, sizeof wanted) == 0) return effects_;
    lastEffects_ = wanted;
    return effects_ = effectBuffers_.upload(std::as_bytes(std::span(&wanted, 1)));
}

void SceneFrames::dropHidden(passes::SceneView& view, const FrameChoice& choice, const FrameInputs& inputs) {
    const bool centers = !choice.drawsEdges() && choice.attachmentSamples() == 1;
    if (hidden_)
        hidden_->drop(view, shown_->representation, shown_->chunks, inputs.view, imageExtent(inputs.view), centers);
}

/// Whether a coarse frame may miss small primitives. Its lists then mark them, and keep those between pixel centres.
static bool marksSmall(const passes::SceneView& view, const FrameRequest& request) {
    return request.part == Part::coarse && view.smallestPixels < passes::TileWork::kSmallPixels;
}

std::shared_ptr<const passes::TileFrame> SceneFrames::listTiles(const passes::SceneView& view,
                                                                const FrameChoice& choice, const FrameRequest& request,
                                                                const FrameInputs& inputs) {
    passes::TileWork work;
    work.byDevice = choice.geometry == Geometry::deviceLists;
    work.result = choice.shadedByCompute() ? passes::TileResult::colors
                  : choice.shadedByImage() ? passes::TileResult::image
                                           : passes::TileResult::words;
    work.edges = choice.drawsEdges();
    work.edgesAlone = choice.edgePixels == EdgePixels::alone;
    work.longestList = choice.overflow.longestList;
    work.marksSmall = marksSmall(view, request);
    work.subsamples = view.rims.any() && request.part == Part::block;
    // The device finds edges in whole bins.
    if (!work.edges || choice.edgePixels != EdgePixels::found) work.mask = inputs.mask;
    work.frontSpheres = choice.host == HostWork::frontSpheres;
    work.triangleChunks = shown_->chunks.triangles;
    if (choice.edgePixels != EdgePixels::found) work.places = inputs.places;
    return tiles_->prepare({shown_->representation, view, inputs.view, imageExtent(inputs.view)}, work);
}

/// The tiles' lists, if the path uses them. Replaces the choice if they are too long.
void SceneFrames::addLists(PreparedFrame& prepared, const FrameRequest& request, const FrameInputs& inputs) {
    FrameChoice& choice = prepared.shape.choice;
    passes::SceneView& view = *prepared.view;
    if (choice.host == HostWork::hiddenSpheres) dropHidden(view, choice, inputs);
    if (!choice.drawnByTiles()) return;
    const std::shared_ptr<const passes::TileFrame> tiles = listTiles(view, choice, request, inputs);
    choice = choice.within(tiles->longestList());
    if (!choice.drawnByTiles()) {
        if (choice.host == HostWork::hiddenSpheres) dropHidden(view, choice, inputs);
        return;
    }
    view.tiles = tiles;
    prepared.shape.listRounds = tiles->rounds();
    if (!choice.has(Effect::Kind::tileTranslucency)) return;
    passes::TileWork work;
    work.result = passes::TileResult::layers;
    work.marksSmall = marksSmall(view, request);
    work.mask = inputs.mask;
    work.longestList = choice.overflow.longestListOfLayers;
    const std::shared_ptr<const passes::TileFrame> layers =
        layerTiles_->prepare({shown_->representation, *view.translucent, inputs.view, imageExtent(inputs.view)}, work);
    choice = choice.within(tiles->longestList(), layers->longestList());
    if (choice.has(Effect::Kind::tileTranslucency)) view.translucent->tiles = layers;
}

/// Covers masked pixels, for passes that test depth.
void SceneFrames::addCovers(PreparedFrame& prepared, const TileMask& mask) {
    const std::vector<glm::vec4> covers = passes::makeCovers(mask, prepared.shape.extent);
    if (covers.empty()) return;
    passes::SceneView& view = *prepared.view;
    view.covers = covers_.upload(std::as_bytes(std::span(covers)));
    view.coverCount = static_cast<std::uint32_t>(covers.size());
    if (!view.translucent) return;
    view.translucent->covers = view.covers;
    view.translucent->coverCount = view.coverCount;
}

/// Submitted primitives; mesh levels are counted before culling.
void SceneFrames::count(PreparedFrame& prepared) {
    const passes::SceneView& view = *prepared.view;
    SceneCounts& counts = prepared.counts;
    static_cast<passes::PrimitiveCounts&>(counts) = countPrimitives(view);
    if (view.light) counts.light = countPrimitives(*view.light);
    if (view.translucent) counts.layers = countPrimitives(*view.translucent);
    if (view.tiles) counts.lists = view.tiles->counts();
}

void SceneFrames::releaseScene() {
    cappedScenes_.clear();
    releaseViews();
}

void SceneFrames::releaseViews() {
    shown_ = nullptr;
    for (int held = 0; held < 2; ++held)  // a view holds the light's and the translucent view
        views_.eachFree([](passes::SceneView& view) { view.clear(); });
}

PreparedFrame SceneFrames::prepare(const FrameRequest& request, const FrameInputs& inputs) {
    releaseViews();
    const gpu::Caps& caps = device_.caps();
    RenderSettings settings = drawnSettings(request);
    PreparedFrame prepared;
    using Pace = CappedScenes::Pace;
    shown_ = cappedScenes_.show(device_, scene_, settings.effects.clip, inputs.view,
                                request.part == Part::motion ? Pace::live : Pace::complete);
    SceneFacts& facts = prepared.facts;
    facts = sceneFacts(*shown_);
    if (LevelScenes::draws(scene_->representation, settings)) {
        settings.occlusion.directions = 0;
        const Samples::Where where = chooseSamples(request, facts, caps).where;
        const bool several = where == Samples::Where::edges || where == Samples::Where::resolved;
        shown_ = levelScenes_.show(device_, scene_, settings, inputs.view, several);
        prepared.counts.copyLevels = levelScenes_.counts();
        facts = sceneFacts(*shown_);
        facts.leveled = true;
    }
    const passes::Atlas used = settings.occlusion.directions > 0 ? inputs.atlas : passes::Atlas{};
    prepared.atlas = used.image ? used.image : &white_;
    prepared.view = viewScene(*shown_, settings, inputs.view, used, views_);
    passes::SceneView& view = *prepared.view;
    view.owner = shown_;
    view.powers = caps.fastPowers;
    view.fragments = inputs.fragments;
    if (inputs.radiusBefore)
        view.radiusPixels = passes::steadyRadius(*inputs.radiusBefore, view.radiusPixels, caps.plan.geometry);
    view.volume = volumes_.findTextures(scene_->representation.volume);
    view.effectConstants = uploadEffects(settings, settings.effects.rims() && request.part == Part::block);
    const bool layered = drawsLayers(request, facts);
    const auto uploadRows = [&] {
        std::vector<glm::vec4> ofBoth;  // the other view's rows behind the first's
        if (!view.copies.otherShifts.empty()) ofBoth = view.copies.rows;
        for (std::size_t i = 0; i < view.copies.otherShifts.size(); ++i)
            for (std::size_t row = 0; row < 3; ++row) {
                ofBoth.push_back(view.copies.rows[3 * i + row]);
                if (row == 0) ofBoth.back().w = view.copies.otherShifts[i];
            }
        const std::vector<glm::vec4>& rows = ofBoth.empty() ? view.copies.rows : ofBoth;
        view.copyRows = copyRows_.upload(std::as_bytes(std::span(rows)));
    };
    prepared.counts.meshLevels = view.copies.triangleLevels(shown_->representation);
    if (layered) {
        uploadRows();
        const auto over = nextView(views_);
        viewTranslucent(*over, view, shown_->translucent);
        view.translucent = over;
    }
    passes::select(view.copies, shown_->translucent, layered ? passes::Opacity::opaque : passes::Opacity::solid);
    addViewFacts(facts, view);

    FrameShape& shape = prepared.shape;
    shape.choice = choose(request, facts, caps);
    shape.extent = imageExtent(inputs.view);
    shape.atlas = prepared.atlas->desc;
    shape.name = inputs.name;
    if (shape.choice.foveated) shape.density = densityMapFor(shape.extent, shape.choice.views, caps.plan.densityTexel);
    shape.merge = settings.tuning.merge;
    shape.transient = settings.tuning.transient;
    if (!shape.choice.givesWay()) addLists(prepared, request, inputs);
    const FrameChoice& choice = shape.choice;
    if (choice.givesWay()) return prepared;
    shape.targets = inputs.window.empty() ? screenTargets(choice) : inputs.window;
    view.coded = choice.color == ColorFormat::coded;
    view.samples = choice.attachmentSamples();
    if (choice.vertices.plates != PlateShape::automatic) view.plates = choice.vertices.plates;
    if (choice.vertices.impostor != ImpostorShape::automatic) view.impostor = choice.vertices.impostor;
    if (choice.readsCopyRows() && !view.copyRows) uploadRows();
    if (inputs.mask && (!choice.drawnByTiles() || choice.has(Effect::Kind::translucency)))
        addCovers(prepared, *inputs.mask);
    count(prepared);
    return prepared;
}

void SceneFrames::bind(DeclaredFrame& declared, const PreparedFrame& prepared) {
    const Frame& frame = declared.frame;
    passes::SceneView& view = *prepared.view;
    declared.shown->scene = &view;
    view.shadow = frame.shadow;
    if (view.translucent) view.translucent->shadow = frame.shadow;
    gpu::Imports& imports = declared.imports;
    imports.clear();
    imports.bind(frame.atlas, *prepared.atlas);
    if (view.tiles && !prepared.choice().shadedByImage()) imports.bind(frame.numbers, view.tiles->pixels());
    if (frame.lists) {
        imports.bind(*frame.entries, view.tiles->entries());
        imports.bind(*frame.lists, view.tiles->sortedEntries());
    }
    if (frame.layerColors) imports.bind(*frame.layerColors, view.translucent->tiles->pixels());
    if (frame.edges) {
        imports.bind(*frame.edges, view.tiles->edges());
        imports.bind(frame.edgePixels, view.tiles->edgePixels());
    }
}

}  // namespace nacre
