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

/// As fontconfig's fc-match finds it; on Android by script, of those that every one has. The same question is asked
/// once. Nothing where there is no fontconfig, as on Apple's systems. From any thread.
std::optional<FontFile> systemFontWith(const std::vector<char32_t>& characters);

}  // namespace nacre::app
