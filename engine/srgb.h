#pragma once
// Converts between linear light and the sRGB code values of files (IEC 61966-2-1).

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace nacre {

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

/// toByte(linearToSrgb()), by a table: a power per channel takes a fifth of a small picture's time.
class LinearBytes {
public:
    LinearBytes() {
        // Finds where each code begins by bisection over floats from 0 to 1, whose bits have the same order.
        std::uint32_t below = 0;
        for (std::uint32_t code = 1; code < 256; ++code) {
            std::uint32_t above = kOne;
            while (above - below > 1) {
                const std::uint32_t middle = below + (above - below) / 2;
                (toByte(linearToSrgb(std::bit_cast<float>(middle))) < code ? below : above) = middle;
            }
            begins_[code] = std::bit_cast<float>(above);
        }
        begins_[256] = std::numeric_limits<float>::infinity();
        std::uint32_t code = 0;
        for (std::uint32_t i = 0; i < kCells; ++i) {
            const float first = std::bit_cast<float>((i + kFirstCell) << kShift);
            while (begins_[code + 1] <= first) ++code;
            codes_[i] = static_cast<std::uint8_t>(code);
        }
    }
    std::uint8_t operator()(float linear) const {
        // No branches: a picture's colours would mispredict them. NaN maps to 0; a cell holds at most one beginning.
        const float within = std::min(std::max(kDark, linear), kBelowOne);
        const std::uint32_t code = codes_[(std::bit_cast<std::uint32_t>(within) >> kShift) - kFirstCell];
        return static_cast<std::uint8_t>(code + (within >= begins_[code + 1] ? 1 : 0));
    }

private:
    static constexpr std::uint32_t kShift = 16, kOne = std::bit_cast<std::uint32_t>(1.0f);
    static constexpr float kDark = 0x1p-13f;                            // below, all is code 0
    static constexpr float kBelowOne = std::bit_cast<float>(kOne - 1);  // code 255
    static constexpr std::uint32_t kFirstCell = std::bit_cast<std::uint32_t>(kDark) >> kShift;
    static constexpr std::uint32_t kCells = (kOne >> kShift) - kFirstCell;
    std::array<float, 257> begins_{};
    std::array<std::uint8_t, kCells> codes_{};
};

/// toByte(linearToSrgb(linear)).
inline std::uint8_t linearToByte(float linear) {
    static const LinearBytes bytes;
    return bytes(linear);
}

/// 0..1 to 0..65535, rounded to nearest.
inline std::uint16_t toWord(float value) {
    if (!(value > 0.0f)) return 0;
    return value >= 1.0f ? std::uint16_t{65535} : static_cast<std::uint16_t>(value * 65535.0f + 0.5f);
}

/// One premultiplied linear pixel as sRGB code values: three over white, or four with straight alpha. Programs
/// composite code values, not light: alpha and colour are chosen so that this comes nearest to the pixel over black and
/// over white. Exact for grey pixels.
template <typename Code>
void codePixel(const float* pixel, bool alpha, Code* out) {
    constexpr bool kWords = sizeof(Code) == 2;
    constexpr float kMost = kWords ? 65535.0f : 255.0f;
    const auto code = [](float value) {
        if constexpr (kWords)
            return toWord(value);
        else
            return toByte(value);
    };
    const auto coded = [&](float linear) {
        if constexpr (kWords)
            return code(linearToSrgb(linear));
        else
            return linearToByte(linear);
    };
    const float through = 1.0f - std::clamp(pixel[3], 0.0f, 1.0f);
    if (!alpha) {
        for (int i = 0; i < 3; ++i) out[i] = coded(pixel[i] + through);
        return;
    }
    if (through >= 1.0f || through <= 0.0f) {
        for (int i = 0; i < 3; ++i) out[i] = through > 0.0f ? Code{0} : coded(pixel[i]);
        out[3] = through > 0.0f ? Code{0} : code(1.0f);
        return;
    }
    float onBlack[3], onWhite[3], between = 0.0f;
    for (int i = 0; i < 3; ++i) {
        onBlack[i] = linearToSrgb(pixel[i]);
        onWhite[i] = linearToSrgb(pixel[i] + through);
        between += (onWhite[i] - onBlack[i]) / 3.0f;
    }
    out[3] = code(1.0f - between);
    const float share = static_cast<float>(out[3]) / kMost, rest = 1.0f - share;
    for (int i = 0; i < 3; ++i) out[i] = share > 0.0f ? code(0.5f * (onBlack[i] + onWhite[i] - rest) / share) : Code{0};
}

}  // namespace nacre
