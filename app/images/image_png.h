#pragma once
// PNG by libpng alone: what nearly every picture is needs none of the libraries that the other formats bring along.

#include "app/images/image_codec.h"

namespace nacre::app {

/// Writes a picture of bytes or words, and waits for no module. @throws std::runtime_error if it is not all on disk;
/// whatever `rows` throws
void writePng(const ImageRequest& request);

}  // namespace nacre::app
