#pragma once
// Description of the panel's controls, for screen readers and tests.

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

namespace nacre::app {

/// A control or text of one frame. Pixels of the window.
struct Control {
    std::string role;  ///< "button", "tab", "switch", "choice", "list", "slider", "field", "colour", "text", "window"
    std::string name, value;
    float left = 0, top = 0, right = 0, bottom = 0;                  ///< its whole area
    float seenLeft = 0, seenTop = 0, seenRight = 0, seenBottom = 0;  ///< the part visible in its window
    bool enabled = true, focused = false;
    bool cut = false;    ///< its text is truncated
    float lines = 1;     ///< of text
    float share = -1;    ///< of a slider: position, 0 to 1
    float inset = 0;     ///< of a slider: from its sides to the ends of its track, pixels
    std::string window;  ///< that contains it

    bool seen() const { return seenRight > seenLeft && seenBottom > seenTop; }
};

/// A control that is visible and enabled; null: there is none.
const Control* findControl(const std::vector<Control>& controls, const std::string& role, const std::string& name);

/// The next Tab stop: index in `controls` of the control after or before the focused one, cyclic. Without a focus, the
/// first or last.
/// @param window  restricts it to one window; empty: all
std::optional<std::size_t> nextStop(const std::vector<Control>& controls, bool back, const std::string& window);

/// Position where a finger press moves a visible slider by a tenth of its range, pixels. Empty if there is none.
std::optional<glm::dvec2> placeOfStep(const std::vector<Control>& controls, const std::string& name, bool up);

/// The visible controls, one line each: role, name, value, whether it is enabled, left, top, right, bottom, separated
/// by tabs.
std::string controlLines(const std::vector<Control>& controls);

}  // namespace nacre::app
