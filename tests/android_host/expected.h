#pragma once
// What a window has to show: the same view, drawn without a window.

#include <string>

#include "app/viewer/viewer.h"
#include "tests/android_host/window.h"

namespace nacre::test {

/// The view without overlay.
/// @param samples a side of a pixel
WindowPicture expectedPicture(const app::PictureDescription& view, std::uint32_t width, std::uint32_t height,
                              std::uint32_t samples);

/// Part of a picture that the overlay may cover: not compared.
struct Covered {
    std::uint32_t width = 0, height = 0;  ///< from the top left
};

struct Difference {
    int pixels = 0, largest = 0, coloured = 0;
    double mean = 0;  ///< over the coloured pixels
    /// Samples gather in halves, and a mean of them is a step aside now and then.
    bool small() const { return pixels <= coloured / 100 && largest <= 4; }
};
Difference measureDifference(const WindowPicture& shown, const WindowPicture& expected, Covered covered);

/// For looking at.
void writePpm(const WindowPicture& picture, const std::string& path);

}  // namespace nacre::test
