#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace nacre::app {

/// A font file of the system.
struct FontFile {
    std::string path;
    int index = 0;  ///< index of the font in the file
};
/// Finds a font with all or most of some characters, which are of one script.
using FindFont = std::function<std::optional<FontFile>(const std::vector<char32_t>&)>;

/// The font that fontconfig's fc-match finds; on Android, by script, one of the fonts on every device. Caches answers.
/// Empty without fontconfig, as on Apple's systems. Thread-safe.
std::optional<FontFile> systemFontWith(const std::vector<char32_t>& characters);

/// DejaVu Sans as a TrueType file: the font of pictures and of the panel. Built in, so that pictures look the same on
/// every machine.
std::span<const std::byte> fontFile();

}  // namespace nacre::app
