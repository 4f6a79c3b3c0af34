#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace nacre::app {

/// A font file of the system.
struct FontFile {
    std::string path;
    int index = 0;  ///< of the fonts in it
};
/// One that has some characters, or most of them; they are of one script.
using FindFont = std::function<std::optional<FontFile>(const std::vector<char32_t>&)>;

}  // namespace nacre::app
