#pragma once

#include <cstddef>
#include <functional>

#include "app/images/image_codec.h"

namespace nacre::app {

/// Writes bytes of three or four channels as WebP without loss, colours under full transparency, too. OpenImageIO's
/// writer goes by way of YUV and loses a bit or two.
/// @param sink  takes the file's bytes; false: it could not @throws std::runtime_error
void writeWebp(const ImageRequest& request, const std::function<bool(const void* bytes, std::size_t size)>& sink);

}  // namespace nacre::app
