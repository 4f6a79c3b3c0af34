#include "app/cli/option_words.h"

#include <algorithm>
#include <cctype>

#include "engine/error.h"

namespace nacre::app {
namespace {

bool takesValue(const OptionSpec& option, const std::string& value) {
    try {
        option.set(value);
        return true;
    } catch (const std::invalid_argument&) {
        return false;
    } catch (const Error&) {
        return false;
    }
}

/// Words in lower case, as names of choices are: "ball-and-stick", "r32f".
std::vector<std::string> lowerWords(const std::string& text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : text + ' ') {
        const auto byte = static_cast<unsigned char>(c);
        if (std::islower(byte) || std::isdigit(byte) || (c == '-' && !word.empty())) {
            word += c;
            continue;
        }
        if (word.size() > 1 && std::islower(static_cast<unsigned char>(word[0])) && word.back() != '-')
            words.push_back(word);
        word.clear();
    }
    return words;
}

}  // namespace

std::vector<std::string> writtenNames(const OptionSpec& option) {
    std::vector<std::string> names;
    if (option.positional()) return names;
    std::string_view rest = option.names;
    for (std::size_t comma; (comma = rest.find(',')) != std::string_view::npos; rest.remove_prefix(comma + 1))
        names.emplace_back(rest.substr(0, comma));
    names.emplace_back(rest);
    return names;
}

bool takesFile(const OptionSpec& option) {
    const auto has = [&](const char* word) { return option.type.find(word) != std::string::npos; };
    return has("FILE") || has("DIR") || takesFiles(option);
}

bool takesFiles(const OptionSpec& option) { return option.type.find(".json,") != std::string::npos; }

std::vector<std::string> choicesOf(const OptionSpec& option) {
    std::vector<std::string> choices = option.choices;
    if (option.flag() || takesFile(option) || takesValue(option, "nosuchword")) return choices;
    std::string type = option.type;
    std::replace(type.begin(), type.end(), '|', ' ');
    for (const std::string& word : lowerWords(type + " " + option.help))
        if (takesValue(option, word) && std::find(choices.begin(), choices.end(), word) == choices.end())
            choices.push_back(word);
    return choices;
}

}  // namespace nacre::app
