#pragma once
// Colours of text over a picture, by the contrast ratio of the W3C's WCAG 2.1 (1.4.3, 1.4.6).

#include <array>

namespace nacre::app {

using LabelColor = std::array<float, 4>;  ///< sRGB-coded, straight alpha, 0..1

struct LabelColors {
    LabelColor ground, text;
    LabelColor bare;  ///< for text or symbols right on the picture's background
};

/// From 1 (the same) to 21 (black and white), of two opaque colours.
double contrastRatio(const LabelColor& a, const LabelColor& b);

/// A ground that stands out from the picture's background, and text of at least 7 to 1 over it, whatever shines
/// through.
/// @param moreContrast the user asked the system for it: opaque, and 15 to 1
LabelColors labelColors(const LabelColor& background, bool moreContrast);

}  // namespace nacre::app
