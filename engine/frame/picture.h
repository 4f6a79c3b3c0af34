#pragma once
// Converts device pixels to the caller's picture.

#include <array>
#include <glm/vec4.hpp>

#include "engine/coded_picture.h"
#include "engine/results.h"

namespace nacre {

/// Linear value of an sRGB-coded channel; both 0..1. IEC 61966-2-1.
float linearFromSrgb(float coded);

/// A linear colour. @param coded  sRGB-coded @param share  the fourth component
inline glm::vec4 linearColor(const std::array<float, 3>& coded, double share) {
    return {linearFromSrgb(coded[0]), linearFromSrgb(coded[1]), linearFromSrgb(coded[2]), share};
}

/// The device pixels that form a part of the picture.
struct ResolvedPart {
    std::uint32_t rowPixels;  ///< per row on the device
    std::uint32_t n;          ///< n x n device pixels form one pixel of the picture
    PictureRect rect;         ///< the wanted part, in pixels of the picture
};

/// Averages in linear light.
/// @param pixels  RGBA8, premultiplied with sRGB-coded colour @param to  receives them, linear and premultiplied
/// @returns the number of samples that the molecule covers at least in part
std::uint64_t resolvePixels(const std::uint32_t* pixels, const ResolvedPart& part, Picture& to);

/// As above for pixels of four floats each, premultiplied and linear.
std::uint64_t resolvePixels(const float* pixels, const ResolvedPart& part, Picture& to);

/// Puts a background behind a picture of linear, premultiplied colour. @param background  sRGB-coded, straight alpha
/// @returns the number of covered pixels
std::uint64_t putOver(Picture& picture, const std::array<float, 4>& background);

/// resolvePixels() and putOver() with a coded result: the same bytes, but most pixels are copied. @param part  with one
/// device pixel per pixel
CodedPicture codePixels(const std::uint32_t* pixels, const ResolvedPart& part, const std::array<float, 4>& background,
                        bool alpha, std::uint64_t& covered);

Picture emptyPicture(std::uint32_t width, std::uint32_t height);

/// @param identity  atom and occlusion bits of a square @returns the atom nearest to its middle, within `reach` pixels
std::uint32_t nearestAtom(const std::uint32_t* identity, std::uint32_t side, double reach);

/// @param color RGBA, linear, premultiplied; @param surface Z and normal; @param identity atom and occlusion bits
LayerPicture assembleLayers(std::uint32_t width, std::uint32_t height, const float* color, const float* surface,
                            const std::uint32_t* identity, const std::array<float, 4>& background,
                            std::uint64_t& covered);

}  // namespace nacre
