#pragma once
// Numbers from text and to text as std::from_chars and std::to_chars have it, also where the standard library has no
// such functions for double: libc++ up to version 19, and so the systems of Apple and Android.
// Must also compile as C++17.

#include <charconv>

namespace nacre {

/// std::from_chars: no blanks or '+' before, no hexadecimals, no locale.
std::from_chars_result fromChars(const char* first, const char* last, double& value);
template <typename Integer>
std::from_chars_result fromChars(const char* first, const char* last, Integer& value) {
    return std::from_chars(first, last, value);
}

/// std::to_chars: the fewest digits that give the same number again.
std::to_chars_result toChars(char* first, char* last, double value);

/// What these are made of where the library lacks them; here for tests.
namespace portable {
std::from_chars_result fromChars(const char* first, const char* last, double& value);
std::to_chars_result toChars(char* first, char* last, double value);
}  // namespace portable

}  // namespace nacre
