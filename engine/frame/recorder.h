#pragma once
// Records the passes of a frame: the scene as one view sees it, drawn by engine/passes.

#include <cstdint>
#include <memory>
#include <optional>

#include "engine/debug_view.h"
#include "engine/graph/encoded_format.h"
#include "engine/graph/graph.h"
#include "engine/passes/output.h"

namespace nacre::passes {
struct SceneView;
}

namespace nacre {

/// The scene that a frame's passes currently record: a frame is declared once and shows many scenes.
struct ShownScene {
    const passes::SceneView* scene = nullptr;
};

/// Gives each pass the functions that record it and request its pipelines. Without a scene the functions are empty, for
/// frames that are only planned.
class Recorder {
public:
    Recorder() = default;
    explicit Recorder(std::shared_ptr<const ShownScene> shown) : shown_(std::move(shown)) {}

    graph::Work plates() const;
    graph::Work shadowMap() const;
    graph::Work encodedDepth(const graph::EncodedFormat& format) const;
    graph::Work encodedDepthInOrder(graph::Image atlas, graph::Image nearest) const;
    /// @param distance  also write it @param clears  it is the first to use the depth buffer
    graph::Work nearestPrimitive(bool distance, bool clears) const;
    graph::Work rims(graph::Image atlas, graph::Image numbers) const;

    /// @param nearest  depth itself; none: read it from the depth buffer
    graph::Work impostors(passes::Output output, passes::NearestFrom from, graph::Image atlas,
                          std::optional<graph::Image> nearest = {}, bool clears = false) const;
    /// With depth encoded as `format`, read as an input attachment or, off tile, a texture.
    graph::Work impostorsAtEncodedDepth(passes::Output output, graph::Image atlas, graph::Image nearest,
                                        const graph::EncodedFormat& format) const;
    graph::Work shadedPrimitives(passes::Output output, graph::Image atlas, graph::Image numbers) const;
    graph::Work rimmedPrimitives(graph::Image atlas, graph::Image numbers, graph::Image rims,
                                 const graph::Clear& clear) const;

    /// @param before  depth of the previous layer; none: the first layer
    graph::Work translucentLayer(graph::Image atlas, std::optional<graph::Image> before) const;
    /// @param nearest  opaque depth, encoded as `format`; none: read it from the depth buffer
    graph::Work translucentColor(graph::Image atlas, graph::Image numbers, std::optional<graph::Image> nearest,
                                 const graph::EncodedFormat& format) const;

    graph::Work layersByTiles() const;
    /// @param layer  0: nearest
    graph::Work layerOfTiles(graph::Image atlas, std::uint32_t layer) const;

    graph::Work nearestByTiles() const;
    /// @param depth  also write the depth buffer
    graph::Work shadedTiles(passes::Output output, graph::Image atlas, bool depth = false) const;
    /// Finds the nearest primitives and shades them in one pass.
    graph::Work colorsByTiles(graph::Image atlas) const;
    graph::Work edgePixels() const;
    graph::Work edgesByTiles(graph::Image atlas) const;
    graph::Work edgeColors(const graph::Clear& clear) const;

    graph::Work overdraw() const;
    graph::Work tileMean(std::uint32_t tile, graph::Image source) const;
    graph::Work debugView(DebugView what, std::uint32_t tile, graph::Image source,
                          std::optional<graph::Image> under) const;

private:
    template <typename Describe>
    graph::Work of(Describe describe) const;
    template <typename Pass>
    graph::Work later(Pass pass) const;
    template <typename Describe>
    graph::Work first(Describe describe, bool clears = true) const;

    std::shared_ptr<const ShownScene> shown_;
};

}  // namespace nacre
