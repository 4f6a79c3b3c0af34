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

/// Gives each pass the function that records it. One that shows nothing gives empty ones: its frame is only looked at.
class Recorder {
public:
    Recorder() = default;
    explicit Recorder(std::shared_ptr<const ShownScene> shown) : shown_(std::move(shown)) {}

    graph::Record plates() const;
    graph::Record shadowMap() const;
    graph::Record encodedDepth(const graph::EncodedFormat& format) const;
    graph::Record encodedDepthInOrder(graph::Image atlas, graph::Image nearest) const;
    /// @param distance  is written, too
    graph::Record nearestPrimitive(bool distance) const;
    graph::Record rims(graph::Image atlas, graph::Image numbers) const;

    graph::Record impostorsByDepthBuffer(passes::Output output, graph::Image atlas) const;
    /// As `format` encodes it, read as an input attachment or, where it left the tile, a texture.
    graph::Record impostorsAtEncodedDepth(passes::Output output, graph::Image atlas, graph::Image nearest,
                                          const graph::EncodedFormat& format) const;
    /// Depth itself, as a texture.
    graph::Record impostorsAtNearestDepth(passes::Output output, graph::Image atlas, graph::Image nearest) const;
    graph::Record impostorsInOrder(passes::Output output, graph::Image atlas, graph::Image nearest) const;
    graph::Record shadedPrimitives(passes::Output output, graph::Image atlas, graph::Image numbers) const;
    graph::Record rimmedPrimitives(graph::Image atlas, graph::Image numbers, graph::Image rims,
                                   const graph::Clear& clear) const;

    /// @param before  depth of the layer before; none: the first
    graph::Record translucentLayer(graph::Image atlas, std::optional<graph::Image> before) const;
    /// @param nearest  of what is opaque, as `format` encodes it; none: the depth buffer has it
    graph::Record translucentColor(graph::Image atlas, graph::Image numbers, std::optional<graph::Image> nearest,
                                   const graph::EncodedFormat& format) const;

    graph::Record layersByTiles() const;
    /// @param layer  0: the nearest
    graph::Record layerOfTiles(graph::Image atlas, std::uint32_t layer) const;

    graph::Record nearestByTiles() const;
    /// @param depth  goes to the depth buffer, too
    graph::Record shadedTiles(passes::Output output, graph::Image atlas, bool depth = false) const;
    /// Both in one.
    graph::Record colorsByTiles(graph::Image atlas) const;
    graph::Record edgePixels() const;
    graph::Record edgesByTiles(graph::Image atlas) const;
    graph::Record edgeColors(const graph::Clear& clear) const;

    graph::Record overdraw() const;
    graph::Record tileMean(std::uint32_t tile, graph::Image source) const;
    graph::Record debugView(DebugView what, std::uint32_t tile, graph::Image source,
                            std::optional<graph::Image> under) const;

private:
    template <typename Pass>
    graph::Record of(Pass pass) const;
    template <typename Pass>
    graph::Record later(Pass pass) const;

    std::shared_ptr<const ShownScene> shown_;
};

}  // namespace nacre
