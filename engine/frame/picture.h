#pragma once
// Converts device pixels to the caller's picture.

#include <array>

#include "engine/results.h"

namespace nacre {

/// Linear value of an sRGB-coded channel; both 0..1. IEC 61966-2-1.
float linearFromSrgb(float coded);

/// Which device pixels form the picture.
struct ResolvedPart {
    std::uint32_t rowPixels;  ///< per row on the device
    std::uint32_t n;          ///< n x n device pixels form one pixel of the picture
    PictureRect rect;         ///< the wanted part, in pixels of the picture
    bool counted = false;     ///< count covered pixels of the picture, not samples
};

/// Averages in linear light and composites over a background.
/// @param pixels  RGBA8, premultiplied with sRGB-coded colour
/// @param covered receives the number of samples that the molecule covers at least in part
Picture resolvePicture(const std::uint32_t* pixels, const ResolvedPart& part, const std::array<float, 4>& background,
                       std::uint64_t& covered);

/// As above for pixels of four floats each, premultiplied and linear.
Picture resolvePicture(const float* pixels, const ResolvedPart& part, const std::array<float, 4>& background,
                       std::uint64_t& covered);

/// @param color RGBA, linear, premultiplied; @param surface normal and Z; @param identity atom and occlusion bits
LayerPicture assembleLayers(std::uint32_t width, std::uint32_t height, const float* color, const float* surface,
                            const std::uint32_t* identity, const std::array<float, 4>& background,
                            std::uint64_t& covered);

}  // namespace nacre
