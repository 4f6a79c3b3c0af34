#pragma once
// Depth maps of the molecule from a batch of directions, side by side in one image, drawn with the path that suits the
// device.

#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/device_options.h"
#include "engine/gpu/execute.h"
#include "engine/gpu/resources.h"
#include "engine/occlusion/pipelines.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/build/translucency.h"
#include "engine/scene/view/camera.h"
#include "engine/software/software.h"
#include "engine/tiles/tile_maps.h"

namespace nacre::occlusion {

/// Size and number per batch of the maps. Thread-safe.
struct DepthMapSizes {
    std::uint32_t pixels = 8, perBatch = 1;
    std::uint64_t bytes = 0, mostPrimitives = 1;  ///< per batch; per draw of the tile path
    /// Allowed error of meshes drawn on maps, pixels. The depth test has a slack of one pixel.
    static constexpr double kMeshError = 0.5;
    /// Patches narrower than this, texels, need fewer pixels per Å.
    static constexpr double kFullDetail = 10;
    DepthMapSizes() = default;
    /// Fits as many maps per batch as the device memory allows.
    DepthMapSizes(const gpu::Caps& caps, const Representation& representation, OcclusionMaps path, std::uint32_t pixels,
                  std::uint64_t room);
    /// Width of a map, for the scene and the memory of one map. It affects the texels, so it is the same on every path
    /// and device. @param detail  maximum width of a sphere's patch, texels
    static std::uint32_t pixelsFor(const Representation& representation, std::uint64_t room, std::uint32_t detail,
                                   bool moving = false);
    /// Device memory of one map, on the path that needs the most.
    static std::uint64_t mostBytes(std::uint32_t pixels);
    /// Device memory of maps by tiles and of lists for them. @param primitives  listed per map
    static std::uint64_t listedBytes(std::uint32_t pixels, std::uint32_t batch, std::uint64_t primitives);
    /// Device memory of 16 maps by tiles, or of 4 if 16 do not fit into `room`; 0 if 4 do not, either.
    static std::uint64_t batchBytes(const Representation& representation, std::uint32_t pixels, std::uint64_t room);
};

/// Part of a model that is drawn on a map: all instances, or a range.
struct MapPart {
    std::uint64_t first = 0, end = ~std::uint64_t{0};
};

/// The maps of a batch in a graph: an image, or heights in a buffer for `tiles`.
struct DrawnMaps {
    std::optional<graph::Image> image;
    std::optional<graph::Buffer> heights;
};

class DepthMaps {
public:
    static constexpr std::uint32_t kMostPerBatch = 16;

    /// @param path  not `automatic`
    /// @param representation  must outlive this
    /// @param sizes  if its bytes are 0, nothing is drawn
    /// @param occluders  prepared meshes
    DepthMaps(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
              OcclusionMaps path, const DepthMapSizes& sizes, OccluderMeshes occluders = {});

    /// Number of maps per batch that fits the memory: 1, 4 or 16.
    std::uint32_t perBatch() const { return sizes_.perBatch; }
    std::uint32_t pixels() const { return sizes_.pixels; }
    std::uint64_t bytes() const { return sizes_.bytes; }

    /// Number of models that do not occlude each other and have separate maps; 1: every map shows everything.
    std::uint32_t models() const { return static_cast<std::uint32_t>(runs_.size()); }

    /// Maximum number of instances per draw, over all maps.
    std::uint64_t mostInstances() const { return mostInstances_; }
    /// The heights for `tiles`, instead of images; else null.
    const TileMaps* tiles() const { return tiles_.get(); }
    /// Number of maps per row of a batch.
    std::uint32_t across(std::uint32_t batch) const { return mapsAcross(tiles_ ? perBatch() : batch); }

    /// Instances of a model's primitives in all copies, drawn on each map.
    std::uint64_t instances(std::uint32_t model) const;

    /// Declares the passes that draw a batch of a model: one map per rotation in `frames`, at most `batch` (1, 4 or
    /// 16).
    /// @param frames  kept until the graph has run
    DrawnMaps declare(graph::Graph& g, gpu::Imports& imports, std::span<const glm::dmat3> frames, std::uint32_t batch,
                      std::uint32_t model);
    /// Draws one map in parts, from the first instance to the last. Each part is a graph.
    void declarePart(graph::Graph& g, gpu::Imports& imports, std::span<const glm::dmat3> frame, std::uint32_t model,
                     std::uint64_t first, std::uint64_t end);
    /// The finished map, for later graphs.
    DrawnMaps drawnParts(graph::Graph& g, gpu::Imports& imports) const;
    /// Compiles the pipelines ahead. @param parts  whether maps will be drawn in parts
    void wantPipelines(gpu::Executor& executor, bool parts) const;
    /// Whether the maps hold encoded depth, not depth itself.
    bool encoded() const { return path_ == OcclusionMaps::encoded; }
    /// Frees the memory of the maps.
    void release() { tiles_.reset(), partMap_ = {}, partDepth_ = {}; }
    /// The view of one map.
    View view(const glm::dmat3& frame) const;

private:
    /// Drawn primitives of a model.
    struct Runs {
        std::vector<ModelRun> spheres, cylinders, triangles;
    };
    /// Render targets. Without a colour target, the depth buffer is the map.
    struct Images {
        graph::Image depth;
        std::optional<graph::Image> maps;
    };
    Images addImages(graph::Graph& g, std::uint32_t across) const;
    Images addPartImages(graph::Graph& g, bool begins) const;
    passes::PlacedCopies placed(const glm::dmat3& frame, std::uint32_t model, MapPart part = {}) const;
    layout::ViewConstants constants(const glm::dmat3& frame, std::uint32_t i, std::uint32_t across) const;
    /// Draws each map of a batch in a separate pass.
    graph::Work eachMap(std::span<const glm::dmat3> frames, std::uint32_t across, std::uint32_t model, MapPart part,
                        const passes::GeometryPass& pass) const;
    double radiusPixels() const { return meanRadius_ * pixels() / (2.0 * radius_); }
    std::uint64_t instancesThatFit() const;
    void beginTiles(std::span<const glm::dmat3> frames, std::uint32_t model);
    void declareDrawn(graph::Graph& g, Images& images, std::span<const glm::dmat3> frames, std::uint32_t across,
                      std::uint32_t model, MapPart part) const;
    void makePartImages();

    const gpu::Device& device_;
    const passes::SceneBuffers& scene_;
    const Representation& representation_;
    OcclusionMaps path_;
    DepthMapSizes sizes_;
    double radius_, meanRadius_ = 0;
    std::uint64_t mostInstances_ = 0;
    TranslucentParts translucent_;  ///< left out of maps
    std::vector<Runs> runs_;        // by model
    std::unique_ptr<TileMaps> tiles_;
    gpu::Image partMap_, partDepth_;  // for a direction drawn in parts
};

}  // namespace nacre::occlusion
