#include "engine/frame/recorder.h"

#include "engine/passes/debug_view.h"
#include "engine/passes/deferred_shading.h"
#include "engine/passes/depth_encoding.h"
#include "engine/passes/impostor_color.h"
#include "engine/passes/nearest_depth.h"
#include "engine/passes/nearest_primitive.h"
#include "engine/passes/opaque_prepass.h"
#include "engine/passes/overdraw.h"
#include "engine/passes/rims.h"
#include "engine/passes/tile_edges.h"
#include "engine/passes/tile_layers.h"
#include "engine/passes/tile_passes.h"
#include "engine/passes/translucent.h"

namespace nacre {

using graph::Image;
using passes::NearestFrom;
using passes::Output;
using passes::SceneView;
using Context = gpu::PassContext;

template <typename Pass>
graph::Record Recorder::of(Pass pass) const {
    if (!shown_) return {};
    return [shown = shown_, pass](Context& c) { pass(c, *shown->scene); };
}

/// Of one that has no pipelines made ahead.
template <typename Pass>
graph::Record Recorder::later(Pass pass) const {
    return of([pass](Context& c, const SceneView& scene) {
        if (!c.ahead) pass(c, scene);
    });
}

graph::Record Recorder::plates() const { return of(passes::drawPlates); }
graph::Record Recorder::shadowMap() const {
    return of([](Context& c, const SceneView& scene) { passes::drawNearestDepth(c, *scene.light); });
}
graph::Record Recorder::nearestPrimitive(bool distance) const {
    return of([=](Context& c, const SceneView& scene) { passes::drawNearestPrimitive(c, scene, distance); });
}
graph::Record Recorder::rims(Image atlas, Image numbers) const {
    return of([=](Context& c, const SceneView& scene) {
        const auto from = c.inputIsSampled ? NearestFrom::texture : NearestFrom::inputAttachment;
        passes::drawRims(c, scene, {from, c.view(atlas), c.view(numbers)});
    });
}
graph::Record Recorder::overdraw() const { return later(passes::drawOverdraw); }

graph::Record Recorder::encodedDepth(const graph::EncodedFormat& format) const {
    return of([encoding = passes::Encoding(format)](Context& c, const SceneView& scene) {
        passes::encodeDepth(c, scene, encoding);
    });
}

graph::Record Recorder::encodedDepthInOrder(Image atlas, Image nearest) const {
    return of([=](Context& c, const SceneView& scene) {
        passes::encodeDepthInOrder(c, scene, c.view(atlas), c.view(nearest));
    });
}

graph::Record Recorder::impostorsByDepthBuffer(Output output, Image atlas) const {
    return of([=](Context& c, const SceneView& scene) {
        passes::drawImpostorColor(c, scene, output, {NearestFrom::depthBuffer, c.view(atlas), {}}, {}, false);
    });
}

graph::Record Recorder::impostorsAtEncodedDepth(Output output, Image atlas, Image nearest,
                                                const graph::EncodedFormat& format) const {
    return of([=, encoding = passes::Encoding(format), settles = format.settles()](Context& c, const SceneView& scene) {
        const auto from = c.inputIsSampled ? NearestFrom::texture : NearestFrom::inputAttachment;
        passes::drawImpostorColor(c, scene, output, {from, c.view(atlas), c.view(nearest)}, encoding, settles);
    });
}

graph::Record Recorder::impostorsAtNearestDepth(Output output, Image atlas, Image nearest) const {
    return of([=](Context& c, const SceneView& scene) {
        passes::drawImpostorColor(c, scene, output, {NearestFrom::texture, c.view(atlas), c.view(nearest)}, {}, false);
    });
}

graph::Record Recorder::impostorsInOrder(Output output, Image atlas, Image nearest) const {
    return of([=](Context& c, const SceneView& scene) {
        passes::drawImpostorColor(c, scene, output, {NearestFrom::ownAttachment, c.view(atlas), c.view(nearest)}, {},
                                  false);
    });
}

graph::Record Recorder::shadedPrimitives(Output output, Image atlas, Image numbers) const {
    return of([=](Context& c, const SceneView& scene) {
        const auto from = c.inputIsSampled ? NearestFrom::texture : NearestFrom::inputAttachment;
        passes::shadeNearestPrimitive(c, scene, output, {from, c.view(atlas), c.view(numbers)});
    });
}

graph::Record Recorder::rimmedPrimitives(Image atlas, Image numbers, Image rims, const graph::Clear& clear) const {
    return of([=](Context& c, const SceneView& scene) {
        const auto from = c.inputIsSampled ? NearestFrom::texture : NearestFrom::inputAttachment;
        passes::shadeRimmedPrimitive(c, scene, {from, c.view(atlas), c.view(numbers)}, c.view(rims), clear);
    });
}

graph::Record Recorder::nearestByTiles() const {
    return of([](Context& c, const SceneView& scene) { passes::findNearestByTiles(c, scene, {}); });
}

graph::Record Recorder::shadedTiles(Output output, Image atlas, bool depth) const {
    return of([=](Context& c, const SceneView& scene) { passes::shadeTiles(c, scene, output, c.view(atlas), depth); });
}

graph::Record Recorder::translucentLayer(Image atlas, std::optional<Image> before) const {
    return later([=](Context& c, const SceneView& scene) {
        if (!before) return passes::drawTranslucentLayer(c, *scene.translucent, nullptr);
        const passes::Reads reads{NearestFrom::texture, c.view(atlas), c.view(*before)};
        passes::drawTranslucentLayer(c, *scene.translucent, &reads);
    });
}

graph::Record Recorder::translucentColor(Image atlas, Image numbers, std::optional<Image> nearest,
                                         const graph::EncodedFormat& format) const {
    return later([=, encoding = passes::Encoding(format)](Context& c, const SceneView& scene) {
        passes::Opaque opaque;
        if (nearest) {
            const auto from = c.inputIsSampled ? NearestFrom::texture : NearestFrom::inputAttachment;
            opaque = {from, c.view(*nearest), encoding};
        }
        passes::shadeTranslucentLayer(c, *scene.translucent, c.view(atlas), c.view(numbers), opaque);
    });
}

graph::Record Recorder::layersByTiles() const {
    return later([](Context& c, const SceneView& scene) { passes::findLayersByTiles(c, *scene.translucent); });
}

graph::Record Recorder::layerOfTiles(Image atlas, std::uint32_t layer) const {
    return later([=](Context& c, const SceneView& scene) {
        passes::shadeLayerByTiles(c, *scene.translucent, c.view(atlas), layer);
    });
}

graph::Record Recorder::colorsByTiles(Image atlas) const {
    return of([=](Context& c, const SceneView& scene) { passes::findNearestByTiles(c, scene, c.view(atlas)); });
}

graph::Record Recorder::edgePixels() const {
    return later([](Context& c, const SceneView& scene) { passes::findEdgesByTiles(c, scene); });
}

graph::Record Recorder::edgesByTiles(Image atlas) const {
    return later([=](Context& c, const SceneView& scene) { passes::drawEdgesByTiles(c, scene, c.view(atlas)); });
}

graph::Record Recorder::edgeColors(const graph::Clear& clear) const {
    return later([=](Context& c, const SceneView& scene) { passes::drawEdgeColors(c, scene, clear); });
}

graph::Record Recorder::tileMean(std::uint32_t tile, Image source) const {
    return later([=](Context& c, const SceneView& scene) { passes::drawTileMean(c, scene, tile, c.view(source)); });
}

graph::Record Recorder::debugView(DebugView what, std::uint32_t tile, Image source, std::optional<Image> under) const {
    return later([=](Context& c, const SceneView& scene) {
        passes::drawDebugView(c, scene, what, tile, c.view(source), under ? c.view(*under) : vk::ImageView());
    });
}

}  // namespace nacre
