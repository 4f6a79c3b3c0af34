#pragma once
// Depth maps of the molecule from a batch of directions, side by side in one image, by the path that suits the device.

#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "engine/device_options.h"
#include "engine/gpu/execute.h"
#include "engine/gpu/resources.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/camera.h"

namespace nacre::occlusion {

class DepthMaps {
public:
    static constexpr std::uint32_t kMostPerBatch = 16;

    /// @param path  not `automatic`
    /// @param representation  outlives this
    /// @param budgetBytes  device memory for the maps of one batch; they get smaller until at least one fits
    DepthMaps(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
              OcclusionMaps path, std::uint64_t budgetBytes, std::uint32_t detail = 32);

    /// Sizes of a batch that fit the budget: 1, 4 or 16 maps.
    std::uint32_t perBatch() const { return perBatch_; }
    std::uint32_t pixels() const { return pixels_; }
    std::uint64_t bytes() const;

    /// Models that do not occlude each other, each with maps of its own; 1: all that is drawn is on every map.
    std::uint32_t models() const { return static_cast<std::uint32_t>(runs_.size()); }

    /// Declares the passes that draw a batch of a model, all rotations of `frames`, at most `batch` (1, 4 or 16).
    /// @param frames  kept until the graph has run
    graph::Image declare(graph::Graph& g, gpu::Imports& imports, std::span<const glm::dmat3> frames,
                         std::uint32_t batch, std::uint32_t model);
    /// Whether the maps hold encoded depth, not depth itself.
    bool encoded() const { return path_ == OcclusionMaps::encoded; }
    /// Drops the memory of the maps.
    void release() { splats_ = {}; }
    /// The view of one map.
    View view(const glm::dmat3& frame) const;

private:
    /// What is drawn of a model.
    struct Runs {
        std::vector<ModelRun> spheres, cylinders;
    };
    passes::PlacedCopies placed(const glm::dmat3& frame, std::uint32_t model) const;
    layout::ViewConstants constants(const glm::dmat3& frame, std::uint32_t i, std::uint32_t across) const;
    /// Draws every map of a batch by a pass over the scene.
    template <typename Pass>
    graph::Record eachMap(std::span<const glm::dmat3> frames, std::uint32_t across, std::uint32_t model,
                          Pass&& pass) const;
    passes::PlacedCopies writeViews(std::span<const glm::dmat3> frames, std::uint32_t across,
                                    std::uint32_t model) const;
    void recordSplat(gpu::PassContext& context, graph::Buffer maps, std::span<const glm::dmat3> frames,
                     std::uint32_t across, std::uint32_t model) const;

    const gpu::Device& device_;
    const passes::SceneBuffers& scene_;
    const Representation& representation_;
    OcclusionMaps path_;
    double radius_, meanRadius_ = 0;
    std::uint32_t pixels_ = 0, perBatch_ = 1;
    std::vector<Runs> runs_;  // by model
    gpu::Buffer splats_, views_;
};

}  // namespace nacre::occlusion
