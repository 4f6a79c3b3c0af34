#include "app/apple/label_colors.h"

#include <algorithm>

#include "app/shared/srgb.h"

namespace nacre::app {
namespace {

constexpr LabelColor kBlack{0, 0, 0, 1}, kWhite{1, 1, 1, 1};
constexpr float kSheer = 0.86f;  // whatever is behind, white text keeps 11 to 1, black text 14 to 1

/// Relative luminance (WCAG 2.1, "relative luminance"; the coefficients are those of ITU-R BT.709).
double luminance(const LabelColor& c) {
    return 0.2126 * srgbToLinear(c[0]) + 0.7152 * srgbToLinear(c[1]) + 0.0722 * srgbToLinear(c[2]);
}

}  // namespace

double contrastRatio(const LabelColor& a, const LabelColor& b) {
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

LabelColors labelColors(const LabelColor& background, bool moreContrast) {
    LabelColor behind{};
    for (std::size_t c = 0; c < 3; ++c)  // white shines through what is not opaque
        behind[c] = background[c] * background[3] + (1 - background[3]);
    behind[3] = 1;
    const bool dark = contrastRatio(behind, kWhite) > contrastRatio(behind, kBlack);
    LabelColors colors;
    colors.ground = dark ? kWhite : kBlack;
    colors.text = dark ? kBlack : kWhite;
    colors.bare = colors.ground;
    if (!moreContrast) colors.ground[3] = kSheer;
    return colors;
}

}  // namespace nacre::app
