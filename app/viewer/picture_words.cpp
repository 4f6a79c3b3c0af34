#include "app/viewer/picture_words.h"

#include <algorithm>

#include "app/annotation/painter.h"
#include "app/picture/option_text.h"
#include "app/picture/options.h"
#include "engine/error.h"
#include "engine/scene/view/orientation.h"

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

bool PictureWords::place(double now) {
    if (!stage_.shown()) return true;
    stage_.schedule.overlayChanged();
    try {
        placed_ = stage_.document.drawing.placeWords(stage_.view().words, WordsOfHidden::leftOut);
    } catch (const Error& error) {
        stage_.messages.say(error.what(), now);
        return false;
    }
    const std::vector<std::string>& leftOut = placed_.leftOut;
    if (leftOut.empty()) return true;
    const std::string more = leftOut.size() > 1 ? " and " + std::to_string(leftOut.size() - 1) + " more" : "";
    stage_.messages.say("Hidden, because its atoms are not drawn: " + leftOut.front() + more, now);
    return true;
}

double PictureWords::size() const {
    const double own = stage_.view().words.size;
    return (own > 0 ? own : kWordPoints * textScale_) * frames_.pixelsPerPoint();
}

std::string originText(const FileSummary& file) {
    std::string text = file.method;
    if (file.resolution) text += (text.empty() ? "" : ", ") + numberText(*file.resolution) + " Å";
    if (file.organism.empty()) return text;
    return file.organism + (text.empty() ? "" : ". " + text);
}

std::string explanationText(const PictureDescription& picture, const Representation& scene) {
    const std::string style = meaningOf("style", styleName(scene.style));
    const std::string colors = colorMeaning(picture.look.color);
    const auto acts = [&](Rule::Action action) {
        return std::ranges::any_of(picture.look.rules,
                                   [&](const Rule& rule) { return rule.on && rule.action == action; });
    };
    std::string rules;
    if (acts(Rule::Action::hide)) rules = "Some atoms are hidden.";
    const bool styled = acts(Rule::Action::show), colored = acts(Rule::Action::color);
    if (styled || colored)
        rules += std::string(rules.empty() ? "" : " ") + "Some parts have " +
                 (!colored ? "a style"
                  : styled ? "a style and colours"
                           : "colours") +
                 " of their own.";
    return style + (colors.empty() ? "" : " " + colors) + (rules.empty() ? "" : " " + rules);
}

}  // namespace nacre::app
