#include "app/panel/controls.h"

#include <algorithm>
#include <cmath>

namespace nacre::app {

const Control* findControl(const std::vector<Control>& controls, const std::string& role, const std::string& name) {
    const auto it = std::find_if(controls.begin(), controls.end(),
                                 [&](const Control& c) { return c.seen() && c.role == role && c.name == name; });
    return it == controls.end() ? nullptr : &*it;
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
