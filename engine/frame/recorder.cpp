#include "engine/frame/recorder.h"

#include "engine/passes/covers.h"
#include "engine/passes/debug_view.h"
#include "engine/passes/deferred_shading.h"
#include "engine/passes/geometry_passes.h"
#include "engine/software/tile_edges.h"
#include "engine/software/tile_passes.h"

namespace nacre {

using graph::Image;
using passes::NearestFrom;
using passes::Output;
using passes::Reads;
using passes::SceneView;
using Context = gpu::PassContext;

namespace {

// Pipelines depend only on the kind of what is read; images are needed for recording alone.
vk::ImageView viewOf(const Context& c, Image image) { return c.view(image); }
vk::ImageView viewOf(const gpu::PipelineContext&, Image) { return {}; }

template <typename Any>
Reads readsOf(const Any& c, NearestFrom from, Image atlas, std::optional<Image> nearest = {}) {
    return {from, viewOf(c, atlas), nearest ? viewOf(c, *nearest) : vk::ImageView()};
}

/// Result of an earlier pass: on the tile, or in memory.
NearestFrom left(const gpu::PipelineContext& c) {
    return c.inputIsSampled ? NearestFrom::texture : NearestFrom::inputAttachment;
}

}  // namespace

/// @param describe  returns the pass that a scene is drawn by, which passes::draw() and passes::want() know
template <typename Describe>
graph::Work Recorder::of(Describe describe) const {
    if (!shown_) return {};
    return {[shown = shown_, describe](Context& c) { passes::draw(c, *shown->scene, describe(c, *shown->scene)); },
            [shown = shown_, describe](gpu::PipelineContext& c) {
                passes::want(c, *shown->scene, describe(c, *shown->scene));
            }};
}

/// A pass whose pipelines are not made ahead.
template <typename Pass>
graph::Work Recorder::later(Pass pass) const {
    if (!shown_) return {};
    return {[shown = shown_, pass](Context& c) { pass(c, *shown->scene); }, {}};
}

/// As of() for a pass that may be the first to use the depth buffer.
template <typename Describe>
graph::Work Recorder::first(Describe describe, bool clears) const {
    graph::Work work = of(describe);
    if (!shown_ || !clears) return work;
    work.record = [shown = shown_, record = std::move(work.record)](Context& c) {
        passes::drawCovers(c, *shown->scene);
        record(c);
    };
    return work;
}

graph::Work Recorder::plates() const {
    return first(
        [](const auto&, const SceneView& scene) { return passes::opaquePrepass(scene.plates != PlateShape::none); });
}

graph::Work Recorder::shadowMap() const {
    if (!shown_) return {};
    return {
        [shown = shown_](Context& c) { passes::draw(c, *shown->scene->light, passes::nearestDepth()); },
        [shown = shown_](gpu::PipelineContext& c) { passes::want(c, *shown->scene->light, passes::nearestDepth()); }};
}

graph::Work Recorder::nearestPrimitive(bool distance, bool clears) const {
    return first([=](const auto&, const SceneView&) { return passes::nearestPrimitive(distance); }, clears);
}

graph::Work Recorder::rims(Image atlas, Image numbers) const {
    return of([=](const auto& c, const SceneView& scene) {
        return passes::rims(scene, readsOf(c, left(c), atlas, numbers));
    });
}

graph::Work Recorder::overdraw() const {
    return later([](Context& c, const SceneView& scene) { passes::draw(c, scene, passes::overdraw()); });
}

graph::Work Recorder::encodedDepth(const graph::EncodedFormat& format) const {
    return of([encoding = passes::Encoding(format)](const auto&, const SceneView&) {
        return passes::depthEncoding(encoding);
    });
}

graph::Work Recorder::encodedDepthInOrder(Image atlas, Image nearest) const {
    return of([=](const auto& c, const SceneView&) {
        return passes::orderedDepth(readsOf(c, NearestFrom::ownAttachment, atlas, nearest));
    });
}

graph::Work Recorder::impostors(Output output, NearestFrom from, Image atlas, std::optional<Image> nearest,
                                bool clears) const {
    return first(
        [=](const auto& c, const SceneView& scene) {
            if (scene.samples > 1) return passes::multisampledColor(readsOf(c, from, atlas, nearest));
            return passes::impostorColor(output, readsOf(c, from, atlas, nearest));
        },
        clears);
}

graph::Work Recorder::impostorsAtEncodedDepth(Output output, Image atlas, Image nearest,
                                              const graph::EncodedFormat& format) const {
    return of([=, encoding = passes::Encoding(format), settles = format.settles()](const auto& c, const SceneView&) {
        return passes::impostorColor(output, readsOf(c, left(c), atlas, nearest), encoding, settles);
    });
}

graph::Work Recorder::shadedPrimitives(Output output, Image atlas, Image numbers) const {
    return of([=](const auto& c, const SceneView&) {
        return passes::DeferredPass{output, readsOf(c, left(c), atlas, numbers)};
    });
}

graph::Work Recorder::rimmedPrimitives(Image atlas, Image numbers, Image rims, const graph::Clear& clear) const {
    return of([=](const auto& c, const SceneView&) {
        return passes::DeferredPass{Output::color, readsOf(c, left(c), atlas, numbers),
                                    passes::DeferredRims{viewOf(c, rims), clear}};
    });
}

graph::Work Recorder::nearestByTiles() const {
    return of([](const auto&, const SceneView&) { return passes::NearestByTiles(); });
}

graph::Work Recorder::colorsByTiles(Image atlas) const {
    return of([=](const auto& c, const SceneView&) { return passes::NearestByTiles{viewOf(c, atlas)}; });
}

graph::Work Recorder::shadedTiles(Output output, Image atlas, bool depth) const {
    return of([=](const auto& c, const SceneView&) { return passes::TileShading{viewOf(c, atlas), output, depth}; });
}

graph::Work Recorder::translucentLayer(Image atlas, std::optional<Image> before) const {
    return later([=](Context& c, const SceneView& scene) {
        std::optional<Reads> reads;
        if (before) reads = readsOf(c, NearestFrom::texture, atlas, before);
        passes::drawCovers(c, *scene.translucent);
        passes::draw(c, *scene.translucent, passes::translucentLayer(reads));
    });
}

graph::Work Recorder::translucentColor(Image atlas, Image numbers, std::optional<Image> nearest,
                                       const graph::EncodedFormat& format) const {
    return later([=, encoding = passes::Encoding(format)](Context& c, const SceneView& scene) {
        passes::DeferredPass pass{Output::color, readsOf(c, NearestFrom::texture, atlas, numbers)};
        pass.over = passes::LayerOver();
        if (nearest) pass.over = passes::LayerOver{left(c), c.view(*nearest), encoding};
        passes::draw(c, *scene.translucent, pass);
    });
}

graph::Work Recorder::layersByTiles() const {
    return later([](Context& c, const SceneView& scene) { passes::findLayersByTiles(c, *scene.translucent); });
}

graph::Work Recorder::layerOfTiles(Image atlas, std::uint32_t layer) const {
    return later([=](Context& c, const SceneView& scene) {
        passes::draw(c, *scene.translucent, passes::TileShading{c.view(atlas), Output::color, false, layer});
    });
}

graph::Work Recorder::edgePixels() const { return later(passes::findEdgesByTiles); }

graph::Work Recorder::edgesByTiles(Image atlas) const {
    return later([=](Context& c, const SceneView& scene) { passes::drawEdgesByTiles(c, scene, c.view(atlas)); });
}

graph::Work Recorder::edgeColors(const graph::Clear& clear) const {
    return later([=](Context& c, const SceneView& scene) { passes::drawEdgeColors(c, scene, clear); });
}

graph::Work Recorder::tileMean(std::uint32_t tile, Image source) const {
    return later([=](Context& c, const SceneView& scene) { passes::drawTileMean(c, scene, tile, c.view(source)); });
}

graph::Work Recorder::debugView(DebugView what, std::uint32_t tile, Image source, std::optional<Image> under) const {
    return later([=](Context& c, const SceneView& scene) {
        passes::drawDebugView(c, scene, what, tile, c.view(source), under ? c.view(*under) : vk::ImageView());
    });
}

}  // namespace nacre
