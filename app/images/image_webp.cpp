#include <webp/encode.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "app/images/image_writers.h"
#include "app/images/srgb_profile.h"

namespace nacre::app {
namespace {

/// A complete picture in libwebp's format.
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

/// A WebP file from libwebp's output (RIFF with one chunk), with a colour profile before the picture: "Extended File
/// Format" of the WebP Container Specification.
std::vector<std::uint8_t> withProfile(const std::vector<std::uint8_t>& file, const ImageRequest& request) {
    constexpr std::size_t kRiffHeader = 12;
    std::vector<std::uint8_t> whole;
    const auto number = [&](std::size_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) whole.push_back(static_cast<std::uint8_t>(value >> 8 * i));
    };
    const auto text = [&](std::string_view letters) { whole.insert(whole.end(), letters.begin(), letters.end()); };
    const std::vector<std::uint8_t> profile = srgbProfile();  // has even size, as chunks must
    text("RIFF");
    number(file.size() - 8 + 18 + 8 + profile.size(), 4);
    text("WEBPVP8X");
    number(10, 4);
    constexpr std::uint8_t kProfile = 0x20, kAlpha = 0x10;
    number(kProfile | (request.channels == 4 ? kAlpha : 0), 4);
    number(request.width - 1, 3);
    number(request.height - 1, 3);
    text("ICCP");
    number(profile.size(), 4);
    whole.insert(whole.end(), profile.begin(), profile.end());
    whole.insert(whole.end(), file.begin() + kRiffHeader, file.end());
    return whole;
}

}  // namespace

void writeWebp(const ImageRequest& request, CheckedFile& out) {
    WebPConfig config;
    constexpr int kEffort = 3;  // of 9: half the time of 6, for one percent more bytes
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
    std::vector<std::uint8_t> file;
    picture.custom_ptr = &file;
    picture.writer = [](const std::uint8_t* bytes, std::size_t size, const WebPPicture* p) -> int {
        auto& all = *static_cast<std::vector<std::uint8_t>*>(p->custom_ptr);
        all.insert(all.end(), bytes, bytes + size);
        return 1;
    };
    if (!WebPEncode(&config, &picture))
        throw std::runtime_error("libwebp's error " + std::to_string(picture.error_code));
    const std::vector<std::uint8_t> whole = withProfile(file, request);
    out.write(whole.data(), whole.size());
}

}  // namespace nacre::app
