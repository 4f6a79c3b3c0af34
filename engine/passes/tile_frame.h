#pragma once
// What one frame of the `tiles` path draws from: the host's lists, on the device.

#include <memory>
#include <vector>

#include "engine/gpu/pool.h"
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

/// A word a pixel, or a few, row by row of all bins; 0 where nothing is seen.
struct PixelWords : TileBuffer {
    vk::raii::BufferView quads{nullptr};   ///< of four words
    std::vector<TileLists::Span> written;  ///< where it may hold words of the frame before
    std::uint32_t across = 0;              ///< bins in a row of those
};

/// Makes a buffer anew, with room to grow, if it holds less. @param format  of texels; undefined: it has none
void reserve(const gpu::Device& device, TileBuffer& buffer, std::size_t bytes, vk::BufferUsageFlags usage,
             vk::Format format, const char* name);

/// What the edges of a frame are drawn with, if they are.
struct TileEdges {
    bool drawn = false;
    bool everywhere = false;   ///< primitives are so small that one may stand between the middles of pixels
    bool listed = false;       ///< what their samples see is looked for in lists, not among a pixel's neighbours
    TileBuffer pixels;         ///< edge pixels: kEdgeHeader words, then as many at a time as a subgroup has lanes
    std::uint32_t groups = 0;  ///< that draw them
    PixelWords numbers;        ///< as TileFrame's, where those are colours, among which those of edges are, then
    TileBuffer colors;         ///< else: as the numbers, linear, premultiplied halves; kNoEdge elsewhere
};

/// What is asked of a frame.
struct TileWork {
    bool shaded = false;                 ///< compute shades, too
    bool edges = false;                  ///< edges are drawn; none are where a list is longer than their loops
    bool subsamples = false;             ///< pixels are samples of a picture's, and need not be asked at their centres
    std::uint32_t kept = 1;              ///< numbers of a pixel
    const SphereBoxes* boxes = nullptr;  ///< as TileScenery has it
};

struct TileFrame {
    TileLists lists;
    layout::TileConstants constants{};
    bool copies = false;  ///< primitives stand at the places of copies
    bool shaded = false;  ///< `numbers` are colours
    bool subsamples = false;
    TileBuffer words;    ///< TileLists::write()
    TileBuffer rows;     ///< PlacedCopies::rows
    PixelWords numbers;  ///< of the nearest primitives, counted from 1; sights, where edges are drawn
    TileBuffer spans;    ///< TileLists::spans() as vertices
    TileEdges edges;

    std::uint32_t rowPixels() const { return lists.across() * TileLists::kBinPixels; }
    /// What is made for the edges' sake.
    const TileBuffer& edgeBuffer() const { return shaded ? edges.numbers : edges.colors; }
    const PixelWords& sights() const { return shaded ? edges.numbers : numbers; }
};

/// How the host's lists look at a view. @param centers  pixels are asked at their centres alone
TileView tileView(const SceneView& seen, const View& view, graph::Extent image, bool centers);

/// What lists hold, for who asks.
TileCounts countsOf(const TileLists& lists);

/// Rows of bins as shaders/tile_span.vert reads them.
struct TileSpanVertex {
    glm::vec4 ndc;  ///< left, top, right, bottom
};

/// The frames in flight: each has buffers of its own, which are used again when nobody holds it any more.
class TileFrames {
public:
    explicit TileFrames(const gpu::Device& device) : device_(device) {}

    /// Lists what a view may see, and uploads that. @returns null if a list is longer than the device's loops
    std::shared_ptr<const TileFrame> prepare(const Representation& representation, const SceneView& seen,
                                             const View& view, graph::Extent image, TileWork work);

private:
    /// Room for the words of an image's pixels; nothing is left of the frame before where none will be written.
    /// @param kept  words of a pixel
    void prepareWords(PixelWords& words, const TileLists& lists, graph::Extent image, std::uint32_t kept,
                      const char* name) const;
    static void writeSeeds(TileFrame& frame);
    void upload(TileFrame& frame, const PlacedCopies& copies, graph::Extent image, std::uint32_t kept) const;
    void uploadEdges(TileFrame& frame, graph::Extent image) const;

    const gpu::Device& device_;
    gpu::Pool<TileFrame> frames_;
    std::vector<TileCall> spheres_, cylinders_, triangles_;  // of one frame
};

}  // namespace nacre::passes
