#include "app/panel/controls.h"

#include <algorithm>
#include <cmath>

namespace nacre::app {

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

}  // namespace nacre::app
