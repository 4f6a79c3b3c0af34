#pragma once
// Bakes ambient occlusion (paper section 4): depth maps of the molecule from many directions, batch by batch, each
// followed by one dispatch over the atlas texels.

#include <cstdint>
#include <vector>

#include "engine/gpu/resources.h"
#include "engine/graph/execute.h"
#include "engine/passes/geometry.h"
#include "engine/scene/camera.h"
#include "engine/scene/occlusion_layout.h"

namespace nacre::passes {

class OcclusionBake {
public:
    /// Everything that a bake of `directions` directions needs; no work is done yet.
    /// @param budgetBytes device memory for atlas, sums, texel list and depth maps
    /// @throws Error if it does not fit
    OcclusionBake(const gpu::Device& device, Geometry& geometry, Nearest nearest, const SceneBuffers& scene,
                  const Representation& representation, const OcclusionLayout& layout, int directions);

    /// Renders the depth maps of the next directions and adds them up. False when there was nothing left to do.
    bool step(graph::Executor& executor);
    /// Sums -> atlas, for the directions done so far (at least one).
    void finish(graph::Executor& executor);

    const gpu::Image& atlas() const { return atlas_; }
    int directionsDone() const { return done_; }

private:
    layout::OcclusionConstants constants(std::uint32_t first, std::uint32_t count) const;
    void recordMaps(graph::PassContext& context, Writes writes) const;
    void recordAccumulation(graph::PassContext& context, graph::Image maps) const;
    void dispatch(const vk::raii::CommandBuffer& commands, std::uint32_t invocations) const;

    const gpu::Device& device_;
    Geometry& geometry_;
    Nearest nearest_;
    const SceneBuffers& scene_;
    const Representation& representation_;
    OcclusionLayout layout_;
    std::vector<glm::dmat3> directions_;
    double radius_, meanRadius_ = 0;
    std::uint32_t mapPixels_, perRow_, texels_ = 0;
    int done_ = 0, batch_ = 0;
    gpu::Buffer rows_, list_, sums_, words_;
    gpu::Image atlas_;
    bool atlasDefined_ = false;
    gpu::Layout accumulateLayout_, finishLayout_;
    vk::raii::Pipeline accumulate_{nullptr}, finish_{nullptr};
    vk::raii::Sampler sampler_{nullptr};
};

}  // namespace nacre::passes
