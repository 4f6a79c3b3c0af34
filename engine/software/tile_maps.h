#pragma once
// Depth maps of a batch by tiles: finds the nearest primitives per tile from lists in depth order, in parts as small as
// the frame time requires. The maps are heights in a buffer, as texels. The host draws triangles.

#include <glm/mat3x3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "engine/gpu/execute.h"
#include "engine/occlusion/mesh_heights.h"
#include "engine/passes/placed_copies.h"
#include "engine/passes/primitives.h"
#include "engine/software/tile_frame.h"
#include "engine/software/tile_lists.h"

namespace nacre::occlusion {

class TileMaps {
public:
    /// @param pixels  width of a map @param radius  of the scene's bounding sphere, Å @param across  maps per row of a
    /// batch @param occluders  those made ahead
    TileMaps(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
             std::uint32_t pixels, double radius, std::uint32_t across, OccluderMeshes occluders);

    /// Device memory, bytes. Lists differ between parts: the estimate per primitive is that of large molecules.
    static std::uint64_t bytesFor(std::uint32_t pixels, std::uint32_t across);
    static constexpr std::uint64_t kBytesPerPrimitive = 9;

    /// Begins a batch with empty maps. @param maps  contents of each, at most across x across
    void begin(std::span<const passes::PlacedCopies> maps);
    /// Declares the passes that draw these primitives of the batch, counted from map to map. Earlier declared passes
    /// must have run.
    graph::Buffer declare(graph::Graph& g, gpu::Imports& imports, std::uint64_t first, std::uint64_t end);
    /// Requests the pipelines of these passes.
    void wantPipelines(gpu::PipelineContext& context) const;
    /// The maps, for passes that draw or read them.
    graph::Buffer import(graph::Graph& g, gpu::Imports& imports) const;

    const gpu::Buffer& buffer() const { return heights_; }
    /// The maps as texels, where the device reads streams so; else null.
    vk::BufferView texels() const { return *heightTexels_; }
    /// Pixels per row of the batch.
    std::uint32_t pitch() const { return apart_ * across_; }
    /// Pixels from one map to the next.
    std::uint32_t apart() const { return apart_; }

private:
    struct Call {
        TileCall call;
        passes::Primitive kind{};
        std::uint32_t map = 0;
        const OccluderMesh* mesh = nullptr;  ///< of triangles
    };
    struct MeshCall {
        const glm::vec4* rows = nullptr;
        const OccluderMesh* mesh = nullptr;
        std::size_t first = 0, end = 0;  ///< of its triangles
    };

    /// Primitives whose lists are drawn at a time.
    struct Part {
        TileLists lists;
        passes::TileBuffer words;
    };
    void take(std::uint64_t first, std::uint64_t end);
    void drawTriangles();
    void list(Part& part, std::uint64_t first, std::uint64_t& end);
    void record(gpu::PassContext& context, const Part& part) const;
    TileView view() const;

    const gpu::Device& device_;
    const passes::SceneBuffers& scene_;
    const Representation& representation_;
    std::uint32_t pixels_ = 0, apart_ = 0, across_ = 1;
    double radius_ = 0;
    std::vector<glm::vec4> rows_;    // of all copies of one map, then of the next
    std::vector<glm::vec4> asides_;  // as above, shifted to the map's position in the batch
    std::uint32_t copies_ = 1;       // per map
    std::vector<Call> calls_;
    std::vector<TileCall> spheres_, cylinders_;     // of the part being drawn
    std::vector<std::vector<MeshCall>> triangles_;  // as above, by map
    std::vector<std::unique_ptr<Part>> parts_;      // reused
    OccluderMeshes occluders_;
    std::vector<MeshHeights> meshes_;  // per thread
    passes::TileBuffer rowTexels_;
    gpu::Buffer heights_;
    vk::raii::BufferView heightTexels_{nullptr};
};

}  // namespace nacre::occlusion
