#pragma once
// The ladder of encoded depth: formats that a device may blend with MIN, and how depth is written into them
// (shaders/common/encoding.glsl has the arithmetic).

#include <vulkan/vulkan_core.h>

#include <span>
#include <string_view>

#include "engine/device_options.h"

namespace nacre::graph {

struct EncodedFormat {
    EncodedDepth rung = EncodedDepth::r32f;
    std::string_view name = "r32f";
    VkFormat format = VK_FORMAT_R32_SFLOAT;
    int channels = 1;
    int steps = 0;          ///< codes of a channel, less one; 0: the channel is the depth
    float farthest = 1.0f;  ///< the value that MIN never keeps
    /// Nothing is blended: fragments read their own attachment in raster order.
    bool ordered = false;

    /// Depths that it tells apart; 2^24 for a float, whose steps are finer near 0.
    int levels() const { return steps == 0 ? 1 << 24 : channels * steps; }
    /// Whether the rung is so coarse that the depth buffer must settle what it leaves open.
    bool settles() const { return levels() < 100000; }
};

/// Every rung, finest first.
std::span<const EncodedFormat> encodedFormats();

/// The finest rung by raster order: for devices that do not blend it, or by a shader.
inline EncodedFormat encodedInOrder() {
    EncodedFormat format = encodedFormats().front();
    format.ordered = true;
    return format;
}

}  // namespace nacre::graph
