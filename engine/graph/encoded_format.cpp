#include "engine/graph/encoded_format.h"

#include <array>

namespace nacre::graph {

std::span<const EncodedFormat> encodedFormats() {
    // 61,439 is the number of normal halves of both signs, in order; 65,504 is the last one.
    static constexpr std::array kLadder{
        EncodedFormat{EncodedDepth::r32f, "r32f", VK_FORMAT_R32_SFLOAT, 1, 0, 1.0f, false},
        EncodedFormat{EncodedDepth::rgba16f, "rgba16f", VK_FORMAT_R16G16B16A16_SFLOAT, 4, 61439, 65504.0f, false},
        EncodedFormat{EncodedDepth::rg16f, "rg16f", VK_FORMAT_R16G16_SFLOAT, 2, 61439, 65504.0f, false},
        EncodedFormat{EncodedDepth::a2b10g10r10, "a2b10g10r10", VK_FORMAT_A2B10G10R10_UNORM_PACK32, 3, 1023, 1.0f,
                      false},
        EncodedFormat{EncodedDepth::rgba8, "rgba8", VK_FORMAT_R8G8B8A8_UNORM, 4, 255, 1.0f, false}};
    return kLadder;
}

}  // namespace nacre::graph
