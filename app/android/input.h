#pragma once
// Converts Android's input events to the viewer's.

#include <android/input.h>

#include <optional>
#include <vector>

#include "app/viewer/events.h"

namespace nacre::app {

/// Touches in a motion event, by fingers and pens. Positions in points.
std::vector<TouchEvent> readTouches(const AInputEvent* event, double pixelsPerPoint);

struct MouseEvent {
    MouseButton button;  ///< the pressed button
    TouchEvent touch;
    Modifiers with;
};

/// A mouse with a pressed button; empty for other events.
std::optional<MouseEvent> readMouse(const AInputEvent* event, double pixelsPerPoint);

struct HoverEvent {
    std::optional<glm::dvec2> at;  ///< points; empty: it left the window
};

/// Whether a finger explores by touch: a screen reader turns it into a hovering one.
bool isExploring(const AInputEvent* event);

/// A mouse or pen that hovers without touching; also a finger that explores.
std::optional<HoverEvent> readHover(const AInputEvent* event, double pixelsPerPoint);

struct WheelEvent {
    double steps;
    glm::dvec2 at;  ///< points
};

/// A wheel's turn; empty for other events.
std::optional<WheelEvent> readWheel(const AInputEvent* event, double pixelsPerPoint);

/// A pressed key, named as in the viewer's bindings.
std::optional<KeyEvent> readKey(const AInputEvent* event);

/// Time of the event, seconds of the steady clock.
double eventSeconds(const AInputEvent* motion);

}  // namespace nacre::app
