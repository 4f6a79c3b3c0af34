#include "app/images/image_webp.h"

#include <webp/encode.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace nacre::app {
namespace {

using Sink = std::function<bool(const void*, std::size_t)>;

/// A picture of libwebp's, which holds all of it.
struct Image {
    WebPPicture picture;
    Image() {
        if (!WebPPictureInit(&picture)) throw std::runtime_error("libwebp is another version than it was built for");
    }
    ~Image() { WebPPictureFree(&picture); }
    Image(const Image&) = delete;
};

void fill(WebPPicture& picture, const ImageRequest& request) {
    for (std::uint32_t first = 0; first < request.height; first += kRowsAtOnce) {
        const std::uint32_t count = std::min(kRowsAtOnce, request.height - first);
        const auto* in = static_cast<const std::uint8_t*>(request.rows(request.context, first, count));
        for (std::uint32_t row = 0; row < count; ++row) {
            std::uint32_t* out =
                picture.argb + std::size_t{first + row} * static_cast<std::size_t>(picture.argb_stride);
            for (std::uint32_t x = 0; x < request.width; ++x, in += request.channels) {
                const std::uint32_t alpha = request.channels == 4 ? in[3] : 255;
                out[x] = alpha << 24 | std::uint32_t{in[0]} << 16 | std::uint32_t{in[1]} << 8 | in[2];
            }
        }
    }
}

}  // namespace

void writeWebp(const ImageRequest& request, const Sink& sink) {
    WebPConfig config;
    constexpr int kEffort = 3;  // of 9: half as long as 6, for a hundredth more bytes
    if (!WebPConfigInit(&config) || !WebPConfigLosslessPreset(&config, kEffort))
        throw std::runtime_error("libwebp is another version than it was built for");
    config.exact = 1;
    Image image;
    WebPPicture& picture = image.picture;
    picture.use_argb = 1;
    picture.width = static_cast<int>(request.width);
    picture.height = static_cast<int>(request.height);
    if (!WebPPictureAlloc(&picture)) throw std::runtime_error("out of memory");
    fill(picture, request);
    picture.custom_ptr = const_cast<Sink*>(&sink);
    picture.writer = [](const std::uint8_t* bytes, std::size_t size, const WebPPicture* p) -> int {
        return (*static_cast<const Sink*>(p->custom_ptr))(bytes, size);
    };
    if (!WebPEncode(&config, &picture))
        throw std::runtime_error(picture.error_code == VP8_ENC_ERROR_BAD_WRITE
                                     ? "the data could not be written (is the disk full?)"
                                     : "libwebp's error " + std::to_string(picture.error_code));
}

}  // namespace nacre::app
