#pragma once
// From Android's input events to the viewer's.

#include <android/input.h>

#include <optional>
#include <vector>

#include "app/viewer/events.h"

namespace nacre::app {

/// What a motion event says of fingers and pens. Places in points.
std::vector<TouchEvent> touchesOf(const AInputEvent* event, double pixelsPerPoint);

struct MouseEvent {
    MouseButton button;  ///< that went down
    TouchEvent touch;
    Modifiers with;
};

/// A mouse with a button down, if it is one.
std::optional<MouseEvent> mouseOf(const AInputEvent* event, double pixelsPerPoint);

struct HoverEvent {
    std::optional<glm::dvec2> at;  ///< points; nothing: it left
};

/// A mouse or a pen that points to something and does not touch it.
std::optional<HoverEvent> hoverOf(const AInputEvent* event, double pixelsPerPoint);

struct WheelEvent {
    double steps;
    glm::dvec2 at;  ///< points
};

/// A wheel's turn, if it is one.
std::optional<WheelEvent> wheelOf(const AInputEvent* event, double pixelsPerPoint);

/// A key that went down, as the viewer's bindings name it.
std::optional<KeyEvent> keyOf(const AInputEvent* event);

/// Seconds of the steady clock at which the event happened.
double secondsOf(const AInputEvent* motion);

}  // namespace nacre::app
