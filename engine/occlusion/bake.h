#pragma once
// Bakes ambient occlusion (paper section 4): depth maps of the molecule from many directions, in batches, each followed
// by one dispatch over the atlas texels that light can reach.

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

/// Maximum work of one submission. One unit: one texel tested for one direction.
struct Allowance {
    std::uint32_t directions = DepthMaps::kMostPerBatch;
    double units = std::numeric_limits<double>::infinity();
};

class Bake {
public:
    /// Prepares a bake. Before the first direction the atlas is fully open. Scene and representation must outlive the
    /// bake.
    /// @throws Error as prepareBake
    Bake(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
         const BakeOptions& options)
        : Bake(device, scene, representation, options, prepareBake(device.caps(), representation, options)) {}
    Bake(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
         const BakeOptions& options, BakePreparation&& preparation);

    /// A finished bake from a stored result. The options and representation must be those of the stored bake.
    Bake(const gpu::Device& device, gpu::Executor& executor, const passes::SceneBuffers& scene,
         const Representation& representation, const BakeOptions& options, const FinishedOcclusion& finished);

    /// Renders the depth maps of the next directions (at most one batch) and adds them up. If models do not occlude
    /// each other, selects the model with the fewest directions so far.
    /// @param most  maximum of directions
    void step(gpu::Executor& executor, std::uint32_t most = DepthMaps::kMostPerBatch);
    /// Converts the sums of the directions done so far to the atlas.
    void finish(gpu::Executor& executor);

    /// Compiles the pipelines of the next steps on the worker thread, if there is one.
    /// @param least, most  work of single submissions
    void wantPipelines(gpu::Executor& executor, const Allowance& least, const Allowance& most) const;

    // For callers that submit the work themselves, in small parts. Declares the next part: as many directions as
    // allowed or, if not even one is allowed, some of its primitives or texels. Run it, then call sliceDone() before
    // any other call.
    // @returns units of work; 0: nothing is left
    double declareSlice(graph::Graph& g, gpu::Imports& imports, const Allowance& allowance);
    /// Call when the declared part has run.
    void sliceDone();
    /// Call instead when the part is recorded, and submissionDone() when it has run.
    /// @returns whether declareFinish() may follow in the same submission: it was the last part, and the host need not
    /// read the sums first
    bool sliceRecorded();
    void submissionDone();
    /// Units of declareFinish().
    double finishUnits() const { return static_cast<double>(wordCount_); }
    /// Units of the smallest remaining part.
    double leastUnits() const;
    /// Whether all started directions are added up.
    bool betweenSteps() const { return !work_; }
    void declareFinish(graph::Graph& g, gpu::Imports& imports);

    const gpu::Image& atlas() const { return atlas_; }
    /// Whether the atlas holds a result. Submitted work counts as done.
    bool shows() const { return atlasDefined_; }
    /// A view of the finished atlas, if shaders interpolate it themselves and it fits the budget; else null.
    vk::BufferView cells() const { return *cellTexels_; }
    /// Whether the atlas has bounced light as well.
    bool bounced() const { return bounced_; }
    const OcclusionLayout& layout() const { return layout_; }
    const DepthMaps& maps() const { return maps_; }
    /// Directions done for every model.
    int directionsDone() const;
    int directions() const { return static_cast<int>(directions_.size()); }
    /// Directions summed over all models: done, and total.
    std::uint64_t mapsDone() const;
    std::uint64_t mapsInAll() const { return doneOf_.size() * directions_.size(); }
    bool complete() const { return mapsDone() == mapsInAll(); }
    std::uint64_t bytes() const;
    std::size_t texels() const { return texelCount_; }
    /// Work of the bake: texels x directions.
    std::uint64_t asked() const { return asked_; }
    /// The atlas texels that finish() wrote. Call before release().
    std::vector<std::uint8_t> atlasTexels() const;
    /// Drops everything except the atlas. No steps can follow.
    void release();
    /// For each sphere, whether any direction saw any of it. Available after release().
    const std::vector<bool>& seenSpheres() const { return seenSpheres_; }

private:
    /// Directions of one group of copies; a multiple of the required uniform buffer offset alignment, 256.
    static constexpr vk::DeviceSize kGroupBytes = sizeof(layout::Direction) * DepthMaps::kMostPerBatch;
    static constexpr graph::State kComputeBuffer{
        VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT, {}};

    /// Directions in progress.
    struct Work {
        std::uint32_t model = 0;
        int first = 0;  ///< index of the direction
        std::uint32_t count = 0;
        std::uint64_t instances = 0, drawn = 0;  ///< per map
        std::size_t texels = 0, asked = 0;
        std::uint64_t drawnThen = 0;  ///< `drawn` after the slice has run
        std::size_t askedThen = 0;

        bool ends() const { return drawnThen == instances && askedThen == texels; }
    };
    /// Maps in a batch of this many directions.
    static std::uint32_t batchFor(std::uint32_t directions) { return directions > 4 ? 16 : directions > 1 ? 4 : 1; }
    Work nextWork(const Allowance& allowance) const;
    std::uint64_t mostInstances(const Allowance& allowance) const;
    static double countUnits(const Work& work);
    /// Whether whole directions are drawn at once, not in parts.
    bool drawnAtOnce(const Work& work, const Allowance& allowance) const;
    void makeBuffers(OpenTexels& open);
    bool advance();
    void readSums(graph::Graph& g, gpu::Imports& imports, graph::Buffer sums) const;
    const gpu::Buffer& hostSums() const { return apart_ ? sumsRead_ : sums_; }
    layout::OcclusionConstants constants() const;
    Accumulation accumulation(OcclusionCopies::Run::Of of, std::uint32_t batch) const;
    /// Pixels between the taps of sticks; 0: one tap. A single tap misses the thin shadows of sticks. Four taps cover
    /// the space between neighbouring directions, which is larger with fewer directions.
    float spreadOfTaps() const;
    /// As spreadOfTaps(), for cartoons, which are as thin.
    float spreadOfVertices() const;
    float widestTaps() const;
    void dropDeepTexels();
    void makeCells(std::span<const std::uint8_t> texels);
    /// @param maps  null: the heights of the tile path
    void recordAccumulation(gpu::PassContext& context, std::optional<graph::Image> maps, std::uint32_t batch,
                            const Work& work);
    vk::DescriptorSet accumulationSet(gpu::PassContext& context, std::optional<graph::Image> maps, std::uint32_t group);
    void writeDirections(std::span<const glm::dmat3> frames, int first);
    std::size_t countTexels(std::uint32_t model) const;

    const gpu::Device& device_;
    const passes::SceneBuffers& scene_;
    std::vector<glm::dmat3> directions_;
    DepthMaps maps_;
    OcclusionLayout layout_;
    OcclusionCopies copies_;
    std::size_t texelCount_ = 0, wordCount_ = 0;  // list entries; atlas words
    std::vector<std::uint32_t> firstOfSphere_;
    std::vector<bool> seenSpheres_;
    std::vector<int> doneOf_;  // directions per model
    std::uint64_t asked_ = 0;
    std::optional<Work> work_;
    gpu::Buffer batchDirections_, list_, sums_, words_, bytes_;
    // Where memory that the host reads fast is not the device's own, the device has list, words and sums in its own,
    // and the host reads copies.
    bool apart_ = false, deepTexelsDue_ = false;
    gpu::Buffer sumsRead_;
    std::vector<std::uint32_t> hostList_;
    std::vector<AtlasWord> hostWords_;
    bool narrow_ = false;  // directions are layout::NarrowDirections
    vk::raii::BufferView directionTexels_{nullptr};
    gpu::Image atlas_;
    std::uint64_t budgetBytes_ = 0;
    gpu::Buffer cells_;
    vk::raii::BufferView cellTexels_{nullptr};
    bool atlasDefined_ = false, bounced_ = false;
};

}  // namespace nacre::occlusion
