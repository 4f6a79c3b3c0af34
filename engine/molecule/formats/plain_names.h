#pragma once
// Names as people write them, of files that write capitals.

#include <map>
#include <string>
#include <string_view>

namespace nacre {

/// "X-RAY DIFFRACTION" is "X-ray diffraction", "HIV-1 PROTEASE" is "HIV-1 protease": words of more than three letters
/// become small. Text that has small letters stays. @param sentence  the first letter is a capital
std::string plainCase(std::string_view text, bool sentence);

/// Of a chemical component. A synonym that is one word is preferred to a systematic name: "amprenavir".
/// @param synonyms  with semicolons between them
std::string plainComponentName(std::string_view name, std::string_view synonyms);

/// Notes the name of something, unless it has one, there are kMostNames, or the name is empty, '?' or '.'.
void noteName(std::map<std::string, std::string>& names, std::string_view of, const std::string& name);
constexpr std::size_t kMostNames = 1000, kLongestName = 200;  // bytes

/// Adds a text to a list with commas, unless it is there already, or empty.
void addToList(std::string& list, const std::string& text);

}  // namespace nacre
