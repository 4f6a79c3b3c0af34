#pragma once
// Pictures to files. Everything that touches OpenImageIO stands here.

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "app/shared/output_file.h"

namespace nacre::app {

/// Whether a picture can be written under this name: .png .tif .tiff .jpg .jpeg .exr in any case.
bool isPictureName(const std::string& path);

/// A view of a picture: width x height pixels, row 0 on top.
struct PictureView {
    std::uint32_t width = 0, height = 0;
    std::span<const float> rgba;  ///< 4 per pixel, linear light, premultiplied
};

/// PNG, TIFF and JPEG: sRGB, 8 bits; PNG and TIFF with straight alpha if `alpha`, otherwise three channels, over
/// white where the picture is not opaque (JPEG always). EXR: linear light, premultiplied, half, with alpha.
/// The same picture gives the same bytes. @throws Error
void writePicture(OutputFile& file, const PictureView& picture, bool alpha);

/// The geometry behind a picture, one value per pixel; see `--layers`.
struct LayersView {
    std::uint32_t width = 0, height = 0;
    std::span<const float> rgba;        ///< 4 per pixel, linear light, premultiplied
    std::span<const float> z;           ///< Å; +infinity = background
    std::span<const float> normal;      ///< 3 per pixel, view space
    std::span<const std::uint32_t> id;  ///< 1-based atom; 0 = background
    std::span<const float> occlusion;   ///< 0..1
};

/// EXR, float32, channels R G B A Z N.X N.Y N.Z id occlusion, compressed without loss. @throws Error
void writeLayers(OutputFile& file, const LayersView& layers);

}  // namespace nacre::app
