#pragma once
// UTF-8, a character at a time.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace nacre::app {

struct CodePoint {
    std::uint32_t code = 0;
    std::size_t bytes = 1;
    bool valid = false;  ///< otherwise the code is that of one byte
};

/// The first of a text that is not empty (RFC 3629: no overlong forms, no surrogates).
CodePoint firstCodePoint(std::string_view text);

/// All of a text; a byte that belongs to none becomes U+FFFD.
std::vector<char32_t> codePoints(std::string_view text);

/// Both ways between UTF-8 and UTF-16, in which Java has its text. What is neither becomes U+FFFD.
std::u16string utf16Of(std::string_view utf8);
std::string utf8Of(std::u16string_view utf16);

}  // namespace nacre::app
