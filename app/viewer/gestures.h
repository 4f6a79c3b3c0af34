#pragma once
// From fingers to what they mean: rotate, pan, zoom, roll, tap. Knows no molecule and no clock.

#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <vector>

#include "app/viewer/events.h"

namespace nacre::app {

struct Gesture {
    enum class Kind {
        touched,    ///< something came down: whatever moves by itself stops
        rotate,     ///< by `by`
        transform,  ///< pan by `by`, zoom by `scale` and roll by `turn` about `at`
        tap,        ///< at `at`; a double tap's first one is told too
        doubleTap,
        longPress,
        released,  ///< the last finger of a rotation or transformation went
        undo,      ///< three fingers went to the left together
        redo,      ///< and to the right
    };
    Kind kind{};
    glm::dvec2 at{};     ///< points
    glm::dvec2 by{};     ///< points
    double scale = 1.0;  ///< times larger
    double turn = 0.0;   ///< radians, clockwise as seen
};

class TouchGestures {
public:
    static constexpr double kSlop = 8;          ///< points that a tap may wander
    static constexpr double kSwipe = 50;        ///< points that three fingers go, at least
    static constexpr double kTapSeconds = 0.3;  ///< the longest tap
    static constexpr double kLongPressSeconds = 0.5;
    static constexpr double kDoubleTapSeconds = 0.35;  ///< from one tap to the next
    static constexpr double kDoubleTapReach = 40;      ///< points between the two

    std::vector<Gesture> handle(const TouchEvent& event, double now);
    /// What follows from time alone. Call at or after wake().
    std::vector<Gesture> tick(double now);
    /// When tick() will have something to say, if it will.
    std::optional<double> wake() const;
    /// Forgets every finger, as after a pause.
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
    bool wandered_ = false;  // no tap any more: a finger moved, or there were two
    bool dragging_ = false;  // something has been rotated or transformed
    bool pressed_ = false;   // the long press has been told
    bool three_ = false;     // there were so many: what they do is a swipe or nothing
    bool pinching_ = false;  // two fingers have gone far enough apart from where they came down
    std::optional<Tap> last_;
};

}  // namespace nacre::app
