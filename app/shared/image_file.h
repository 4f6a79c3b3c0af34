#pragma once
// Pictures to files.

#include <string>

#include "app/shared/output_file.h"
#include "engine/results.h"

namespace nacre::app {

/// Whether a picture can be written under this name: standard output, or .png .tif .tiff .jpg .jpeg .exr in any case.
bool isPictureName(const std::string& path);

/// PNG, TIFF and JPEG: sRGB, 8 bits; PNG and TIFF with straight alpha if `alpha`, otherwise three channels, over
/// white where the picture is not opaque (JPEG always). EXR: linear light, premultiplied, half, with alpha.
/// The same picture gives the same bytes. @throws Error
void writePicture(OutputFile& file, const Picture& picture, bool alpha);

/// EXR, float32, channels R G B A Z N.X N.Y N.Z id occlusion, compressed without loss. @throws Error
void writeLayers(OutputFile& file, const LayerPicture& layers);

}  // namespace nacre::app
