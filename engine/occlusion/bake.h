#pragma once
// Bakes ambient occlusion (paper section 4): depth maps of the molecule from many directions, batch by batch, each
// followed by one dispatch over the atlas texels that light can reach.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/gpu/execute.h"
#include "engine/gpu/resources.h"
#include "engine/occlusion/copies.h"
#include "engine/occlusion/depth_maps.h"
#include "engine/occlusion/finished_occlusion.h"
#include "engine/occlusion/open_texels.h"

namespace nacre::occlusion {

struct BakeOptions {
    int directions = 128;
    std::uint64_t budgetBytes = 64ull << 20;  ///< device memory of everything that the bake holds
    OcclusionMaps path = OcclusionMaps::encoded;
    std::uint32_t detail = 32;  ///< texels across a sphere's patch, at most
};

class Bake {
public:
    /// Everything that a bake needs; no light is asked for yet, and the atlas says so: all is open.
    /// Scene and representation outlive the bake.
    /// @throws Error if even one value a sphere does not fit the budget
    Bake(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
         const BakeOptions& options);

    /// A bake that is done: what was left of one with the same options of the same representation.
    Bake(const gpu::Device& device, gpu::Executor& executor, const passes::SceneBuffers& scene,
         const Representation& representation, const BakeOptions& options, const FinishedOcclusion& finished);

    /// Renders the depth maps of the next directions, at most one batch, and adds them up; those of one model, where
    /// models do not occlude each other: of that which is farthest behind.
    /// @param most  directions at most
    void step(gpu::Executor& executor, std::uint32_t most = DepthMaps::kMostPerBatch);
    /// Sums -> atlas, for the directions done so far.
    void finish(gpu::Executor& executor);

    const gpu::Image& atlas() const { return atlas_; }
    /// Of the finished atlas, where shaders interpolate it themselves and it fits the budget; else null.
    vk::BufferView cells() const { return *cellTexels_; }
    const OcclusionLayout& layout() const { return layout_; }
    const DepthMaps& maps() const { return maps_; }
    /// Those that every model has had.
    int directionsDone() const;
    int directions() const { return static_cast<int>(directions_.size()); }
    /// Directions of all models together: those that were taken, and all that there are.
    std::uint64_t mapsDone() const;
    std::uint64_t mapsInAll() const { return doneOf_.size() * directions_.size(); }
    bool complete() const { return mapsDone() == mapsInAll(); }
    std::uint64_t bytes() const;
    std::size_t texels() const { return texelCount_; }
    /// Texels times directions that were asked so far: the bake's work.
    std::uint64_t asked() const { return asked_; }
    /// The texels of the atlas as finish() wrote them; only before release().
    std::vector<std::uint8_t> atlasTexels() const;
    /// Drops all but the atlas, when no more steps are wanted.
    void release();
    /// For each sphere whether any direction saw any of it; known after release().
    const std::vector<bool>& seenSpheres() const { return seenSpheres_; }

private:
    OcclusionLayout chooseLayout(const Representation& representation, std::uint64_t budgetBytes, std::uint32_t detail,
                                 OpenTexels& open);
    void makeBuffers(const OpenTexels& open);
    layout::OcclusionConstants constants() const;
    /// Sticks throw thin shadows, which one tap misses: four stand for the directions between two of the set, which are
    /// the farther apart the fewer they are. @returns pixels; 0: one tap
    float spreadOfTaps() const;
    void dropDeepTexels();
    void makeCells(std::span<const std::uint8_t> texels);
    void recordAccumulation(gpu::PassContext& context, graph::Image maps, std::uint32_t batch, std::uint32_t model);
    vk::DescriptorSet accumulationSet(gpu::PassContext& context, graph::Image maps, std::uint32_t group);
    void writeDirections(std::span<const glm::dmat3> frames, int first);
    std::size_t texelsOf(std::uint32_t model) const;

    const gpu::Device& device_;
    const passes::SceneBuffers& scene_;
    std::vector<glm::dmat3> directions_;
    DepthMaps maps_;
    OcclusionLayout layout_;
    OcclusionCopies copies_;
    std::size_t texelCount_ = 0, wordCount_ = 0;  // of the list, of the atlas
    std::vector<std::uint32_t> firstOfSphere_;
    std::vector<bool> seenSpheres_;
    std::vector<int> doneOf_;  // directions, by model
    std::uint64_t asked_ = 0;
    gpu::Buffer batchDirections_, list_, sums_, words_, bytes_;
    gpu::Image atlas_;
    std::uint64_t budgetBytes_ = 0;
    gpu::Buffer cells_;
    vk::raii::BufferView cellTexels_{nullptr};
    bool atlasDefined_ = false;
};

}  // namespace nacre::occlusion
