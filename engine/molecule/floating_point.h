#pragma once
// std::from_chars and std::to_chars for double, also where the standard library lacks them: libc++ up to version 19, so
// Apple's and Android's systems. Must also compile as C++17.

#include <charconv>

namespace nacre {

/// std::from_chars: no leading blanks or '+', no hexadecimals, no locale.
std::from_chars_result fromChars(const char* first, const char* last, double& value);
template <typename Integer>
std::from_chars_result fromChars(const char* first, const char* last, Integer& value) {
    return std::from_chars(first, last, value);
}

/// std::to_chars: the fewest digits that parse to the same number.
std::to_chars_result toChars(char* first, char* last, double value);

/// Fallbacks where the library lacks these functions; declared for tests.
namespace portable {
std::from_chars_result fromChars(const char* first, const char* last, double& value);
std::to_chars_result toChars(char* first, char* last, double value);
}  // namespace portable

}  // namespace nacre
