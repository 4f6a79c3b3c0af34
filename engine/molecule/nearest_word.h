#pragma once

#include <span>
#include <string>
#include <string_view>

namespace nacre {

/// The probably intended word: the nearest within two edits (a letter inserted, deleted or replaced, or two swapped),
/// or one edit for words of three or four letters. Ignores case. Empty if none is near.
std::string nearestWord(std::string_view word, std::span<const std::string> words);

/// " (did you mean 'WORD'?)", or empty.
std::string suggestion(std::string_view word, std::span<const std::string> words);

}  // namespace nacre
