#pragma once
// Text files in encodings other than ASCII and UTF-8.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace nacre {

/// Converts UTF-16 text with a byte order mark to UTF-8 without it; empty if there is no mark. Invalid characters (a
/// lone surrogate, half a unit at the end) become U+FFFD.
/// @param text grows by at most 1.5 times
std::optional<std::string> utf8FromUtf16(std::string_view text);

/// Appends a character by its Unicode number.
void appendUtf8(std::string& text, std::uint32_t character);

}  // namespace nacre
