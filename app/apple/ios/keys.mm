#include "app/apple/ios/keys.h"

namespace nacre::app {
namespace {

std::optional<char32_t> codeOf(UIKey* key) {
    switch (key.keyCode) {
        case UIKeyboardHIDUsageKeyboardLeftArrow:
            return keyOf(SpecialKey::left);
        case UIKeyboardHIDUsageKeyboardRightArrow:
            return keyOf(SpecialKey::right);
        case UIKeyboardHIDUsageKeyboardUpArrow:
            return keyOf(SpecialKey::up);
        case UIKeyboardHIDUsageKeyboardDownArrow:
            return keyOf(SpecialKey::down);
        case UIKeyboardHIDUsageKeyboardHome:
            return keyOf(SpecialKey::home);
        case UIKeyboardHIDUsageKeyboardEscape:
            return keyOf(SpecialKey::escape);
        default:
            break;
    }
    NSString* typed = key.characters.lowercaseString;
    return typed.length == 1 ? std::optional<char32_t>([typed characterAtIndex:0]) : std::nullopt;
}

}  // namespace

std::optional<ViewerCommand> commandOfKey(UIKey* key) {
    if (key.modifierFlags & (UIKeyModifierCommand | UIKeyModifierAlternate)) return std::nullopt;  // the system's
    const std::optional<char32_t> code = codeOf(key);
    if (!code) return std::nullopt;
    const UIKeyModifierFlags flags = key.modifierFlags;
    return commandOf({*code, {(flags & UIKeyModifierShift) != 0, (flags & UIKeyModifierControl) != 0}});
}

}  // namespace nacre::app
