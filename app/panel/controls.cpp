#include "app/panel/controls.h"

#include <algorithm>
#include <cmath>

namespace nacre::app {

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
