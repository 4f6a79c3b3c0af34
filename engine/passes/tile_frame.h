#pragma once
// What one frame of the `tiles` path draws from: the host's lists, on the device.

#include <memory>
#include <vector>

#include "engine/gpu/resources.h"
#include "engine/graph/graph.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/tile_lists.h"

namespace nacre::passes {

/// A buffer that grows, and its view as texels where the device's texel buffers hold whole streams.
struct TileBuffer {
    gpu::Buffer buffer;
    vk::raii::BufferView texels{nullptr};
};

struct TileFrame {
    TileLists lists;
    layout::TileConstants constants{};
    bool copies = false;                   ///< primitives stand at the places of copies
    bool shaded = false;                   ///< `numbers` are colours, row by row
    TileBuffer words;                      ///< tiles, two words each; where the bins' lists begin; the lists
    TileBuffer rows;                       ///< PlacedCopies::rows
    TileBuffer numbers;                    ///< of the nearest primitives, tile by tile, counted from 1; 0: none
    TileBuffer spans;                      ///< TileLists::spans() as vertices
    std::vector<TileLists::Span> colored;  ///< where `numbers` may hold colours of the frame before
    std::uint32_t coloredAcross = 0;       ///< bins in a row of those
};

/// Rows of bins as shaders/tile_span.vert reads them.
struct TileSpanVertex {
    glm::vec4 ndc;                ///< left, top, right, bottom
    std::uint32_t left, numbers;  ///< pixel of its left edge, where its numbers begin
};

/// The frames in flight: each has buffers of its own, which are used again when nobody holds it any more.
class TileFrames {
public:
    explicit TileFrames(const gpu::Device& device) : device_(device) {}

    /// Lists what a view may see, and uploads that. @returns null if a list is longer than the device's loops
    /// @param shaded  compute shades, too
    std::shared_ptr<const TileFrame> prepare(const Representation& representation, const SceneView& seen,
                                             const View& view, graph::Extent image, bool shaded);

private:
    static void clearColors(TileFrame& frame);
    void upload(TileFrame& frame, const PlacedCopies& copies, graph::Extent image) const;
    void reserve(TileBuffer& buffer, std::size_t bytes, vk::BufferUsageFlags usage, vk::Format format,
                 const char* name) const;

    const gpu::Device& device_;
    std::vector<std::shared_ptr<TileFrame>> frames_;
};

}  // namespace nacre::passes
