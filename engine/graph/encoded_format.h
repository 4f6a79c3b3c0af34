#pragma once
// The formats for encoded depth, in order of precision: formats that a device may blend with MIN, and how depth is
// written into them (arithmetic: shaders/common/encoding.glsl).

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
    int steps = 0;          ///< codes per channel, less one; 0: the channel is the depth
    float farthest = 1.0f;  ///< clear value, larger than any encoded depth
    /// No blending: fragments read their own attachment in raster order.
    bool ordered = false;
    friend bool operator==(const EncodedFormat&, const EncodedFormat&) = default;

    /// Number of distinct depths; 2^24 for a float, whose steps are finer near 0.
    int levels() const { return steps == 0 ? 1 << 24 : channels * steps; }
    /// Whether the format is so coarse that the depth buffer must resolve ties.
    bool settles() const { return levels() < 100000; }
};

/// Every format, finest first.
std::span<const EncodedFormat> encodedFormats();

/// The finest format with raster order, for devices that cannot blend it, or only by a shader.
inline EncodedFormat encodedInOrder() {
    EncodedFormat format = encodedFormats().front();
    format.ordered = true;
    return format;
}

}  // namespace nacre::graph
