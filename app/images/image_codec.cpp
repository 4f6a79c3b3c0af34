// Formats other than PNG: a separate module, loaded when a picture of such a format is written.

#include "app/images/image_codec.h"

#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>

#include "app/images/image_writers.h"

namespace nacre::app {
namespace {

/// @throws std::exception
void write(const ImageRequest& request, CheckedFile& file) {
    const std::string_view extension = request.extension;
    if (extension == ".exr")
        writeExr(request, file);
    else if (extension == ".tif" || extension == ".tiff")
        writeTiff(request, file);
    else if (extension == ".webp")
        writeWebp(request, file);
    else
        writeJpeg(request, file);
}

}  // namespace
}  // namespace nacre::app

extern "C" __attribute__((visibility("default"))) const char nacreImageCall[] = NACRE_IMAGE_CALL;

extern "C" __attribute__((visibility("default"))) bool nacreWriteImage(const nacre::app::ImageRequest* request,
                                                                       char* why, std::size_t whyBytes) {
    nacre::app::CheckedFile file(request->file);
    std::string reason;
    try {
        if (file.failure() == 0) nacre::app::write(*request, file);
    } catch (const std::exception& error) {
        reason = *error.what() ? error.what() : "the library gives no reason";
    }
    // A full disk explains a library's error better than its own message.
    if (const int failure = file.finish()) reason = std::strerror(failure);
    std::snprintf(why, whyBytes, "%s", reason.c_str());
    return reason.empty();
}
