// Text for other files from the options' table: docs/reference.md, and the keyword arguments in Python's type stubs.

#include <algorithm>

#include "app/cli/option_words.h"
#include "app/picture/options.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

struct ReferenceGroup {
    const char* title;
    Topics topics;
};
constexpr ReferenceGroup kReferenceGroups[] = {
    {"Input", Topic::input | Topic::reading},
    {"Trajectories and several inputs", Topic::trajectory | Topic::fit},
    {"Representation", Topic::style | Topic::atoms},
    {"Colours", Topic::color | Topic::background},
    {"Selections", static_cast<Topics>(Topic::rules)},
    {"Interactions", static_cast<Topics>(Topic::interactions)},
    {"Cartoons and surfaces", static_cast<Topics>(Topic::mesh)},
    {"Density maps", static_cast<Topics>(Topic::map)},
    {"Geometry beside the molecule", static_cast<Topics>(Topic::geometry)},
    {"Camera", Topic::camera | Topic::aim},
    {"Looks and saved views", Topic::look | Topic::view | Topic::thumbnail},
    {"Light and effects", Topic::lighting | Topic::effects},
    {"Ambient occlusion", Topic::occlusion | Topic::detail},
    {"Labels, legend, title", static_cast<Topics>(Topic::words)},
    {"Size and quality", Topic::size | Topic::samples | Topic::levels | Topic::paper},
    {"Files", static_cast<Topics>(Topic::files)},
    {"Device", Topic::device | Topic::path | Topic::frame | Topic::validation | Topic::debug},
};

std::string referenceEntry(const Option& option) {
    const PictureDescription plain;
    std::string text = option.positional ? "**`INPUT`**" : "**`--" + std::string(option.key);
    if (!option.positional) text += (option.syntax.empty() ? "" : " " + option.syntax) + "`**";
    const std::string standard = option.standard == "=" ? option.print(plain) : option.standard;
    if (!standard.empty()) text += " (default: " + standard + ")";
    std::string help = option.help;
    std::replace(help.begin(), help.end(), '\n', ' ');
    return text + "\\\n" + help + ".\n";
}

bool isKeyword(const Option& option) {
    return has(kEveryTopic & ~kReading & ~(Topic::files | Topic::view), option.topic);
}

bool takesNumbers(const Option& option) {
    try {
        PictureDescription tried;
        option.parse("1", tried);
        return true;
    } catch (const std::invalid_argument&) {
        return false;
    } catch (const Error&) {
        return false;
    }
}

const char* keywordType(const Option& option) {
    if (option.kind == Option::Kind::flag) return "bool";
    if (option.kind == Option::Kind::list) return "str | Sequence[str]";
    if (option.syntax == "on|off") return "str | bool";
    if (option.syntax == "WxH" || option.syntax == "X,Y,Z") return "str | Sequence[float]";
    return option.syntax.find("SEL") == std::string::npos && takesNumbers(option) ? "str | float" : "str";
}

}  // namespace

std::string referencePage() {
    std::string page =
        "# Reference of options\n\n"
        "Options of `nacre render`; the other commands take those that concern them. Jobs of `nacre batch` and Python\n"
        "have the same keys without dashes. `nacre help reference` writes this page.\n";
    for (const ReferenceGroup& group : kReferenceGroups) {
        page += std::string("\n## ") + group.title + "\n";
        for (const Option& option : options())
            if (has(group.topics, option.topic)) page += "\n" + referenceEntry(option);
    }
    return page;
}

std::string pythonKeywords() {
    std::string text;
    for (const Option& option : options()) {
        if (!isKeyword(option)) continue;
        std::string key(option.key);
        std::replace(key.begin(), key.end(), '-', '_');
        text += "    " + key + ": " + keywordType(option) + "\n";
    }
    return text;
}

}  // namespace nacre::app
