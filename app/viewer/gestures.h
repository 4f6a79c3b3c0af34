#pragma once
// Recognises gestures of fingers: rotate, pan, zoom, roll, tap. Independent of the molecule and of a clock. Mouse and
// trackpad input is converted to the same gestures.

#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <vector>

#include "app/viewer/events.h"

namespace nacre::app {

struct Gesture {
    enum class Kind {
        touched,    ///< a finger came down: automatic motion stops
        rotate,     ///< by `by`
        transform,  ///< pan by `by`, zoom by `scale` and roll by `turn` about `at`
        tap,        ///< at `at`; also the first tap of a double tap
        doubleTap,
        longPress,
        menu,      ///< a click with the right button
        released,  ///< the last finger of a rotation or transformation was lifted
        undo,      ///< three fingers swiped left
        redo,      ///< three fingers swiped right
    };
    Kind kind{};
    glm::dvec2 at{};     ///< points
    glm::dvec2 by{};     ///< points
    double scale = 1.0;  ///< factor
    double turn = 0.0;   ///< radians, clockwise as seen
};

class TouchGestures {
public:
    static constexpr double kSlop = 8;          ///< maximum movement of a tap, points
    static constexpr double kSwipe = 50;        ///< minimum movement of three fingers, points
    static constexpr double kTapSeconds = 0.3;  ///< maximum duration of a tap
    static constexpr double kLongPressSeconds = 0.5;
    static constexpr double kDoubleTapSeconds = 0.35;  ///< between two taps
    static constexpr double kDoubleTapReach = 40;      ///< points between the two

    std::vector<Gesture> handle(const TouchEvent& event, double now);
    /// Gestures due by time alone. Call at or after wake().
    std::vector<Gesture> tick(double now);
    /// When tick() may return a gesture.
    std::optional<double> wake() const;
    /// Drops all fingers, for example after a pause.
    void clear();

private:
    struct Finger {
        glm::dvec2 start, at;
        double since;
    };
    struct Tap {
        glm::dvec2 at;
        double when;
    };
    void move(const TouchEvent& event, std::vector<Gesture>& out);
    void swipe(std::vector<Gesture>& out);
    void lift(const TouchEvent& event, double now, std::vector<Gesture>& out);

    std::map<std::int64_t, Finger> fingers_;
    bool wandered_ = false;  // no tap: a finger moved, or there were two
    bool dragging_ = false;  // something was rotated or transformed
    bool pressed_ = false;   // the long press was reported
    bool three_ = false;     // three fingers: only a swipe is possible
    bool pinching_ = false;  // two fingers moved far enough from their starting points
    std::optional<Tap> last_;
};

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
