#pragma once
// Depth maps of a batch by tiles: finds the nearest primitives per tile from lists in depth order, in parts small
// enough for the frame time. The maps are heights in a buffer, as texels. The host draws triangles.

#include <memory>
#include <span>
#include <vector>

#include "engine/gpu/execute.h"
#include "engine/occlusion/mesh_heights.h"
#include "engine/passes/placed_copies.h"
#include "engine/passes/primitives.h"
#include "engine/software/tile_lists.h"
#include "engine/tiles/listed_frame.h"
#include "engine/tiles/tile_maps.h"

namespace nacre::occlusion {

class ListedMaps final : public TileMaps {
public:
    ListedMaps(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
               std::uint32_t pixels, double radius, std::uint32_t across, OccluderMeshes occluders);

    void begin(std::span<const passes::PlacedCopies> maps) override;
    graph::Buffer declare(graph::Graph& g, gpu::Imports& imports, std::uint64_t first, std::uint64_t end) override;
    void wantPipelines(gpu::PipelineContext& context) const override;
    graph::Buffer import(graph::Graph& g, gpu::Imports& imports) const override;
    const gpu::Buffer& buffer() const override { return heights_; }
    vk::BufferView texels() const override { return *heightTexels_; }
    std::uint32_t pitch() const override { return apart_ * across_; }
    std::uint32_t apart() const override { return apart_; }

private:
    struct Call {
        TileCall call;
        passes::Primitive kind{};
        std::uint32_t map = 0;
        const OccluderMesh* mesh = nullptr;  ///< for triangles
    };
    struct MeshCall {
        const glm::vec4* rows = nullptr;
        const OccluderMesh* mesh = nullptr;
        std::size_t first = 0, end = 0;  ///< range of its triangles
    };

    /// Primitives whose lists are drawn together.
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
    std::vector<glm::vec4> rows_;    // of all copies, map by map
    std::vector<glm::vec4> asides_;  // like rows_, shifted to the map's position in the batch
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
