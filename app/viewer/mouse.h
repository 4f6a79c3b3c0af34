#pragma once
// Converts mouse and trackpad input to the gestures of fingers.

#include <optional>

#include "app/viewer/gestures.h"

namespace nacre::app {

class MouseGestures {
public:
    static constexpr double kSlop = 3;  ///< maximum movement of a click, points
    static constexpr double kDoubleClickSeconds = 0.35;
    static constexpr double kZoomPerStep = 1.15;  ///< of the wheel

    std::vector<Gesture> button(MouseButton button, bool down, glm::dvec2 at, Modifiers with, double now);
    /// @param middle of the window: centre of a Ctrl drag's roll
    std::vector<Gesture> move(glm::dvec2 at, glm::dvec2 middle);
    std::vector<Gesture> wheel(double steps, glm::dvec2 at) const;
    void clear() { held_.reset(); }
    bool held() const { return held_.has_value(); }

private:
    enum class Drag { rotate, pan, roll };
    struct Held {
        MouseButton button;
        Drag drag;
        glm::dvec2 start, at;
        bool moved;
    };
    struct Click {
        glm::dvec2 at;
        double when;
    };
    std::optional<Held> held_;
    std::optional<Click> last_;
};

}  // namespace nacre::app
