#pragma once
// What stands in the panel, for those who do not see it: screen readers, and tests.

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

namespace nacre::app {

/// A control, or a text, of one frame. Pixels of the window.
struct Control {
    std::string role;  ///< "button", "tab", "switch", "choice", "list", "slider", "field", "colour", "text", "window"
    std::string name, value;
    float left = 0, top = 0, right = 0, bottom = 0;                  ///< all of it
    float seenLeft = 0, seenTop = 0, seenRight = 0, seenBottom = 0;  ///< what its window shows of it
    bool enabled = true, focused = false;
    bool cut = false;    ///< its words had no room
    float lines = 1;     ///< of text
    float share = -1;    ///< of a slider: where it stands, 0 to 1
    float inset = 0;     ///< of a slider: from its sides to the ends of its track, pixels
    std::string window;  ///< that it stands in

    bool seen() const { return seenRight > seenLeft && seenBottom > seenTop; }
};

/// One that is seen and can be pressed; null: there is none.
const Control* findControl(const std::vector<Control>& controls, const std::string& role, const std::string& name);

/// What Tab goes on to: the place, in `controls`, of the one behind the one with the focus, or before it; round from
/// the last to the first. Without a focus, the first, or the last.
/// @param window  whose alone; empty: of all
std::optional<std::size_t> nextStop(const std::vector<Control>& controls, bool back, const std::string& window);

/// Where a finger presses a slider that is seen to move it by a tenth of its way, in pixels. Nothing: there is none.
std::optional<glm::dvec2> placeOfStep(const std::vector<Control>& controls, const std::string& name, bool up);

/// Those that are seen, a line each: role, name, value, whether it is enabled, left, top, right, bottom, with tabs
/// between them.
std::string controlLines(const std::vector<Control>& controls);

}  // namespace nacre::app
