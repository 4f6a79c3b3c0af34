#include "engine/molecule/formats/plain_names.h"

#include <algorithm>

#include "engine/molecule/text.h"

namespace nacre {
namespace {

constexpr std::size_t kLongestAbbreviation = 3;
constexpr std::string_view kShortWords[] = {"AN", "AND", "BY", "FOR", "IN",  "ION", "NON",
                                            "OF", "ON",  "OR", "RAY", "THE", "TO"};

bool isWord(char c) { return isLetter(c) || isDigit(c) || c == '\''; }

/// Whether a word of capitals stays as it is: abbreviations, numbers.
bool staysCapital(std::string_view word) {
    if (std::any_of(word.begin(), word.end(), isDigit)) return true;
    if (word.size() == 1) return true;  // "N-acetyl-D-glucosamine"
    return word.size() <= kLongestAbbreviation && std::ranges::find(kShortWords, word) == std::end(kShortWords);
}

bool isOneWord(std::string_view text) {
    constexpr std::size_t kLeastLetters = 4;
    return text.size() >= kLeastLetters && std::all_of(text.begin(), text.end(), [](char c) { return isLetter(c); });
}

}  // namespace

std::string plainCase(std::string_view text, bool sentence) {
    std::string plain(trim(text));
    const bool capitals = std::none_of(plain.begin(), plain.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    for (std::size_t at = 0; capitals && at < plain.size();) {
        std::size_t end = at;
        while (end < plain.size() && isWord(plain[end])) ++end;
        const std::string word = plain.substr(at, end - at);
        if (!staysCapital(word)) plain.replace(at, word.size(), lowerCase(word));
        at = std::max(end, at + 1);
    }
    if (sentence && !plain.empty()) plain[0] = upperCase(plain[0]);
    return plain;
}

std::string plainComponentName(std::string_view name, std::string_view synonyms) {
    for (std::string_view rest = isOneWord(trim(name)) ? std::string_view() : synonyms; !rest.empty();) {
        const std::size_t end = std::min(rest.find(';'), rest.size());
        if (const std::string_view synonym = trim(rest.substr(0, end)); isOneWord(synonym)) return lowerCase(synonym);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    const std::string plain = plainCase(name, false);
    return isOneWord(plain) ? lowerCase(plain) : plain;
}

void noteName(std::map<std::string, std::string>& names, std::string_view of, const std::string& name) {
    if (of.empty() || name.empty() || name == "?" || name == "." || names.size() >= kMostNames) return;
    names.emplace(printable(of), printable(name, kLongestName));
}

void addToList(std::string& list, const std::string& text) {
    if (text.empty() || text == "?" || text == "." || list.size() > kLongestName) return;
    const std::string item = printable(text, kLongestName);
    if ((", " + list + ", ").find(", " + item + ", ") != std::string::npos) return;
    list += (list.empty() ? "" : ", ") + item;
}

}  // namespace nacre
