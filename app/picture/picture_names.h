#pragma once

#include <span>
#include <string>

namespace nacre::app {

/// Whether a picture can be written under this name: standard output, or .png .tif .tiff .jpg .jpeg .webp .exr in any
/// case.
bool isPictureName(const std::string& path);
/// The extensions of picture files, ".png" first.
std::span<const std::string> pictureEndings();

}  // namespace nacre::app
