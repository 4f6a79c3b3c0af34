#pragma once
// Depth maps of a bake by compute: an invocation per primitive and map.

#include <vector>

#include "engine/gpu/resources.h"
#include "engine/tiles/tile_maps.h"

namespace nacre::occlusion {

class SplatMaps final : public TileMaps {
public:
    SplatMaps(const gpu::Device& device, const passes::SceneBuffers& scene, std::uint32_t pixels, double radius,
              std::uint32_t across);

    void begin(std::span<const passes::PlacedCopies> maps) override;
    graph::Buffer declare(graph::Graph& g, gpu::Imports& imports, std::uint64_t first, std::uint64_t end) override;
    void wantPipelines(gpu::PipelineContext& context) const override;
    graph::Buffer import(graph::Graph& g, gpu::Imports& imports) const override;
    const gpu::Buffer& buffer() const override { return heights_; }
    vk::BufferView texels() const override { return nullptr; }
    std::uint32_t pitch() const override { return apart_ * across_; }
    std::uint32_t apart() const override { return apart_; }

private:
    void record(gpu::PassContext& context, std::uint64_t first, std::uint64_t end) const;

    const gpu::Device& device_;
    const passes::SceneBuffers& scene_;
    std::uint32_t pixels_, apart_, across_;
    double radius_;
    gpu::Buffer heights_, rows_, calls_;
    std::uint32_t items_ = 0, copies_ = 1;  // of the batch; copies per map
    std::vector<glm::vec4> rowsOfMaps_;     // scratch
    std::vector<std::uint32_t> words_;      // scratch
};

}  // namespace nacre::occlusion
