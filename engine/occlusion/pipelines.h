#pragma once
// The compute pipelines of occlusion bakes, with their layouts: made when first asked for, kept for the bakes to come.
// They depend on what is baked through its number of directions alone.

#include <compare>
#include <cstdint>
#include <map>

#include "engine/device_options.h"
#include "engine/gpu/pipeline.h"

namespace nacre::passes {

class OcclusionPipelines {
public:
    /// What a list entry of the accumulation is.
    enum class Texels : std::uint8_t {
        spheres,
        wholeSpheres,  ///< one value a sphere
        cylinders,
    };
    struct Accumulation {
        Texels texels;
        std::uint32_t batch;  ///< depth maps in the image: 1, 4 or 16
        bool encoded;         ///< these hold encoded depth, not depth itself
        float spread;         ///< of the four pixels asked for a texel, pixels; 0: one is asked
        auto operator<=>(const Accumulation&) const = default;
    };

    /// @param device  outlives this
    explicit OcclusionPipelines(const gpu::Device& device);

    /// Storage buffers of shapes, directions (uniform), texels and sums, and the depth maps.
    const gpu::Layout& accumulateLayout() const { return accumulateLayout_; }
    vk::Pipeline accumulation(const Accumulation& key);
    /// Storage buffers of sums, words and bytes.
    const gpu::Layout& finishLayout() const { return finishLayout_; }
    vk::Pipeline finish();
    /// Storage buffers of shapes, views and maps.
    const gpu::Layout& splatLayout() const { return splatLayout_; }
    vk::Pipeline splatting(bool cylinders);
    /// Of the depth maps.
    vk::Sampler sampler() const { return *sampler_; }

private:
    const gpu::Device& device_;
    gpu::Layout accumulateLayout_, finishLayout_, splatLayout_;
    vk::raii::Sampler sampler_;
    std::map<Accumulation, vk::raii::Pipeline> accumulations_;
    vk::raii::Pipeline finish_{nullptr}, sphereSplats_{nullptr}, cylinderSplats_{nullptr};
};

/// Maps in a row of the image of a batch.
constexpr std::uint32_t mapsAcross(std::uint32_t batch) { return batch > 4 ? 4 : batch > 1 ? 2 : 1; }

}  // namespace nacre::passes
