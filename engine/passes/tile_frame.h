#pragma once
// What one frame of the `tiles` path draws from: the host's lists, on the device.

#include <memory>
#include <vector>

#include "engine/gpu/resources.h"
#include "engine/graph/graph.h"
#include "engine/passes/scene_view.h"
#include "engine/results.h"
#include "engine/scene/tile_lists.h"

namespace nacre::passes {

/// Entries of a list. Turns of all loops that lavapipe 22.3 grants an invocation are 65,535; it then leaves them and
/// says nothing. One goes by every entry, and as many again by the chunks.
constexpr std::uint32_t kLongestList = 28000;

/// A buffer that grows, and its view as texels where the device's texel buffers hold whole streams.
struct TileBuffer {
    gpu::Buffer buffer;
    vk::raii::BufferView texels{nullptr};
};

/// Makes a buffer anew, with room to grow, if it holds less. @param format  of texels; undefined: it has none
void reserve(const gpu::Device& device, TileBuffer& buffer, std::size_t bytes, vk::BufferUsageFlags usage,
             vk::Format format, const char* name);

/// What the edges of a frame are drawn with, if they are.
struct TileEdges {
    bool drawn = false;
    bool everywhere = false;  ///< primitives are so small that one may stand between the middles of pixels
    TileBuffer slots;         ///< of the bins' first tiles, with a rim of bins without any
    TileBuffer numbers;       ///< as TileFrame's, where those are colours, among which those of edges are, then
    TileBuffer colors;        ///< else: tile by tile as the numbers, linear, premultiplied halves; kNoEdge elsewhere
};

/// What is asked of a frame.
struct TileWork {
    bool shaded = false;     ///< compute shades, too
    bool edges = false;      ///< edges are drawn; none are where a list is longer than their loops
    std::uint32_t kept = 1;  ///< numbers of a pixel
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
    TileEdges edges;

    /// What is made for the edges' sake.
    const TileBuffer& edgeBuffer() const { return shaded ? edges.numbers : edges.colors; }
};

/// What lists hold, for who asks.
TileCounts countsOf(const TileLists& lists);

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
    std::shared_ptr<const TileFrame> prepare(const Representation& representation, const SceneView& seen,
                                             const View& view, graph::Extent image, TileWork work);

private:
    static void clearColors(TileFrame& frame);
    void upload(TileFrame& frame, const PlacedCopies& copies, graph::Extent image, std::uint32_t kept) const;
    void uploadEdges(TileFrame& frame, graph::Extent image) const;

    const gpu::Device& device_;
    std::vector<std::shared_ptr<TileFrame>> frames_;
};

}  // namespace nacre::passes
