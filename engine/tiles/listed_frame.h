#pragma once
// Data of one frame of the `tiles` path: lists and buffers.

#include <limits>
#include <memory>
#include <vector>

#include "engine/gpu/pool.h"
#include "engine/gpu/resources.h"
#include "engine/graph/graph.h"
#include "engine/passes/scene_view.h"
#include "engine/tiles/device_lists.h"
#include "engine/tiles/tiles.h"

namespace nacre::passes {

/// A growing buffer, with a texel view where the device's texel buffers can hold whole streams.
struct TileBuffer {
    gpu::Buffer buffer;
    vk::raii::BufferView texels{nullptr};
};

/// One or more words per pixel, row by row of all bins; 0: no primitive.
struct PixelWords : TileBuffer {
    vk::raii::BufferView quads{nullptr};    ///< as four-word texels
    vk::raii::BufferView picture{nullptr};  ///< as texels, where the device reads streams from storage buffers
    std::vector<TileSet::Span> written;     ///< where it may hold words of earlier frames
    std::uint32_t across = 0;               ///< bins per row of those
    std::size_t cleared = 0;                ///< bytes cleared since then
};

/// Enlarges a buffer if needed, with room to grow. @param format  of texels; undefined: no texel view
void reserve(const gpu::Device& device, TileBuffer& buffer, std::size_t bytes, vk::BufferUsageFlags usage,
             vk::Format format, const char* name);

/// Data for drawing a frame's edges.
struct TileEdges {
    bool drawn = false;
    bool placed = false;       ///< the host has listed their pixels
    bool alone = false;        ///< shades edge pixels only, from primitive numbers
    bool everywhere = false;   ///< some primitives are so small that one may lie between pixel centres
    bool listed = false;       ///< samples search the lists, not only the pixel's neighbours
    TileBuffer pixels;         ///< edge pixels: kEdgeHeader words, then groups of one pixel per lane of a subgroup
    std::uint32_t groups = 0;  ///< number of groups
    PixelWords numbers;        ///< as in TileFrame; if those are colours, edge colours go here
    TileBuffer colors;         ///< else edge colours: linear, premultiplied halves; kNoEdge elsewhere
};

/// Data for lists that the device makes.
struct ListsByDevice {
    TileBuffer calls;                    ///< as in shaders/tile_bins.comp
    TileBuffer work;                     ///< as in shaders/common/list_layout.glsl; counts are 0 between frames
    std::uint32_t items = 0;             ///< primitives that may enter lists
    std::uint32_t across = 0, down = 0;  ///< bins of the tiles in `words`; 0: none are written
    ListRounds rounds;
    std::uint32_t share = 1;  ///< chooseShare()
};

/// A frame's lists and buffers.
class ListedFrame final : public TileFrame {
public:
    std::uint32_t longestList() const override {
        if (tooMany) return std::numeric_limits<std::uint32_t>::max();
        return byDevice ? 0 : host->longest();
    }
    std::uint32_t rounds() const override { return byDevice ? byDevice->rounds.count : 1; }
    TileCounts counts() const override { return byDevice ? TileCounts() : host->counts(); }  // the host knows none
    std::span<const TileBins::Span> spans() const override { return tiles().spans(); }
    float nearest() const override { return constants.depthStart; }
    float farthest() const override { return constants.depthStart + 1 / constants.perRange; }
    bool showsSmall(std::uint32_t x, std::uint32_t y) const override { return tiles().showsSmall(x, y); }
    std::uint32_t rowPixels() const override { return tiles().across() * TileSet::kBinPixels; }
    const gpu::Buffer& pixels() const override { return numbers.buffer; }
    vk::BufferView pixelTexels() const override { return *numbers.texels ? *numbers.texels : *numbers.picture; }
    const gpu::Buffer& entries() const override { return byDevice ? byDevice->work.buffer : words.buffer; }
    const gpu::Buffer& sortedEntries() const override { return words.buffer; }
    const gpu::Buffer& edges() const override { return (shaded() ? edgeData.numbers : edgeData.colors).buffer; }
    const gpu::Buffer& edgePixels() const override { return edgeData.pixels.buffer; }

    const TileSet& tiles() const { return byDevice ? covered : host->tiles(); }
    bool seeded() const { return !byDevice && host->seeded(); }
    bool holds(std::size_t bin) const { return byDevice || host->holds(bin); }
    /// `numbers` are colours.
    bool shaded() const { return result == TileResult::colors; }

    std::unique_ptr<HostLists> host;          ///< made when the host first lists a frame
    std::unique_ptr<ListsByDevice> byDevice;  ///< null: the host has made the lists
    TileSet covered;                          ///< tiles of the device's lists
    layout::TileConstants constants{};
    std::uint32_t groups = 0;  ///< workgroups that draw its tiles
    bool tooMany = false;      ///< more entries than the device lists in its rounds
    bool copies = false;       ///< primitives have the transforms of copies
    bool cleared = false;      ///< the device writes covered pixels only; the others are cleared
    TileResult result{};
    TileBuffer words;            ///< HostLists::write(), or as shaders/common/list_layout.glsl says
    TileBuffer rows;             ///< PlacedCopies::rows
    PixelWords numbers;          ///< of the nearest primitives, from 1; sights, where edges are drawn; or layers
    TileBuffer spanVertices;     ///< TileSet::spans() as vertices; of masked layers, drawnRows()
    std::uint32_t rowCount = 0;  ///< of those
    TileEdges edgeData;

    const PixelWords& sights() const { return shaded() ? edgeData.numbers : numbers; }
};

/// The lists of a view that is drawn by tiles.
inline const ListedFrame& listedFrame(const SceneView& view) { return static_cast<const ListedFrame&>(*view.tiles); }

/// Rows of bins or tiles, as shaders/tile_span.vert reads them.
struct TileSpanVertex {
    glm::vec4 ndc;  ///< left, top, right, bottom
};

class ListedFrames final : public TileFrames {
public:
    ListedFrames(const gpu::Device& device, std::unique_ptr<HostLister> lister)
        : device_(device), lister_(std::move(lister)) {}
    std::shared_ptr<const TileFrame> prepare(const ListedView& view, TileWork work) override;

private:
    /// Reserves the words of an image's pixels, and clears leftovers of earlier frames that will not be overwritten.
    void prepareWords(PixelWords& words, const ListedFrame& frame, graph::Extent image, TileResult result,
                      const char* name) const;
    static void writeSeeds(ListedFrame& frame);
    bool prepareLists(ListedFrame& frame, const ListedView& view, const TileWork& work);
    void uploadCalls(ListedFrame& frame, const SceneView& seen, float small, std::uint64_t room,
                     std::uint32_t share) const;
    const MeasuredPrimitives& measuredPrimitives(const Representation& representation, const SceneView& seen);
    void upload(ListedFrame& frame, const PlacedCopies& copies, graph::Extent image) const;
    void uploadEdges(ListedFrame& frame, graph::Extent image, const EdgePlaces* places) const;

    const gpu::Device& device_;
    std::unique_ptr<HostLister> lister_;  // null: the device makes all lists
    gpu::Pool<ListedFrame> frames_;
    std::weak_ptr<const void> measured_;  // the scene of `sizes_`
    MeasuredPrimitives sizes_;
};

}  // namespace nacre::passes
