#pragma once
// Depth maps of the molecule from a batch of directions, side by side in one image, by the path that suits the device.

#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "engine/device_options.h"
#include "engine/gpu/execute.h"
#include "engine/gpu/resources.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/camera.h"

namespace nacre::occlusion {

/// How large the maps are, and how many of them are drawn at once. For any thread.
struct DepthMapSizes {
    std::uint32_t pixels = 0, perBatch = 1, bytesPerPixel = 0;
    DepthMapSizes(const gpu::Caps& caps, const Representation& representation, OcclusionMaps path,
                  std::uint64_t budgetBytes, std::uint32_t detail);
    std::uint64_t bytes() const { return std::uint64_t{bytesPerPixel} * pixels * pixels * perBatch; }
};

/// What is drawn of a model on a map: all of it, or some of its instances.
struct MapPart {
    std::uint64_t first = 0, end = ~std::uint64_t{0};
};

class DepthMaps {
public:
    static constexpr std::uint32_t kMostPerBatch = 16;

    /// @param path  not `automatic`
    /// @param representation  outlives this
    /// @param budgetBytes  device memory for the maps of one batch; they get smaller until at least one fits
    DepthMaps(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
              OcclusionMaps path, std::uint64_t budgetBytes, std::uint32_t detail = 32);

    /// Sizes of a batch that fit the budget: 1, 4 or 16 maps.
    std::uint32_t perBatch() const { return sizes_.perBatch; }
    std::uint32_t pixels() const { return sizes_.pixels; }
    std::uint64_t bytes() const { return sizes_.bytes(); }

    /// Models that do not occlude each other, each with maps of its own; 1: all that is drawn is on every map.
    std::uint32_t models() const { return static_cast<std::uint32_t>(runs_.size()); }

    /// Instances of a model's spheres and cylinders, all copies: what is drawn on each map.
    std::uint64_t instances(std::uint32_t model) const;

    /// Declares the passes that draw a batch of a model, all rotations of `frames`, at most `batch` (1, 4 or 16).
    /// @param frames  kept until the graph has run
    graph::Image declare(graph::Graph& g, gpu::Imports& imports, std::span<const glm::dmat3> frames,
                         std::uint32_t batch, std::uint32_t model);
    /// The same of one map in parts, each a graph of its own, one after the other from the first instance to the last.
    void declarePart(graph::Graph& g, gpu::Imports& imports, std::span<const glm::dmat3> frame, std::uint32_t model,
                     std::uint64_t first, std::uint64_t end);
    /// What all parts have drawn, for the graphs that follow.
    graph::Image drawnParts(graph::Graph& g, gpu::Imports& imports) const;
    /// Whether the maps hold encoded depth, not depth itself.
    bool encoded() const { return path_ == OcclusionMaps::encoded; }
    /// Drops the memory of the maps.
    void release() { splats_ = {}, partMap_ = {}, partDepth_ = {}; }
    /// The view of one map.
    View view(const glm::dmat3& frame) const;

private:
    /// What is drawn of a model.
    struct Runs {
        std::vector<ModelRun> spheres, cylinders;
    };
    passes::PlacedCopies placed(const glm::dmat3& frame, std::uint32_t model, MapPart part = {}) const;
    layout::ViewConstants constants(const glm::dmat3& frame, std::uint32_t i, std::uint32_t across) const;
    /// Draws every map of a batch by a pass over the scene.
    template <typename Pass>
    graph::Record eachMap(std::span<const glm::dmat3> frames, std::uint32_t across, std::uint32_t model, MapPart part,
                          Pass&& pass) const;
    passes::PlacedCopies writeViews(std::span<const glm::dmat3> frames, std::uint32_t across, std::uint32_t model,
                                    MapPart part) const;
    void recordSplat(gpu::PassContext& context, graph::Buffer maps, std::span<const glm::dmat3> frames,
                     std::uint32_t across, std::uint32_t model, MapPart part) const;
    void declareSplats(graph::Graph& g, gpu::Imports& imports, graph::Image maps, std::span<const glm::dmat3> frames,
                       std::uint32_t across, std::uint32_t model, MapPart part, bool last);
    void declareDrawn(graph::Graph& g, graph::Image depth, std::optional<graph::Image> maps,
                      std::span<const glm::dmat3> frames, std::uint32_t across, std::uint32_t model,
                      MapPart part) const;
    void makePartImages();

    const gpu::Device& device_;
    const passes::SceneBuffers& scene_;
    const Representation& representation_;
    OcclusionMaps path_;
    DepthMapSizes sizes_;
    double radius_, meanRadius_ = 0;
    std::vector<Runs> runs_;  // by model
    gpu::Buffer splats_, views_;
    gpu::Image partMap_, partDepth_;  // of one direction that is drawn in parts
};

}  // namespace nacre::occlusion
