#pragma once
// Between linear light and the sRGB code values of files (IEC 61966-2-1).

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace nacre::app {

inline float linearToSrgb(float linear) {
    if (!(linear > 0.0f)) return 0.0f;  // also NaN
    if (linear >= 1.0f) return 1.0f;
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

inline float srgbToLinear(float coded) {
    if (!(coded > 0.0f)) return 0.0f;
    if (coded >= 1.0f) return 1.0f;
    return coded <= 0.04045f ? coded / 12.92f : std::pow((coded + 0.055f) / 1.055f, 2.4f);
}

/// 0..1 to 0..255, rounded to nearest.
inline std::uint8_t toByte(float value) {
    if (!(value > 0.0f)) return 0;
    return value >= 1.0f ? std::uint8_t{255} : static_cast<std::uint8_t>(value * 255.0f + 0.5f);
}

/// 0..1 to 0..65535, rounded to nearest.
inline std::uint16_t toWord(float value) {
    if (!(value > 0.0f)) return 0;
    return value >= 1.0f ? std::uint16_t{65535} : static_cast<std::uint16_t>(value * 65535.0f + 0.5f);
}

/// One premultiplied linear pixel as sRGB code values: four with straight alpha, or three over white.
template <typename Code>
void codePixel(const float* pixel, bool alpha, Code* out) {
    const auto code = [](float value) {
        if constexpr (sizeof(Code) == 2)
            return toWord(value);
        else
            return toByte(value);
    };
    const float a = std::clamp(pixel[3], 0.0f, 1.0f);
    for (int i = 0; i < 3; ++i) {
        const float light = alpha ? (a > 0.0f ? pixel[i] / a : 0.0f) : pixel[i] + (1.0f - a);
        out[i] = code(linearToSrgb(light));
    }
    if (alpha) out[3] = code(a);
}

}  // namespace nacre::app
