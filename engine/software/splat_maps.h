#pragma once
// Depth maps of a bake by compute: an invocation per primitive and map.

#include <array>
#include <vector>

#include "engine/gpu/resources.h"
#include "engine/software/software.h"

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
    /// What a batch draws. A submission may have several.
    struct Batch {
        gpu::Buffer rows, calls;
        std::uint32_t items = 0, copies = 1;  ///< copies per map
    };
    static constexpr std::size_t kMostBatches = 8;  ///< of a submission
    void record(gpu::PassContext& context, const Batch& batch, std::uint64_t first, std::uint64_t end) const;

    const gpu::Device& device_;
    const passes::SceneBuffers& scene_;
    std::uint32_t pixels_, apart_, across_;
    double radius_;
    gpu::Buffer heights_;
    std::array<Batch, kMostBatches> batches_;
    std::size_t at_ = 0;                // the current batch
    std::vector<glm::vec4> rows_;       // scratch
    std::vector<std::uint32_t> words_;  // scratch
};

}  // namespace nacre::occlusion
