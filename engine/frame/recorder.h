#pragma once
// What the passes of a frame record: the scene as one view sees it, drawn by engine/passes.

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

/// The scene that the passes of a frame record at the moment: a frame is declared once, and shows one after another.
struct ShownScene {
    const passes::SceneView* scene = nullptr;
};

/// Gives each pass the functions that record it and ask for its pipelines. One that shows nothing gives empty ones: its
/// frame is only looked at.
class Recorder {
public:
    Recorder() = default;
    explicit Recorder(std::shared_ptr<const ShownScene> shown) : shown_(std::move(shown)) {}

    graph::Work plates() const;
    graph::Work shadowMap() const;
    graph::Work encodedDepth(const graph::EncodedFormat& format) const;
    graph::Work encodedDepthInOrder(graph::Image atlas, graph::Image nearest) const;
    /// @param distance  is written, too
    graph::Work nearestPrimitive(bool distance) const;
    graph::Work rims(graph::Image atlas, graph::Image numbers) const;

    /// @param nearest  depth itself; none: the depth buffer has it
    graph::Work impostors(passes::Output output, passes::NearestFrom from, graph::Image atlas,
                          std::optional<graph::Image> nearest = {}) const;
    /// As `format` encodes it, read as an input attachment or, where it left the tile, a texture.
    graph::Work impostorsAtEncodedDepth(passes::Output output, graph::Image atlas, graph::Image nearest,
                                        const graph::EncodedFormat& format) const;
    graph::Work shadedPrimitives(passes::Output output, graph::Image atlas, graph::Image numbers) const;
    graph::Work rimmedPrimitives(graph::Image atlas, graph::Image numbers, graph::Image rims,
                                 const graph::Clear& clear) const;

    /// @param before  depth of the layer before; none: the first
    graph::Work translucentLayer(graph::Image atlas, std::optional<graph::Image> before) const;
    /// @param nearest  of what is opaque, as `format` encodes it; none: the depth buffer has it
    graph::Work translucentColor(graph::Image atlas, graph::Image numbers, std::optional<graph::Image> nearest,
                                 const graph::EncodedFormat& format) const;

    graph::Work layersByTiles() const;
    /// @param layer  0: the nearest
    graph::Work layerOfTiles(graph::Image atlas, std::uint32_t layer) const;

    graph::Work nearestByTiles() const;
    /// @param depth  goes to the depth buffer, too
    graph::Work shadedTiles(passes::Output output, graph::Image atlas, bool depth = false) const;
    /// Both in one.
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

    std::shared_ptr<const ShownScene> shown_;
};

}  // namespace nacre
