#include "app/picture/picture_names.h"

#include <algorithm>
#include <iterator>

#include "app/files/output_file.h"

namespace nacre::app {

bool isPictureName(const std::string& path) {
    constexpr const char* kEndings[] = {".png", ".tif", ".tiff", ".jpg", ".jpeg", ".webp", ".exr"};
    return isStandardOutput(path) || std::ranges::count(kEndings, extensionOf(path)) > 0;
}

}  // namespace nacre::app
