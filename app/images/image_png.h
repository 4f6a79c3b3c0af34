#pragma once
// PNG with libpng only: most pictures do not need libraries of other formats.

#include "app/images/image_codec.h"

namespace nacre::app {

/// Writes a picture of bytes or words, without the module. @throws std::runtime_error if not everything is on disk;
/// exceptions of `rows`
void writePng(const ImageRequest& request);

}  // namespace nacre::app
