#include "app/panel/controls.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/panel/panel_state.h"
#include "app/panel/words.h"
#include "app/picture/appearance_values.h"
#include "app/picture/option_text.h"
#include "app/picture/options.h"

namespace nacre::app {
namespace {

std::vector<const char*> listLabels(const Option& row) {
    std::vector<const char*> labels;
    for (const auto& choice : row.control.choices) labels.push_back(choice.label);
    return labels;
}

}  // namespace

const Control* findControl(const std::vector<Control>& controls, const std::string& role, const std::string& name) {
    const auto it = std::find_if(controls.begin(), controls.end(),
                                 [&](const Control& c) { return c.seen() && c.role == role && c.name == name; });
    return it == controls.end() ? nullptr : &*it;
}

std::optional<std::size_t> nextStop(const std::vector<Control>& controls, bool back, const std::string& window) {
    std::vector<std::size_t> stops;
    std::optional<std::size_t> focused;
    for (std::size_t i = 0; i < controls.size(); ++i) {
        const Control& c = controls[i];
        const bool words = c.role == "text" || c.role == "status" || c.role == "image" || c.role == "window";
        if (words || !c.enabled || c.window == "Picture" || (!window.empty() && c.window != window)) continue;
        if (c.focused) focused = stops.size();
        stops.push_back(i);
    }
    if (stops.empty()) return std::nullopt;
    if (!focused) return back ? stops.back() : stops.front();
    return stops[(*focused + (back ? stops.size() - 1 : 1)) % stops.size()];
}

std::optional<glm::dvec2> placeOfStep(const std::vector<Control>& controls, const std::string& name, bool up) {
    const Control* c = findControl(controls, "slider", name);
    if (!c || c->share < 0) return std::nullopt;
    const double share = std::clamp(c->share + (up ? 0.1f : -0.1f), 0.0f, 1.0f);
    return glm::dvec2(c->left + c->inset + share * (c->right - c->left - 2 * c->inset),
                      (c->seenTop + c->seenBottom) / 2);
}

std::string controlLines(const std::vector<Control>& controls) {
    std::string lines;
    const auto add = [&](std::string text, char end) {
        std::replace_if(
            text.begin(), text.end(), [](char c) { return c == '\t' || c == '\n'; }, ' ');
        lines += text + end;
    };
    for (const Control& c : controls) {
        if (!c.seen()) continue;
        add(c.role, '\t');
        add(c.name, '\t');
        add(c.value, '\t');
        add(c.enabled ? "1" : "0", '\t');
        for (const float side : {c.seenLeft, c.seenTop, c.seenRight}) add(std::to_string(std::lround(side)), '\t');
        add(std::to_string(std::lround(c.seenBottom)), '\n');
    }
    return lines;
}

double inHundredths(float value) { return std::round(static_cast<double>(value) * 100) / 100; }

bool slideOption(PanelFrame& f, std::string_view key, bool byRatio) {
    const Option& row = option(key);
    const Option::Control& control = row.control;
    const std::string text = row.value.print(f.look), off = std::string(control.label) + ": off";
    auto at = static_cast<float>(text == "off" ? 0 : std::strtod(text.c_str(), nullptr));
    if (f.ui.slide(control.label, at, static_cast<float>(control.low), static_cast<float>(control.high),
                   text == "off" ? off.c_str() : control.shown, byRatio)) {
        const double value = inHundredths(at);
        const bool canBeOff = row.syntax.ends_with("|off");
        row.value.parse(canBeOff && value < 0.1 ? "off" : numberText(value), f.look);
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
    std::string value = row.value.print(f.look);
    if (chooseValue(f.ui, row.control.label, key, value)) row.value.parse(value, f.look);
}

bool chooseValue(Widgets& ui, const char* name, std::string_view key, std::string& value) {
    const Option& row = option(key);
    std::string word = choiceLabel(key, value);
    if (!ui.choose(name, listLabels(row), word)) return false;
    for (const auto& choice : row.control.choices)
        if (word == choice.label) value = choice.value;
    return true;
}

bool chooseStyle(Widgets& ui, const char* name, const char* none, std::optional<Style>& style, float width) {
    const Option& row = option("style");
    std::vector<const char*> labels = listLabels(row);
    labels.front() = none;
    std::string word = style ? choiceLabel("style", styleName(*style)) : none;
    if (!ui.choose(name, std::span(labels).subspan(none ? 0 : 1), word, width)) return false;
    style.reset();
    for (std::size_t i = 1; i < labels.size(); ++i)
        if (word == labels[i]) style = parseStyle(row.control.choices[i].value);
    return true;
}

}  // namespace nacre::app
