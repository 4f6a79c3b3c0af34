#include "engine/coded_picture.h"

#include <cstring>

#include "engine/srgb.h"

namespace nacre {

CodedPicture coded(const Picture& picture, bool alpha) {
    CodedPicture codes{picture.width, picture.height, alpha, {}};
    const std::size_t channels = codes.channels(), pixels = std::size_t{picture.width} * picture.height;
    codes.bytes.resize(channels * pixels);
    const float* from = picture.rgba.data();
    std::uint8_t* to = codes.bytes.data();
    for (std::size_t i = 0; i < pixels; ++i, from += 4, to += channels) {
        // Backgrounds have long runs of one colour, and coding a colour takes up to six powers.
        if (i > 0 && std::memcmp(from, from - 4, 4 * sizeof(float)) == 0)
            std::memcpy(to, to - channels, channels);
        else
            codePixel(from, alpha, to);
    }
    return codes;
}

}  // namespace nacre
