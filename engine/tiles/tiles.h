#pragma once
// The `tiles` path: compute draws from lists of the primitives in each square of pixels. The device makes the lists
// (device_lists.h), or on software devices the host (HostLister, engine/software). Where subgroups exchange values, one
// subgroup draws a tile (lanes/); else a workgroup does by shared memory, as on every phone.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/gpu/execute.h"
#include "engine/passes/output.h"
#include "engine/passes/scene_view.h"
#include "engine/passes/tile_frame.h"
#include "engine/passes/tile_mask.h"
#include "engine/scene/view/camera.h"
#include "engine/tiles/tile_set.h"

namespace nacre::passes {

/// Edge pixels of a frame that the host chooses, instead of those that the device finds.
struct EdgePlaces {
    std::uint32_t across = 0;
    std::vector<std::uint8_t> pixels;  ///< row by row: not 0 where wanted
};

/// The result of compute for each pixel.
enum class TileResult : std::uint8_t {
    words,   ///< the nearest primitive's number, to a buffer
    colors,  ///< its shaded colour, to a buffer
    image,   ///< its number, to an image
    layers,  ///< the colours of its translucent layers as halves, to a buffer
};
/// Words of the buffer.
constexpr std::uint32_t pixelWords(TileResult result) { return result == TileResult::layers ? layout::kLayerWords : 1; }

/// Options of a frame.
struct TileWork {
    bool byDevice = false;  ///< the device makes the lists
    TileResult result = TileResult::words;
    bool edges = false;              ///< edges are drawn
    bool edgesAlone = false;         ///< only edges are shaded, from primitive numbers
    bool frontSpheres = false;       ///< the host finds the nearest sphere of each pixel
    bool marksSmall = false;         ///< TileFrame::showsSmall() is asked
    bool subsamples = false;         ///< pixels are samples of a picture's pixels, and are not tested at their centres
    std::uint32_t longestList = 0;   ///< a frame with a longer list is not uploaded
    const TileMask* mask = nullptr;  ///< null: all tiles are drawn
    std::span<const Chunk> triangleChunks = {};  ///< optional
    const EdgePlaces* places = nullptr;          ///< edge pixels, if compute shades

    /// Half width in pixels below which a primitive may be missed by all pixels around it.
    static constexpr double kSmallPixels = 0.75;
    float small() const { return edges || marksSmall ? static_cast<float>(kSmallPixels) : 0.0f; }
};

/// The view of a frame whose lists are made.
struct ListedView {
    const Representation& representation;
    const SceneView& seen;
    const View& view;
    graph::Extent image;
};

/// Lists of one frame that the host makes.
class HostLists {
public:
    virtual ~HostLists() = default;
    virtual const TileSet& tiles() const = 0;
    virtual std::uint32_t longest() const = 0;  ///< entries of a list
    virtual TileCounts counts() const = 0;
    virtual bool holds(std::size_t bin) const = 0;  ///< whether anything may be visible there
    virtual std::size_t words() const = 0;          ///< of the device's data
    virtual void write(std::uint32_t* to) = 0;
    virtual bool seeded() const = 0;  ///< whether pixels begin with a primitive from writeSeeds()
    virtual void writeSeeds(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t* to) const = 0;
};

/// Makes lists on the host. Keeps what it knows of a scene between frames.
class HostLister {
public:
    virtual ~HostLister() = default;
    virtual std::unique_ptr<HostLists> makeLists() const = 0;
    virtual void build(HostLists& lists, const ListedView& view, const TileWork& work) = 0;
};

/// Frames in flight: each has its own buffers, which are reused once nobody holds them.
class TileFrames {
public:
    virtual ~TileFrames() = default;
    /// Lists the primitives in view and uploads the lists, if none is too long. Where the device makes the lists,
    /// uploads what it needs for that.
    virtual std::shared_ptr<const TileFrame> prepare(const ListedView& view, TileWork work) = 0;
};
/// @param lister  null: the device makes all lists
std::unique_ptr<TileFrames> makeTileFrames(const gpu::Device& device, std::unique_ptr<HostLister> lister);

/// Compute: makes the lists of a frame whose TileWork says so. The first step counts for all rounds; the others run in
/// each, in this order.
struct BinLists {
    enum class Step : std::uint8_t { count, place, write, sort } step{};
    std::uint32_t round = 0;
};
void draw(gpu::PassContext& context, const SceneView& view, const BinLists& lists);
/// Requests the pipeline.
void want(gpu::PipelineContext& context, const SceneView& view, const BinLists& lists);

/// Compute, without subgroup operations: writes the number of each pixel's nearest primitive, or 0, to an image. A
/// workgroup draws a tile.
struct TileNumbers {
    vk::ImageView image;
};
void draw(gpu::PassContext& context, const SceneView& view, const TileNumbers& pass);
/// Requests the pipeline.
void want(gpu::PipelineContext& context, const SceneView& view, const TileNumbers& pass);

}  // namespace nacre::passes
