#pragma once
// Compute passes of occlusion bakes. Their pipelines depend only on the number of directions.

#include <cstdint>

#include "engine/gpu/execute.h"
#include "engine/passes/primitives.h"

namespace nacre::occlusion {

/// Kind of an accumulation list's entry.
enum class Texels : std::uint8_t {
    spheres,
    wholeSpheres,  ///< one value per sphere
    cylinders,
    vertices,
};
struct Accumulation {
    Texels texels{};
    std::uint32_t batch = 1;   ///< depth maps in the image: 1, 4 or 16
    bool encoded = false;      ///< maps hold encoded depth, not depth itself
    bool heights = false;      ///< maps are a buffer of heights
    bool ellipsoids = false;   ///< among the spheres
    bool narrow = false;       ///< directions are layout::NarrowDirections
    std::uint32_t across = 1;  ///< maps per row
    float spread = 0;          ///< distance of the taps per texel, pixels; 0: one tap
    std::uint32_t taps = 4;    ///< 2 or 4, if `spread` is not 0
};

/// Storage buffers: shapes, directions (uniform), texels, sums; and the depth maps as an image or as heights.
const gpu::Layout& accumulationLayout(gpu::PipelineContext& context, bool heights);
/// Whether one invocation handles two texels of a list.
bool asksByPairs(const Accumulation& accumulation);
gpu::ComputePipeline accumulationPipeline(gpu::PipelineContext& context, const Accumulation& accumulation);
/// Storage buffers: sums, words, bytes.
const gpu::Layout& finishLayout(gpu::PipelineContext& context);
gpu::ComputePipeline finishPipeline(gpu::PipelineContext& context);
/// Maps per row of a batch's image.
constexpr std::uint32_t mapsAcross(std::uint32_t batch) { return batch > 4 ? 4 : batch > 1 ? 2 : 1; }

}  // namespace nacre::occlusion
