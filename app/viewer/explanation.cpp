#include "app/viewer/explanation.h"

#include <algorithm>

#include "app/picture/option_text.h"
#include "app/picture/options.h"

namespace nacre::app {
namespace {

std::string meaningOf(std::string_view key, std::string_view value) {
    for (const auto& choice : option(key).control.choices)
        if (choice.value == value) return choice.meaning;
    return {};
}

std::string colorMeaning(const Coloring& coloring) {
    if (coloring.scheme == ColorScheme::uniform) return "Everything has one colour.";
    if (coloring.scheme == ColorScheme::element && coloring != Coloring(ColorScheme::element))
        return "Carbon has one colour, other elements their own: oxygen red, nitrogen blue.";
    return meaningOf("color", colorSchemeName(coloring.scheme));
}

}  // namespace

std::string originText(const FileSummary& file) {
    std::string text = file.method;
    if (file.resolution) text += (text.empty() ? "" : ", ") + numberText(*file.resolution) + " Å";
    if (file.organism.empty()) return text;
    return file.organism + (text.empty() ? "" : ". " + text);
}

std::string explanationText(const PictureDescription& picture, const Representation& scene) {
    std::string colors = colorMeaning(picture.look.color);
    const auto& rules = picture.look.rules;
    if (!colors.empty() && std::any_of(rules.begin(), rules.end(), [](const Rule& rule) { return rule.on; }))
        colors.replace(colors.size() - 1, 1, "; rules change some parts.");
    return meaningOf("style", styleName(scene.style)) + " " + colors;
}

}  // namespace nacre::app
