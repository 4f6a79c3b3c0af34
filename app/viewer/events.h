#pragma once
// Input events from shells. Positions are in points, the size-independent unit of touch screens (about 1/160 inch) and
// desktops, from the window's top left corner. Times are seconds of any steady clock.

#include <cstdint>
#include <glm/vec2.hpp>

namespace nacre::app {

enum class TouchPhase { began, moved, ended, cancelled };

struct TouchEvent {
    std::int64_t finger = 0;
    TouchPhase phase = TouchPhase::began;
    glm::dvec2 at{};
};

enum class MouseButton { left, middle, right };

struct Modifiers {
    bool shift = false, control = false;
};

/// Keys that are not characters.
enum class SpecialKey : char32_t {
    left = 0x110000,
    right,
    up,
    down,
    home,
    escape,
    pageUp,
    pageDown,
    backspace,
    f1,
    f11,
    f12,
    enter,
    tab,
    remove,
    end
};

/// Widths of areas at the window's edges, pixels.
struct Insets {
    float left = 0, top = 0, right = 0, bottom = 0;
    friend bool operator==(const Insets&, const Insets&) = default;
};

/// A key in the keyboard layout: its character without modifiers, or a SpecialKey.
struct KeyEvent {
    char32_t key = 0;
    Modifiers with;
};
constexpr char32_t toKey(SpecialKey key) { return static_cast<char32_t>(key); }

}  // namespace nacre::app
