#pragma once
// Work of a frame's passes: functions that describe what a pass draws of the shown scene.

#include <optional>
#include <utility>

#include "engine/frame/frame.h"
#include "engine/gpu/execute.h"
#include "engine/passes/covers.h"
#include "engine/passes/primitives.h"

namespace nacre {

// Pipelines depend only on the kind of input; recording alone needs images.
inline vk::ImageView viewIn(const gpu::PassContext& c, graph::Image image) { return c.view(image); }
inline vk::ImageView viewIn(const gpu::PipelineContext&, graph::Image) { return {}; }

/// Inputs of a pass that shades. @param nearest  depth or numbers, from `from`
template <typename Context>
passes::Reads makeReads(const Context& c, passes::NearestFrom from, graph::Image atlas,
                        std::optional<graph::Image> nearest = {}) {
    return {from, viewIn(c, atlas), nearest ? viewIn(c, *nearest) : vk::ImageView()};
}

/// Where the result of an earlier pass lies: on the tile, or in memory.
inline passes::NearestFrom fromEarlierPass(const gpu::PipelineContext& c) {
    return c.inputIsSampled ? passes::NearestFrom::texture : passes::NearestFrom::inputAttachment;
}

/// Work that draws the scene, and requests its pipelines ahead.
/// @param describe  (context, scene): returns the argument of draw() and want()
template <typename Describe>
graph::Work draws(const Frame& frame, Describe describe) {
    if (!frame.shown) return {};
    return {
        [shown = frame.shown, describe](gpu::PassContext& c) { draw(c, *shown->scene, describe(c, *shown->scene)); },
        [shown = frame.shown, describe](gpu::PipelineContext& c) {
            want(c, *shown->scene, describe(c, *shown->scene));
        }};
}

/// As above for the first pass that uses the depth buffer: it first covers masked pixels.
template <typename Describe>
graph::Work drawsFirst(const Frame& frame, Describe describe) {
    graph::Work work = draws(frame, describe);
    if (!frame.shown) return work;
    work.record = [shown = frame.shown, record = std::move(work.record)](gpu::PassContext& c) {
        if (c.share.index == 0) passes::drawCovers(c, *shown->scene);
        record(c);
    };
    return work;
}

/// Work whose pipelines are not requested ahead. @param pass  (context, scene): records it
template <typename Pass>
graph::Work records(const Frame& frame, Pass pass) {
    if (!frame.shown) return {};
    return {[shown = frame.shown, pass](gpu::PassContext& c) { pass(c, *shown->scene); }, {}};
}

}  // namespace nacre
