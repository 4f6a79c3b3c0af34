#pragma once
// A writer per format and library. Each throws std::runtime_error, or an exception of its library. CheckedFile records
// failures of the file itself.

#include "app/images/checked_file.h"
#include "app/images/image_codec.h"

namespace nacre::app {

/// JPEG of quality 95 without subsampled colours (red atoms on white would bleed), with the profile of sRGB. Only
/// bytes.
void writeJpeg(const ImageRequest& request, CheckedFile& file);
/// TIFF, deflated, straight alpha, with the profile of sRGB. Bytes or words; BigTIFF from 4 GB on.
void writeTiff(const ImageRequest& request, CheckedFile& file);
/// OpenEXR, deflated in blocks of 16 rows. Halves or floats.
void writeExr(const ImageRequest& request, CheckedFile& file);
/// Lossless WebP, including colours under full transparency, with the profile of sRGB. Three or four channels of bytes.
void writeWebp(const ImageRequest& request, CheckedFile& file);

}  // namespace nacre::app
