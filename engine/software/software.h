#pragma once
// The interface of this folder; the rest of the engine includes no other file of it. The `tiles` path draws by compute,
// from lists of primitives that the host makes on software devices, and the device on GPUs. Bakes draw depth maps from
// such lists, or by an invocation per primitive. Hidden spheres are culled on the host. A build without NACRE_SOFTWARE
// compiles absent.cpp instead of the folder: no device has the path then.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/gpu/execute.h"
#include "engine/occlusion/occluder_mesh.h"
#include "engine/passes/output.h"
#include "engine/passes/placed_copies.h"
#include "engine/passes/scene_view.h"
#include "engine/passes/tile_mask.h"
#include "engine/results.h"
#include "engine/scene/view/camera.h"

namespace nacre {

/// Squares of pixels that have a list of primitives each.
struct TileBins {
    static constexpr std::uint32_t kPixels = 16;  ///< per side
    /// Neighbouring bins of a row; ends are exclusive.
    struct Span {
        std::uint16_t x, y, endX, endY;
    };
    /// Pixels of all bins of a picture.
    static constexpr std::uint64_t pixels(std::uint32_t width, std::uint32_t height) {
        const auto bins = [](std::uint32_t side) { return (std::uint64_t{side} + kPixels - 1) / kPixels; };
        return bins(width) * bins(height) * kPixels * kPixels;
    }
};

}  // namespace nacre

namespace nacre::passes {

/// Edge pixels of a frame that the host chooses, instead of those that the device finds.
struct EdgePlaces {
    std::uint32_t across = 0;
    std::vector<std::uint8_t> pixels;  ///< row by row: not 0 where wanted
};

/// Options of a frame.
struct TileWork {
    bool byDevice = false;           ///< the device makes the lists
    bool shaded = false;             ///< compute also shades
    bool edges = false;              ///< edges are drawn
    bool edgesAlone = false;         ///< only edges are shaded, from primitive numbers
    bool frontSpheres = false;       ///< the host finds the nearest sphere of most pixels
    bool subsamples = false;         ///< pixels are samples of a picture's pixels, and are not tested at their centres
    std::uint32_t kept = 1;          ///< nearest primitives per pixel
    std::uint32_t longestList = 0;   ///< a frame with a longer list is not uploaded
    const TileMask* mask = nullptr;  ///< null: all tiles are drawn
    std::span<const Chunk> triangleChunks = {};  ///< optional
    const EdgePlaces* places = nullptr;          ///< edge pixels, if compute shades
};

/// A frame's lists, on the device.
class TileFrame {
public:
    virtual ~TileFrame() = default;
    virtual std::uint32_t longestList() const = 0;  ///< entries
    /// Where the device makes the lists: rounds in which it draws the tiles.
    virtual std::uint32_t rounds() const = 0;
    virtual TileCounts counts() const = 0;
    /// Number of spheres that the host found to be visible; empty: it did not test them.
    virtual std::optional<std::uint64_t> shownSpheres() const = 0;
    virtual std::span<const TileBins::Span> spans() const = 0;  ///< bins that show anything
    virtual float nearest() const = 0;                          ///< Z of the nearest depth
    virtual float farthest() const = 0;                         ///< Z of the farthest
    virtual std::uint32_t rowPixels() const = 0;                ///< pixels per row of the buffers
    /// Numbers of the nearest primitives from 1, or colours where compute shades; row by row of all bins.
    virtual const gpu::Buffer& pixels() const = 0;
    virtual vk::BufferView pixelTexels() const = 0;  ///< pixels() as texels
    /// Where the device makes the lists: their entries in any order, and the lists.
    virtual const gpu::Buffer& entries() const = 0;
    virtual const gpu::Buffer& sortedEntries() const = 0;
    virtual const gpu::Buffer& edges() const = 0;  ///< numbers if pixels() are colours, else edge colours
    virtual const gpu::Buffer& edgePixels() const = 0;
};

/// Frames in flight: each has its own buffers, which are reused once nobody holds them.
class TileFrames {
public:
    virtual ~TileFrames() = default;
    /// Lists the primitives in view and uploads the lists, if none is too long.
    virtual std::shared_ptr<const TileFrame> prepare(const Representation& representation, const SceneView& seen,
                                                     const View& view, graph::Extent image, TileWork work) = 0;
};
/// @returns null in a build without the path
std::unique_ptr<TileFrames> makeTileFrames(const gpu::Device& device);

/// Culls spheres hidden behind others of the same picture.
class HiddenSpheres {
public:
    virtual ~HiddenSpheres() = default;
    /// Drops hidden spheres; splits the calls into many. @param centers  only pixel centres are sampled
    virtual void drop(SceneView& seen, const Representation& representation, const Chunks& chunks, const View& view,
                      graph::Extent image, bool centers) = 0;
};
/// @returns null in a build without the path: devices then draw hidden spheres
std::unique_ptr<HiddenSpheres> makeHiddenSpheres();

// Compute: make the lists of a frame whose TileWork says so. The first counts for all rounds; the others run in each.
void countPrimitivesOfBins(gpu::PassContext& context, const SceneView& view);
void placeListsOfBins(gpu::PassContext& context, const SceneView& view, std::uint32_t round);
void writeListsOfBins(gpu::PassContext& context, const SceneView& view);
void sortListsOfBins(gpu::PassContext& context, const SceneView& view, std::uint32_t round);

/// Compute: writes TileFrame::pixels() of the view's non-empty tiles, one workgroup each.
struct NearestByTiles {
    /// For shading: then writes colours, 0 where nothing is seen.
    std::optional<vk::ImageView> atlas{};
};
void draw(gpu::PassContext& context, const SceneView& view, const NearestByTiles& pass);
/// Requests the pipelines.
void want(gpu::PipelineContext& context, const SceneView& view, const NearestByTiles& pass);

/// Shades every pixel that has a number, once.
struct TileShading {
    vk::ImageView atlas;
    Output output = Output::color;
    bool depth = false;  ///< also writes the depth buffer
    /// If set, composites one translucent layer of a view where the depth test passes; 0: nearest.
    std::optional<std::uint32_t> layer{};
};
void draw(gpu::PassContext& context, const SceneView& view, const TileShading& pass);
/// Requests the pipeline.
void want(gpu::PipelineContext& context, const SceneView& view, const TileShading& pass);

/// Compute: writes for each pixel of the view's tiles the numbers of the two nearest triangles.
/// @param view  of translucent triangles only
void findLayersByTiles(gpu::PassContext& context, const SceneView& view);

/// Compute: lists the edge pixels, found from the numbers and colours of the nearest primitives.
void findEdgesByTiles(gpu::PassContext& context, const SceneView& view);
/// Compute: draws edge pixels with RenderSettings::kEdgeSamples samples.
void drawEdgesByTiles(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas);
/// Composites edge pixels over the picture. @param clear  the picture's clear value
void drawEdgeColors(gpu::PassContext& context, const SceneView& view, const graph::Clear& clear);

}  // namespace nacre::passes

namespace nacre::occlusion {

enum class Texels : std::uint8_t;

/// Depth maps of a batch by compute: heights in a buffer.
class TileMaps {
public:
    virtual ~TileMaps() = default;

    /// Pixels from one map to the next.
    static constexpr std::uint32_t apartFor(std::uint32_t pixels) {
        return (pixels + TileBins::kPixels - 1) / TileBins::kPixels * TileBins::kPixels;
    }
    /// Device memory, bytes. Lists differ between parts: the estimate per primitive is that of large molecules.
    static constexpr std::uint64_t bytesFor(std::uint32_t pixels, std::uint32_t across) {
        const std::uint64_t side = std::uint64_t{apartFor(pixels)} * across;
        return sizeof(float) * side * side;
    }
    static constexpr std::uint64_t kBytesPerPrimitive = 9;

    /// Begins a batch with empty maps. @param maps  contents of each, at most across x across
    virtual void begin(std::span<const passes::PlacedCopies> maps) = 0;
    /// Declares the passes that draw these primitives of the batch, counted across its maps. Earlier declared passes
    /// must have run.
    virtual graph::Buffer declare(graph::Graph& g, gpu::Imports& imports, std::uint64_t first, std::uint64_t end) = 0;
    /// Requests the pipelines of these passes.
    virtual void wantPipelines(gpu::PipelineContext& context) const = 0;
    /// The maps, for passes that draw or read them.
    virtual graph::Buffer import(graph::Graph& g, gpu::Imports& imports) const = 0;
    virtual const gpu::Buffer& buffer() const = 0;
    /// The maps as texels, if the device reads streams as texels; else null.
    virtual vk::BufferView texels() const = 0;
    virtual std::uint32_t pitch() const = 0;  ///< pixels per row of the batch
    virtual std::uint32_t apart() const = 0;  ///< pixels from one map to the next
};
/// @param pixels  width of a map @param radius  of the scene's bounding sphere, Å @param across  maps per row of a
/// batch
/// @param occluders  made ahead @returns null in a build without them
std::unique_ptr<TileMaps> makeTileMaps(const gpu::Device& device, const passes::SceneBuffers& scene,
                                       const Representation& representation, std::uint32_t pixels, double radius,
                                       std::uint32_t across, OccluderMeshes occluders);

/// The stage that samples such maps.
gpu::ShaderWords questionsToTileMaps(Texels texels, const graph::TileCaps& caps);

}  // namespace nacre::occlusion
