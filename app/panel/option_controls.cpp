// Controls of options: names, ranges and choices are those of the options' table.

#include <cmath>
#include <cstdlib>

#include "app/panel/panel_state.h"
#include "app/panel/words.h"
#include "app/picture/appearance_values.h"
#include "app/picture/option_text.h"
#include "app/picture/options.h"

namespace nacre::app {
namespace {

std::vector<const char*> labelsOf(const Option& row) {
    std::vector<const char*> labels;
    for (const auto& choice : row.control.choices) labels.push_back(choice.label);
    return labels;
}

}  // namespace

double inHundredths(float value) { return std::round(static_cast<double>(value) * 100) / 100; }

bool slideOption(PanelFrame& f, std::string_view key, bool byRatio) {
    const Option& row = option(key);
    const Option::Control& control = row.control;
    const std::string text = row.print(f.look), off = std::string(control.label) + ": off";
    auto at = static_cast<float>(text == "off" ? 0 : std::strtod(text.c_str(), nullptr));
    if (f.ui.slide(control.label, at, static_cast<float>(control.low), static_cast<float>(control.high),
                   text == "off" ? off.c_str() : control.shown, byRatio)) {
        const double value = inHundredths(at);
        const bool canBeOff = row.syntax.ends_with("|off");
        row.parse(canBeOff && value < 0.1 ? "off" : numberText(value), f.look);
    }
    return text != "off";
}

bool toggleOption(PanelFrame& f, std::string_view key) {
    const Option& row = option(key);
    bool on = chosen(row, f.look) != 0;
    if (f.ui.toggle(row.control.label, on)) stepOption(row, f.look);
    return on;
}

void chooseOption(PanelFrame& f, std::string_view key) {
    const Option& row = option(key);
    std::string value = row.print(f.look);
    if (chooseValue(f.ui, row.control.label, key, value)) row.parse(value, f.look);
}

bool chooseValue(Widgets& ui, const char* name, std::string_view key, std::string& value) {
    const Option& row = option(key);
    std::string word = wordOf(key, value);
    if (!ui.choose(name, labelsOf(row), word)) return false;
    for (const auto& choice : row.control.choices)
        if (word == choice.label) value = choice.value;
    return true;
}

bool chooseStyle(Widgets& ui, const char* name, const char* none, std::optional<Style>& style, float width) {
    const Option& row = option("style");
    std::vector<const char*> labels = labelsOf(row);
    labels.front() = none;
    std::string word = style ? wordOf("style", styleName(*style)) : none;
    if (!ui.choose(name, std::span(labels).subspan(none ? 0 : 1), word, width)) return false;
    style.reset();
    for (std::size_t i = 1; i < labels.size(); ++i)
        if (word == labels[i]) style = parseStyle(row.control.choices[i].value);
    return true;
}

}  // namespace nacre::app
