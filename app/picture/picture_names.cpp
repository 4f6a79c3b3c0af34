#include "app/picture/picture_names.h"

#include <algorithm>

#include "app/files/output_file.h"

namespace nacre::app {

bool isPictureName(const std::string& path) {
    return isStandardOutput(path) || std::ranges::count(pictureEndings(), fileExtension(path)) > 0;
}

std::span<const std::string> pictureEndings() {
    static const std::string kEndings[] = {".png", ".tif", ".tiff", ".jpg", ".jpeg", ".webp", ".exr"};
    return kEndings;
}

}  // namespace nacre::app
