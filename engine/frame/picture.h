#pragma once
// From what the device wrote to what a caller gets.

#include <array>

#include "engine/results.h"

namespace nacre {

/// The value of an sRGB-coded channel in linear light; both 0..1. IEC 61966-2-1.
float linearFromSrgb(float coded);

/// What of the device's pixels is a picture.
struct ResolvedPart {
    std::uint32_t rowPixels;  ///< in a row of the device's
    std::uint32_t n;          ///< n x n of them are one of the picture
    PictureRect rect;         ///< of the picture's pixels that are wanted
    bool counted = false;     ///< as pixels of the picture that are covered, and not as samples
};

/// Averages in linear light and lays the result over a background.
/// @param pixels  RGBA8, premultiplied with sRGB-coded colour
/// @param covered receives the number of samples that the molecule covers, be it in part
Picture resolvePicture(const std::uint32_t* pixels, const ResolvedPart& part, const std::array<float, 4>& background,
                       std::uint64_t& covered);

/// The same of pixels of four floats each, premultiplied and linear.
Picture resolvePicture(const float* pixels, const ResolvedPart& part, const std::array<float, 4>& background,
                       std::uint64_t& covered);

/// @param color    RGBA, linear, premultiplied; @param surface normal and Z; @param identity atom and occlusion's bits
LayerPicture assembleLayers(std::uint32_t width, std::uint32_t height, const float* color, const float* surface,
                            const std::uint32_t* identity, const std::array<float, 4>& background,
                            std::uint64_t& covered);

}  // namespace nacre
