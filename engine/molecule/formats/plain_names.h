#pragma once
// Converts names in capitals to usual spelling.

#include <map>
#include <string>
#include <string_view>

namespace nacre {

/// "X-RAY DIFFRACTION" becomes "X-ray diffraction", "HIV-1 PROTEASE" becomes "HIV-1 protease": words of more than three
/// letters become lower case. Text with lower-case letters stays. @param sentence  capitalise the first letter
std::string plainCase(std::string_view text, bool sentence);

/// Name of a chemical component. Prefers a synonym of one word to a systematic name: "amprenavir".
/// @param synonyms  separated by semicolons
std::string plainComponentName(std::string_view name, std::string_view synonyms);

/// Stores a name, unless there is one, there are kMostNames, or it is empty, '?' or '.'.
void noteName(std::map<std::string, std::string>& names, std::string_view of, const std::string& name);
constexpr std::size_t kMostNames = 1000, kLongestName = 200;  // bytes

/// Adds a text to a comma-separated list, unless it is already there, or empty.
void addToList(std::string& list, const std::string& text);

}  // namespace nacre
