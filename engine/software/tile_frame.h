#pragma once
// Data of one frame of the `tiles` path: the host's lists, on the device.

#include <memory>
#include <vector>

#include "engine/gpu/pool.h"
#include "engine/gpu/resources.h"
#include "engine/graph/graph.h"
#include "engine/passes/scene_view.h"
#include "engine/results.h"
#include "engine/software/tile_lists.h"

namespace nacre::passes {

/// A growing buffer, with a texel view where the device's texel buffers can hold whole streams.
struct TileBuffer {
    gpu::Buffer buffer;
    vk::raii::BufferView texels{nullptr};
};

/// One or more words per pixel, row by row of all bins; 0: no primitive.
struct PixelWords : TileBuffer {
    vk::raii::BufferView quads{nullptr};   ///< as four-word texels
    std::vector<TileLists::Span> written;  ///< where it may hold words of an earlier frame
    std::uint32_t across = 0;              ///< bins per row of those
    std::size_t cleared = 0;               ///< bytes that have been cleared since
};

/// Enlarges a buffer if needed, with room to grow. @param format  of texels; undefined: no texel view
void reserve(const gpu::Device& device, TileBuffer& buffer, std::size_t bytes, vk::BufferUsageFlags usage,
             vk::Format format, const char* name);

/// Data for drawing a frame's edges.
struct TileEdges {
    bool drawn = false;
    bool placed = false;       ///< the host has listed their pixels
    bool alone = false;        ///< of what is shaded, only they are, and they need but numbers
    bool everywhere = false;   ///< some primitives are so small that one may lie between pixel centres
    bool listed = false;       ///< samples search the lists, not only the pixel's neighbours
    TileBuffer pixels;         ///< edge pixels: kEdgeHeader words, then groups of as many as a subgroup has lanes
    std::uint32_t groups = 0;  ///< number of groups
    PixelWords numbers;        ///< as in TileFrame; where those are colours, edge colours go there
    TileBuffer colors;         ///< else: as the numbers, linear, premultiplied halves; kNoEdge elsewhere
};

/// Pixels of a frame that the host wants drawn as edges, in place of those that the device finds.
struct EdgePlaces {
    std::uint32_t across = 0;
    std::vector<std::uint8_t> pixels;  ///< row by row: not 0 where wanted
};

/// Options of a frame.
struct TileWork {
    bool shaded = false;                 ///< compute shades, too
    bool edges = false;                  ///< edges are drawn
    bool edgesAlone = false;             ///< only they are shaded, from the numbers of primitives
    std::uint32_t longestList = 0;       ///< a frame with a longer list is not uploaded
    bool subsamples = false;             ///< pixels are samples of a picture's, and need not be asked at their centres
    std::uint32_t kept = 1;              ///< numbers of a pixel
    const TileMask* mask = nullptr;      ///< as TileView has it
    const SphereBoxes* boxes = nullptr;  ///< as TileScenery has it
    std::span<const Chunk> triangleChunks = {};  ///< likewise
    const EdgePlaces* places = nullptr;          ///< of edges, if compute shades
};

struct TileFrame {
    TileLists lists;
    layout::TileConstants constants{};
    std::uint32_t groups = 0;  ///< of the workgroups that draw its tiles
    bool copies = false;       ///< primitives have the transforms of copies
    bool shaded = false;       ///< `numbers` are colours
    bool cleared = false;      ///< of what is shaded, covered pixels alone are written
    TileBuffer words;          ///< TileLists::write()
    TileBuffer rows;           ///< PlacedCopies::rows
    PixelWords numbers;        ///< of the nearest primitives, counted from 1; sights, where edges are drawn
    TileBuffer spans;          ///< TileLists::spans() as vertices
    TileEdges edges;

    std::uint32_t rowPixels() const { return lists.across() * TileLists::kBinPixels; }
    /// The buffer made for edges.
    const TileBuffer& edgeBuffer() const { return shaded ? edges.numbers : edges.colors; }
    const PixelWords& sights() const { return shaded ? edges.numbers : numbers; }
};

/// The view for the host's lists. @param centers  only pixel centres are sampled
TileView tileView(const SceneView& seen, const View& view, graph::Extent image, bool centers);

/// Sizes of the lists, for statistics.
TileCounts countsOf(const TileLists& lists);

/// Rows of bins as shaders/tile_span.vert reads them.
struct TileSpanVertex {
    glm::vec4 ndc;  ///< left, top, right, bottom
};

/// Frames in flight: each has its own buffers, which are reused when nobody holds them.
class TileFrames {
public:
    explicit TileFrames(const gpu::Device& device) : device_(device) {}

    /// Lists the primitives in view and uploads the lists, if none is too long.
    std::shared_ptr<const TileFrame> prepare(const Representation& representation, const SceneView& seen,
                                             const View& view, graph::Extent image, TileWork work);

private:
    /// Reserves the words of an image's pixels, and clears leftovers of earlier frames where none will be written.
    /// @param kept  words per pixel @param all  clears the others as well: the device writes those of covered pixels
    void prepareWords(PixelWords& words, const TileLists& lists, graph::Extent image, std::uint32_t kept, bool all,
                      const char* name) const;
    static void writeSeeds(TileFrame& frame);
    void upload(TileFrame& frame, const PlacedCopies& copies, graph::Extent image, std::uint32_t kept) const;
    void uploadEdges(TileFrame& frame, graph::Extent image, const EdgePlaces* places) const;

    const gpu::Device& device_;
    gpu::Pool<TileFrame> frames_;
    std::vector<TileCall> spheres_, cylinders_, triangles_;  // scratch of one frame
};

}  // namespace nacre::passes
