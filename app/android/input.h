#pragma once
// Converts Android's input events to the viewer's.

#include <android/input.h>

#include <optional>
#include <vector>

#include "app/viewer/events.h"

namespace nacre::app {

/// Touches of a motion event by fingers and pens. Positions in points.
std::vector<TouchEvent> touchesOf(const AInputEvent* event, double pixelsPerPoint);

struct MouseEvent {
    MouseButton button;  ///< that was pressed
    TouchEvent touch;
    Modifiers with;
};

/// A mouse with a pressed button; empty for other events.
std::optional<MouseEvent> mouseOf(const AInputEvent* event, double pixelsPerPoint);

struct HoverEvent {
    std::optional<glm::dvec2> at;  ///< points; empty: it left
};

/// A finger that explores by touch, which a screen reader makes a hovering one.
bool isExploring(const AInputEvent* event);

/// A mouse or pen that hovers without touching; for a finger that explores, too.
std::optional<HoverEvent> hoverOf(const AInputEvent* event, double pixelsPerPoint);

struct WheelEvent {
    double steps;
    glm::dvec2 at;  ///< points
};

/// A wheel's turn; empty for other events.
std::optional<WheelEvent> wheelOf(const AInputEvent* event, double pixelsPerPoint);

/// A pressed key, named as in the viewer's bindings.
std::optional<KeyEvent> keyOf(const AInputEvent* event);

/// Time of the event, seconds of the steady clock.
double secondsOf(const AInputEvent* motion);

}  // namespace nacre::app
