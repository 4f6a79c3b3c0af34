#pragma once
// Pictures in 8 bits per channel.

#include <cstdint>
#include <vector>

#include "engine/results.h"

namespace nacre {

/// A picture for files and screens: sRGB code values, 4 bytes per pixel with straight alpha, or 3 over white.
struct CodedPicture {
    std::uint32_t width = 0, height = 0;
    bool alpha = false;
    std::vector<std::uint8_t> bytes;

    std::size_t channels() const { return alpha ? 4 : 3; }
};

/// @param alpha  whether to keep alpha
CodedPicture coded(const Picture& picture, bool alpha);

}  // namespace nacre
