#pragma once

#include <cstddef>
#include <functional>

#include "app/images/image_codec.h"

namespace nacre::app {

/// Writes three or four channels of bytes as lossless WebP, including colours under full transparency. OpenImageIO's
/// writer converts through YUV and loses a bit or two.
/// @param sink  takes the file's bytes; false: it failed @throws std::runtime_error
void writeWebp(const ImageRequest& request, const std::function<bool(const void* bytes, std::size_t size)>& sink);

}  // namespace nacre::app
