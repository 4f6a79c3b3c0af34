#pragma once
// From Android's input events to the viewer's.

#include <android/input.h>

#include <optional>
#include <vector>

#include "app/viewer/events.h"

namespace nacre::app {

/// What a motion event says of fingers, pens and a mouse with a button down. Places in points.
std::vector<TouchEvent> touchesOf(const AInputEvent* event, double pixelsPerPoint);

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
