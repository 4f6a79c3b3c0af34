#pragma once
// UTF-8, one character at a time.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace nacre::app {

struct CodePoint {
    std::uint32_t code = 0;
    std::size_t bytes = 1;
    bool valid = false;  ///< false: the code is that of a single byte
};

/// The first of a non-empty text (RFC 3629: no overlong forms, no surrogates).
CodePoint firstCodePoint(std::string_view text);

/// All of a text; invalid bytes become U+FFFD.
std::vector<char32_t> codePoints(std::string_view text);

/// Converts between UTF-8 and UTF-16, which Java uses. Invalid input becomes U+FFFD.
std::u16string toUtf16(std::string_view utf8);
std::string toUtf8(std::u16string_view utf16);

}  // namespace nacre::app
