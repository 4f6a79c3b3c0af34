#pragma once
// Text files in other encodings than ASCII and UTF-8.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace nacre {

/// UTF-16 text that says so by its byte order mark, as UTF-8 without the mark; empty if it does not begin with one.
/// What is no character (a lone surrogate, half a unit at the end) becomes U+FFFD.
/// @param text at most 1.5 times as long when it comes back
std::optional<std::string> utf8FromUtf16(std::string_view text);

/// Appends a character by its number in Unicode.
void appendUtf8(std::string& text, std::uint32_t character);

}  // namespace nacre
