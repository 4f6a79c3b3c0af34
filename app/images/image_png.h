#pragma once
// PNG with libpng only: most pictures need no library of the other formats.

#include "app/images/image_codec.h"

namespace nacre::app {

/// Writes a picture of bytes or words, without the module. @throws std::runtime_error if not all is on disk; exceptions
/// of `rows`
void writePng(const ImageRequest& request);

}  // namespace nacre::app
