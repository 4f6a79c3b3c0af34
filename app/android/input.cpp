#include "app/android/input.h"

namespace nacre::app {
namespace {

TouchEvent readTouch(const AInputEvent* event, std::size_t pointer, TouchPhase phase, double pixelsPerPoint) {
    return {AMotionEvent_getPointerId(event, pointer), phase,
            glm::dvec2(AMotionEvent_getX(event, pointer), AMotionEvent_getY(event, pointer)) / pixelsPerPoint};
}

glm::dvec2 eventPosition(const AInputEvent* event, double pixelsPerPoint) {
    return glm::dvec2(AMotionEvent_getX(event, 0), AMotionEvent_getY(event, 0)) / pixelsPerPoint;
}

/// The action without the pointer's index; empty if the event has no pointer.
std::optional<std::int32_t> readAction(const AInputEvent* event) {
    if (AInputEvent_getType(event) != AINPUT_EVENT_TYPE_MOTION) return std::nullopt;
    if ((AInputEvent_getSource(event) & AINPUT_SOURCE_CLASS_MASK) != AINPUT_SOURCE_CLASS_POINTER) return std::nullopt;
    return AMotionEvent_getAction(event) & AMOTION_EVENT_ACTION_MASK;
}

Modifiers toModifiers(std::int32_t meta) { return {(meta & AMETA_SHIFT_ON) != 0, (meta & AMETA_CTRL_ON) != 0}; }

bool isMouse(const AInputEvent* event) { return AMotionEvent_getToolType(event, 0) == AMOTION_EVENT_TOOL_TYPE_MOUSE; }

struct KeyMeaning {
    std::int32_t code;
    char32_t plain, shifted;  ///< shifted: 0 if Shift gives no other character
};

constexpr KeyMeaning kKeys[] = {
    {AKEYCODE_DPAD_LEFT, toKey(SpecialKey::left), 0},
    {AKEYCODE_DPAD_RIGHT, toKey(SpecialKey::right), 0},
    {AKEYCODE_DPAD_UP, toKey(SpecialKey::up), 0},
    {AKEYCODE_DPAD_DOWN, toKey(SpecialKey::down), 0},
    {AKEYCODE_MOVE_HOME, toKey(SpecialKey::home), 0},
    {AKEYCODE_ESCAPE, toKey(SpecialKey::escape), 0},
    {AKEYCODE_SPACE, U' ', 0},
    {AKEYCODE_PLUS, U'+', 0},
    {AKEYCODE_NUMPAD_ADD, U'+', 0},
    {AKEYCODE_EQUALS, U'=', U'+'},
    {AKEYCODE_MINUS, U'-', 0},
    {AKEYCODE_NUMPAD_SUBTRACT, U'-', 0},
    {AKEYCODE_COMMA, U',', 0},
    {AKEYCODE_PERIOD, U'.', 0},
    {AKEYCODE_SLASH, U'/', U'?'},
};

char32_t toCharacter(std::int32_t code, bool shift) {
    if (code >= AKEYCODE_A && code <= AKEYCODE_Z) return U'a' + static_cast<char32_t>(code - AKEYCODE_A);
    if (code >= AKEYCODE_0 && code <= AKEYCODE_9) return shift ? 0 : U'0' + static_cast<char32_t>(code - AKEYCODE_0);
    for (const KeyMeaning& key : kKeys)
        if (key.code == code) return shift && key.shifted ? key.shifted : key.plain;
    return 0;
}

}  // namespace

std::vector<TouchEvent> readTouches(const AInputEvent* event, double pixelsPerPoint) {
    if (!readAction(event) || isMouse(event)) return {};
    const std::int32_t action = AMotionEvent_getAction(event);
    const std::size_t pointers = AMotionEvent_getPointerCount(event);
    const auto which = static_cast<std::size_t>((action & AMOTION_EVENT_ACTION_POINTER_INDEX_MASK) >>
                                                AMOTION_EVENT_ACTION_POINTER_INDEX_SHIFT);
    std::vector<TouchEvent> touches;
    const auto all = [&](TouchPhase phase) {
        for (std::size_t i = 0; i < pointers; ++i) touches.push_back(readTouch(event, i, phase, pixelsPerPoint));
    };
    switch (action & AMOTION_EVENT_ACTION_MASK) {
        case AMOTION_EVENT_ACTION_DOWN:
        case AMOTION_EVENT_ACTION_POINTER_DOWN:
            touches.push_back(readTouch(event, which, TouchPhase::began, pixelsPerPoint));
            break;
        case AMOTION_EVENT_ACTION_MOVE:
            all(TouchPhase::moved);
            break;
        case AMOTION_EVENT_ACTION_UP:
        case AMOTION_EVENT_ACTION_POINTER_UP:
            touches.push_back(readTouch(event, which, TouchPhase::ended, pixelsPerPoint));
            break;
        case AMOTION_EVENT_ACTION_CANCEL:
            all(TouchPhase::cancelled);
            break;
        default:
            break;  // hovering, buttons
    }
    return touches;
}

std::optional<MouseEvent> readMouse(const AInputEvent* event, double pixelsPerPoint) {
    const auto action = readAction(event);
    if (!action || !isMouse(event)) return std::nullopt;
    TouchPhase phase;
    switch (*action) {
        case AMOTION_EVENT_ACTION_DOWN:
            phase = TouchPhase::began;
            break;
        case AMOTION_EVENT_ACTION_MOVE:
            phase = TouchPhase::moved;
            break;
        case AMOTION_EVENT_ACTION_UP:
            phase = TouchPhase::ended;
            break;
        case AMOTION_EVENT_ACTION_CANCEL:
            phase = TouchPhase::cancelled;
            break;
        default:
            return std::nullopt;  // single buttons, which the events above also report
    }
    const std::int32_t buttons = AMotionEvent_getButtonState(event);
    const MouseButton button = buttons & AMOTION_EVENT_BUTTON_SECONDARY  ? MouseButton::right
                               : buttons & AMOTION_EVENT_BUTTON_TERTIARY ? MouseButton::middle
                                                                         : MouseButton::left;
    constexpr std::int64_t kMouse = -1;  // id of the mouse in place of a finger
    return MouseEvent{
        button, {kMouse, phase, eventPosition(event, pixelsPerPoint)}, toModifiers(AMotionEvent_getMetaState(event))};
}

std::optional<HoverEvent> readHover(const AInputEvent* event, double pixelsPerPoint) {
    const auto action = readAction(event);
    if (action == AMOTION_EVENT_ACTION_HOVER_EXIT) return HoverEvent{};
    if (action != AMOTION_EVENT_ACTION_HOVER_ENTER && action != AMOTION_EVENT_ACTION_HOVER_MOVE) return std::nullopt;
    return HoverEvent{eventPosition(event, pixelsPerPoint)};
}

bool isExploring(const AInputEvent* event) {
    return readHover(event, 1) && AMotionEvent_getToolType(event, 0) == AMOTION_EVENT_TOOL_TYPE_FINGER;
}

std::optional<WheelEvent> readWheel(const AInputEvent* event, double pixelsPerPoint) {
    if (readAction(event) != AMOTION_EVENT_ACTION_SCROLL) return std::nullopt;
    return WheelEvent{AMotionEvent_getAxisValue(event, AMOTION_EVENT_AXIS_VSCROLL, 0),
                      eventPosition(event, pixelsPerPoint)};
}

std::optional<KeyEvent> readKey(const AInputEvent* event) {
    if (AInputEvent_getType(event) != AINPUT_EVENT_TYPE_KEY || AKeyEvent_getAction(event) != AKEY_EVENT_ACTION_DOWN)
        return std::nullopt;
    const Modifiers with = toModifiers(AKeyEvent_getMetaState(event));
    const char32_t character = toCharacter(AKeyEvent_getKeyCode(event), with.shift);
    if (character == 0) return std::nullopt;
    return KeyEvent{character, with};
}

double eventSeconds(const AInputEvent* motion) { return 1e-9 * static_cast<double>(AMotionEvent_getEventTime(motion)); }

}  // namespace nacre::app
