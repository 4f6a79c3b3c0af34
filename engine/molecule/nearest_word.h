#pragma once

#include <span>
#include <string>
#include <string_view>

namespace nacre {

/// The word that was probably meant: the nearest within two edits (a letter more, less, other, or two swapped), one for
/// words of three or four letters. Case does not count. Empty if none is near.
std::string nearestWord(std::string_view word, std::span<const std::string> words);

/// " (did you mean 'WORD'?)", or nothing.
std::string suggestion(std::string_view word, std::span<const std::string> words);

}  // namespace nacre
