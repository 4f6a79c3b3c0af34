#pragma once
// Writes pictures to files.

#include <functional>
#include <string>

#include "app/files/output_file.h"
#include "app/picture/description.h"
#include "engine/coded_picture.h"
#include "engine/results.h"

namespace nacre::app {

/// How a picture is written.
struct PictureFormat {
    bool alpha = false;  ///< PNG, TIFF and WebP
    int bits = 8;        ///< per channel, 8 or 16; PNG and TIFF
    double dpi = 0;      ///< dots per inch, stored in PNG, TIFF and JPEG; 0: not stated
};

/// The format requested by a description.
PictureFormat chooseFormat(const PictureDescription& picture);
/// Whether a file of this name has an alpha channel.
bool hasAlpha(const PictureFormat& format, const std::string& path);

/// PNG, TIFF, JPEG and WebP: sRGB; with straight alpha if the format has it, otherwise three channels, over white if
/// the picture is not opaque (JPEG always). EXR: linear light, premultiplied, half, with alpha. The same picture gives
/// the same bytes. @throws Error
void writePicture(OutputFile& file, const Picture& picture, const PictureFormat& format);

/// The bytes of such a file, in memory. @param extension  of the format, with the dot @throws Error
std::string encodePicture(const std::string& extension, const Picture& picture, const PictureFormat& format);
std::string encodePicture(const std::string& extension, const CodedPicture& picture);

/// Like writePicture(). @param dpi  as in PictureFormat
void writePicture(OutputFile& file, const CodedPicture& picture, double dpi);

/// Rows of a picture, layout as in Picture, from `first` on; valid until the next call.
using PictureRows = std::function<const float*(std::uint32_t first, std::uint32_t count)>;
/// As above for a picture made during writing, some rows at a time, from the top down. @throws Error
void writePicture(OutputFile& file, std::uint32_t width, std::uint32_t height, const PictureRows& rows,
                  const PictureFormat& format);

/// EXR, float32, channels R G B A Z N.X N.Y N.Z id.Y occlusion.Y, which compositors show as the picture, its depth and
/// the layers N, id and occlusion; lossless compression. On the background Z is infinite and all else 0. @throws Error
void writeLayers(OutputFile& file, const LayerPicture& layers);

}  // namespace nacre::app
