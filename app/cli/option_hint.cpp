#include <algorithm>

#include "app/cli/option_words.h"
#include "engine/molecule/nearest_word.h"

namespace nacre::app {
namespace {

constexpr std::size_t kMostHints = 3;

/// Names from other programs (PyMOL, ChimeraX, VMD, ImageMagick, ffmpeg), and their equivalents here.
struct OtherName {
    std::string_view theirs, ours;
};
constexpr OtherName kOtherNames[] = {
    {"aa", "--supersample"},
    {"alpha", "--background transparent"},
    {"antialias", "--supersample"},
    {"antialiasing", "--supersample"},
    {"ao", "--occlusion"},
    {"bg", "--background"},
    {"bg-color", "--background"},
    {"depth-cue", "--fog"},
    {"duration", "--seconds"},
    {"edges", "--contours"},
    {"framerate", "--fps"},
    {"out", "--output"},
    {"outfile", "--output"},
    {"outline", "--contours"},
    {"outlines", "--contours"},
    {"perspective", "--projection perspective"},
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

/// Whether it is one of the words between a name's dashes: "opacity" of "surface-opacity".
bool isPart(const std::string& word, const std::string& name) {
    return ("-" + name + "-").find("-" + word + "-") != std::string::npos;
}

/// The options that it is a part of: "--surface-opacity", "--cartoon-opacity".
std::vector<std::string> longerNames(const std::string& word, const CommandSpec& command) {
    std::vector<std::string> longer;
    for (const OptionSpec& option : command.options)
        if (!option.positional() && isPart(word, option.longName().substr(2))) longer.push_back(option.longName());
    return longer;
}

/// The options that take it as a value: "--style cartoon".
std::vector<std::string> optionsThatTake(const std::string& word, const CommandSpec& command) {
    std::vector<std::string> taking;
    for (const OptionSpec& option : command.options) {
        const std::vector<std::string> choices = choicesOf(option);
        if (std::find(choices.begin(), choices.end(), word) != choices.end())
            taking.push_back(option.longName() + " " + word);
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
