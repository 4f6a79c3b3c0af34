#include "app/cli/option_words.h"

#include <algorithm>
#include <cctype>

#include "engine/error.h"
#include "engine/molecule/nearest_word.h"

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

constexpr std::size_t kMostHints = 4;

/// Names from other programs (PyMOL, ChimeraX, VMD, ImageMagick, ffmpeg), and their equivalents here.
struct OtherName {
    std::string_view theirs, ours;
};
constexpr OtherName kOtherNames[] = {
    {"aa", "--supersample"},
    {"address", "--listen"},
    {"alpha", "--background transparent"},
    {"antialias", "--supersample"},
    {"antialiasing", "--supersample"},
    {"ao", "--occlusion"},
    {"bg", "--background"},
    {"bg-color", "--background"},
    {"bind", "--listen"},
    {"depth-cue", "--fog"},
    {"duration", "--seconds"},
    {"edges", "--contours"},
    {"framerate", "--fps"},
    {"host", "--listen"},
    {"out", "--output"},
    {"outfile", "--output"},
    {"outline", "--contours"},
    {"outlines", "--contours"},
    {"perspective", "--projection perspective"},
    {"port", "--listen"},
    {"rep", "--style"},
    {"representation", "--style"},
    {"repr", "--style"},
    {"res", "--size"},
    {"resolution", "--size"},
    {"rot", "--rotate"},
    {"sel", "--show"},
    {"select", "--show"},
    {"silhouette", "--contours"},
    {"silhouettes", "--contours"},
    {"traj", "--trajectory"},
    {"transparency", "--surface-opacity"},
    {"transparent", "--background transparent"},
    {"turn", "--rotate"},
};

bool has(const CommandSpec& command, std::string_view longName) {
    return std::any_of(command.options.begin(), command.options.end(),
                       [&](const OptionSpec& option) { return option.longName() == longName; });
}

std::string othersName(const std::string& word, const CommandSpec& command) {
    for (const OtherName& other : kOtherNames)
        if (other.theirs == word && has(command, other.ours.substr(0, other.ours.find(' '))))
            return std::string(other.ours);
    return {};
}

/// Whether a word is one of those between a name's dashes: "opacity" of "surface-opacity".
bool isPart(const std::string& word, const std::string& name) {
    return ("-" + name + "-").find("-" + word + "-") != std::string::npos;
}

/// The options whose names contain a word: "--surface-opacity", "--cartoon-opacity".
std::vector<std::string> longerNames(const std::string& word, const CommandSpec& command) {
    std::vector<std::string> longer;
    for (const OptionSpec& option : command.options)
        if (!option.positional() && isPart(word, option.longName().substr(2))) longer.push_back(option.longName());
    return longer;
}

/// The options that accept a word as a value: "--style cartoon".
std::vector<std::string> optionsThatTake(const std::string& word, const CommandSpec& command) {
    std::vector<std::string> taking;
    for (const OptionSpec& option : command.options) {
        const std::vector<std::string> choices = listChoices(option);
        if (std::ranges::find(choices, word) != choices.end()) taking.push_back(option.longName() + " " + word);
    }
    return taking;
}

std::string question(const std::vector<std::string>& meant) {
    if (meant.empty() || meant.size() > kMostHints) return {};
    std::string list;
    for (std::size_t i = 0; i < meant.size(); ++i)
        list += (i == 0 ? "" : i + 1 < meant.size() ? ", " : " or ") + ("'" + meant[i] + "'");
    return " (did you mean " + list + "?)";
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

std::vector<std::string> listChoices(const OptionSpec& option) {
    std::vector<std::string> choices = option.choices;
    if (option.flag() || takesFile(option) || takesValue(option, "nosuchword")) return choices;
    std::string type = option.type;
    std::replace(type.begin(), type.end(), '|', ' ');
    for (const std::string& word : lowerWords(type + " " + option.help))
        if (takesValue(option, word) && std::ranges::find(choices, word) == choices.end()) choices.push_back(word);
    return choices;
}

std::string optionHint(const std::string& written, const CommandSpec& command) {
    const std::string word = written.substr(std::min(written.find_first_not_of('-'), written.size()));
    if (const std::string ours = othersName(word, command); !ours.empty()) return question({ours});
    std::vector<std::string> names{"help"};
    for (const OptionSpec& option : command.options)
        if (!option.positional()) names.push_back(option.longName().substr(2));
    if (const std::string near = nearestWord(word, names); !near.empty()) return question({"--" + near});
    std::vector<std::string> meant = optionsThatTake(word, command);
    for (std::string& name : longerNames(word, command)) meant.push_back(std::move(name));
    return question(meant);
}

}  // namespace nacre::app
