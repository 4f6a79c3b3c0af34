#pragma once
// Bakes ambient occlusion (paper section 4): depth maps of the molecule from many directions, batch by batch, each
// followed by one dispatch over the atlas texels that light can reach.

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "engine/gpu/execute.h"
#include "engine/gpu/resources.h"
#include "engine/occlusion/bake_preparation.h"
#include "engine/occlusion/depth_maps.h"
#include "engine/occlusion/finished_occlusion.h"

namespace nacre::occlusion {

/// What one submission takes on at most. A unit is a texel that is asked about a direction.
struct Allowance {
    std::uint32_t directions = DepthMaps::kMostPerBatch;
    double units = std::numeric_limits<double>::infinity();
};

class Bake {
public:
    /// Everything that a bake needs; no light is asked for yet, and the atlas says so: all is open.
    /// Scene and representation outlive the bake.
    /// @throws Error as prepareBake
    Bake(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
         const BakeOptions& options)
        : Bake(device, scene, representation, options, prepareBake(device.caps(), representation, options)) {}
    Bake(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
         const BakeOptions& options, BakePreparation&& preparation);

    /// A bake that is done: what was left of one with the same options of the same representation.
    Bake(const gpu::Device& device, gpu::Executor& executor, const passes::SceneBuffers& scene,
         const Representation& representation, const BakeOptions& options, const FinishedOcclusion& finished);

    /// Renders the depth maps of the next directions, at most one batch, and adds them up; those of one model, where
    /// models do not occlude each other: of that which is farthest behind.
    /// @param most  directions at most
    void step(gpu::Executor& executor, std::uint32_t most = DepthMaps::kMostPerBatch);
    /// Sums -> atlas, for the directions done so far.
    void finish(gpu::Executor& executor);

    /// Has the pipelines of what is to come made ahead, where somebody makes those.
    /// @param least, most  what single submissions will take on
    void wantPipelines(gpu::Executor& executor, const Allowance& least, const Allowance& most) const;

    // The same for who submits himself, in parts that a submission can take.
    /// Declares the next part: of as many directions as are allowed or, where not even one is, some of its primitives
    /// or texels. It is to run before anything else of the bake is called, and sliceDone() then.
    /// @returns its units; 0: nothing is left
    double declareSlice(graph::Graph& g, gpu::Imports& imports, const Allowance& allowance);
    /// What was declared has run.
    void sliceDone();
    /// Units of the least part that is left.
    double leastUnits() const;
    /// Whether all directions that were begun are added up.
    bool betweenSteps() const { return !work_; }
    void declareFinish(graph::Graph& g, gpu::Imports& imports);

    const gpu::Image& atlas() const { return atlas_; }
    /// Whether the atlas holds anything, or will by what was submitted.
    bool shows() const { return atlasDefined_; }
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
    /// Directions of one group of copies; a multiple of the floor's uniform buffer offset alignment, 256.
    static constexpr vk::DeviceSize kGroupBytes = sizeof(layout::Direction) * DepthMaps::kMostPerBatch;
    static constexpr graph::State kComputeBuffer{
        VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT, {}};

    /// Directions that are under way, and how far they are.
    struct Work {
        std::uint32_t model = 0;
        int first = 0;  ///< direction
        std::uint32_t count = 0;
        std::uint64_t instances = 0, drawn = 0;  ///< on each map
        std::size_t texels = 0, asked = 0;
        std::uint64_t drawnThen = 0;  ///< when the slice has run
        std::size_t askedThen = 0;
    };
    /// Maps in a batch that has so many directions.
    static std::uint32_t batchFor(std::uint32_t directions) { return directions > 4 ? 16 : directions > 1 ? 4 : 1; }
    Work nextWork(const Allowance& allowance) const;
    std::uint64_t mostInstances(const Allowance& allowance) const;
    static double unitsOf(const Work& work);
    /// Or in parts.
    bool drawnAtOnce(const Work& work, const Allowance& allowance) const;
    void makeBuffers(const OpenTexels& open);
    layout::OcclusionConstants constants() const;
    Accumulation accumulation(OcclusionCopies::Run::Of of, std::uint32_t batch) const;
    /// Sticks throw thin shadows, which one tap misses: four stand for the directions between two of the set, which are
    /// the farther apart the fewer they are. @returns pixels; 0: one tap
    float spreadOfTaps() const;
    /// Cartoons are as thin.
    float spreadOfVertices() const;
    float widestTaps() const;
    void dropDeepTexels();
    void makeCells(std::span<const std::uint8_t> texels);
    /// @param first, end  of the model's texels
    /// @param maps  none: they are the heights that tiles left
    void recordAccumulation(gpu::PassContext& context, std::optional<graph::Image> maps, std::uint32_t batch,
                            std::uint32_t model, std::size_t first, std::size_t end);
    vk::DescriptorSet accumulationSet(gpu::PassContext& context, std::optional<graph::Image> maps, std::uint32_t group);
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
    std::optional<Work> work_;
    gpu::Buffer batchDirections_, list_, sums_, words_, bytes_;
    bool narrow_ = false;  // directions are layout::NarrowDirections
    vk::raii::BufferView directionTexels_{nullptr};
    gpu::Image atlas_;
    std::uint64_t budgetBytes_ = 0;
    gpu::Buffer cells_;
    vk::raii::BufferView cellTexels_{nullptr};
    bool atlasDefined_ = false;
};

}  // namespace nacre::occlusion
