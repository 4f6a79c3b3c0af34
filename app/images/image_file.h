#pragma once
// Pictures to files.

#include <functional>
#include <string>

#include "app/files/output_file.h"
#include "app/picture/description.h"
#include "engine/results.h"

namespace nacre::app {

/// How a picture is written.
struct PictureFormat {
    bool alpha = false;  ///< PNG, TIFF and WebP
    int bits = 8;        ///< of a channel, 8 or 16; PNG and TIFF
    double dpi = 0;      ///< dots an inch, which PNG, TIFF and JPEG say; 0: not said
};

/// How a description asks for its file to be written.
PictureFormat formatOf(const PictureDescription& picture);

/// PNG, TIFF, JPEG and WebP: sRGB; with straight alpha if the format says so, otherwise three channels, over
/// white where the picture is not opaque (JPEG always). EXR: linear light, premultiplied, half, with alpha.
/// The same picture gives the same bytes. @throws Error
void writePicture(OutputFile& file, const Picture& picture, const PictureFormat& format);

/// Rows of a picture as Picture has them, from `first` on; good until the next call.
using PictureRows = std::function<const float*(std::uint32_t first, std::uint32_t count)>;
/// The same of a picture that is made while it is written, some rows at a time, from the top on. @throws Error
void writePicture(OutputFile& file, std::uint32_t width, std::uint32_t height, const PictureRows& rows,
                  const PictureFormat& format);

/// EXR, float32, channels R G B A Z N.X N.Y N.Z id.Y occlusion.Y, which compositors show as the picture, its depth and
/// the layers N, id and occlusion; compressed without loss. On the background Z is infinite and all else 0. @throws Error
void writeLayers(OutputFile& file, const LayerPicture& layers);

}  // namespace nacre::app
