#import "app/apple/ios/molecule_view.h"

#import <QuartzCore/QuartzCore.h>

#include <cmath>
#include <optional>

using nacre::app::Gesture;
using nacre::app::MouseButton;
using nacre::app::SpecialKey;
using nacre::app::TouchEvent;
using nacre::app::TouchPhase;
using nacre::app::ViewerCommand;

namespace {

constexpr std::int64_t kPointer = -1;  // id of the pointer, used like a finger's
constexpr double kPointsPerStep = 40;  // of a two-finger scroll per step of a wheel

glm::dvec2 toVector(CGPoint point) { return {point.x, point.y}; }

std::int64_t touchId(UITouch* touch) { return reinterpret_cast<std::intptr_t>((__bridge void*)touch); }

nacre::app::Modifiers toModifiers(UIKeyModifierFlags flags) {
    return {(flags & UIKeyModifierShift) != 0, (flags & UIKeyModifierControl) != 0};
}

std::optional<char32_t> toCode(UIKey* key) {
    switch (key.keyCode) {
        case UIKeyboardHIDUsageKeyboardLeftArrow:
            return nacre::app::toKey(SpecialKey::left);
        case UIKeyboardHIDUsageKeyboardRightArrow:
            return nacre::app::toKey(SpecialKey::right);
        case UIKeyboardHIDUsageKeyboardUpArrow:
            return nacre::app::toKey(SpecialKey::up);
        case UIKeyboardHIDUsageKeyboardDownArrow:
            return nacre::app::toKey(SpecialKey::down);
        case UIKeyboardHIDUsageKeyboardHome:
            return nacre::app::toKey(SpecialKey::home);
        case UIKeyboardHIDUsageKeyboardEscape:
            return nacre::app::toKey(SpecialKey::escape);
        default:
            break;
    }
    NSString* typed = key.characters.lowercaseString;
    return typed.length == 1 ? std::optional<char32_t>([typed characterAtIndex:0]) : std::nullopt;
}

/// The command of a hardware key, from the table shared by all shells.
std::optional<ViewerCommand> commandOfKey(UIKey* key) {
    if (key.modifierFlags & (UIKeyModifierCommand | UIKeyModifierAlternate)) return std::nullopt;  // the system's
    const std::optional<char32_t> code = toCode(key);
    return code ? nacre::app::findCommand({*code, toModifiers(key.modifierFlags)}) : std::nullopt;
}

}  // namespace

@interface MoleculeView () <UIGestureRecognizerDelegate>
@end

@implementation MoleculeView {
    MouseButton _held;
}

+ (Class)layerClass {
    return CAMetalLayer.class;
}

- (instancetype)initWithFrame:(CGRect)frame {
    if ((self = [super initWithFrame:frame])) {
        self.multipleTouchEnabled = YES;
        self.metalLayer.opaque = YES;
        // These three recognise no UIKit touches: their events come only from trackpads and wheels.
        UIPanGestureRecognizer* scroll = [[UIPanGestureRecognizer alloc] initWithTarget:self action:@selector(scroll:)];
        scroll.allowedScrollTypesMask = UIScrollTypeMaskAll;
        UIPinchGestureRecognizer* pinch = [[UIPinchGestureRecognizer alloc] initWithTarget:self
                                                                                    action:@selector(pinch:)];
        UIRotationGestureRecognizer* twist = [[UIRotationGestureRecognizer alloc] initWithTarget:self
                                                                                          action:@selector(twist:)];
        for (UIGestureRecognizer* recognizer in @[ scroll, pinch, twist ]) {
            recognizer.delegate = self;
            recognizer.allowedTouchTypes = @[];
            recognizer.cancelsTouchesInView = NO;
            [self addGestureRecognizer:recognizer];
        }
        [self addGestureRecognizer:[[UIHoverGestureRecognizer alloc] initWithTarget:self action:@selector(hover:)]];
    }
    return self;
}

- (CAMetalLayer*)metalLayer {
    return static_cast<CAMetalLayer*>(self.layer);
}

- (nacre::PixelSize)pixels {
    const CGSize size = self.metalLayer.drawableSize;
    return {static_cast<std::uint32_t>(std::lround(size.width)), static_cast<std::uint32_t>(std::lround(size.height))};
}

- (void)layoutSubviews {
    [super layoutSubviews];
    const CGFloat scale = self.window ? self.window.screen.nativeScale : self.contentScaleFactor;
    self.contentScaleFactor = scale;
    self.metalLayer.contentsScale = scale;
    self.metalLayer.drawableSize =
        CGSizeMake(std::round(self.bounds.size.width * scale), std::round(self.bounds.size.height * scale));
    [self.delegate moleculeViewResized:self];
}

// --- fingers, pencil, mouse

- (void)forward:(NSSet<UITouch*>*)touches event:(nullable UIEvent*)event phase:(TouchPhase)phase {
    if (!self.session) return;
    for (UITouch* touch in touches) {
        const glm::dvec2 at = toVector([touch locationInView:self]);
        if (touch.type == UITouchTypeIndirectPointer)
            [self mouse:at event:event phase:phase when:touch.timestamp];
        else
            self.session->touch({touchId(touch), phase, at}, touch.timestamp);
    }
    [self.delegate moleculeViewTouched:self];
}

- (void)mouse:(glm::dvec2)at event:(nullable UIEvent*)event phase:(TouchPhase)phase when:(double)when {
    if (phase == TouchPhase::began)
        _held = event.buttonMask & UIEventButtonMaskSecondary ? MouseButton::right : MouseButton::left;
    self.session->mouse(_held, {kPointer, phase, at}, toModifiers(event.modifierFlags), when);
}

- (void)touchesBegan:(NSSet<UITouch*>*)touches withEvent:(UIEvent*)event {
    [self becomeFirstResponder];
    [self forward:touches event:event phase:TouchPhase::began];
}
- (void)touchesMoved:(NSSet<UITouch*>*)touches withEvent:(UIEvent*)event {
    [self forward:touches event:event phase:TouchPhase::moved];
}
- (void)touchesEnded:(NSSet<UITouch*>*)touches withEvent:(UIEvent*)event {
    [self forward:touches event:event phase:TouchPhase::ended];
}
- (void)touchesCancelled:(NSSet<UITouch*>*)touches withEvent:(UIEvent*)event {
    [self forward:touches event:event phase:TouchPhase::cancelled];
}

// --- wheel and trackpad

- (BOOL)gestureRecognizer:(UIGestureRecognizer*)recognizer shouldReceiveEvent:(UIEvent*)event {
    return event.type == UIEventTypeScroll || event.type == UIEventTypeTransform;
}

- (BOOL)gestureRecognizer:(UIGestureRecognizer*)recognizer
    shouldRecognizeSimultaneouslyWithGestureRecognizer:(UIGestureRecognizer*)other {
    return YES;
}

- (void)scroll:(UIPanGestureRecognizer*)recognizer {
    if (!self.session) return;
    self.session->wheel([recognizer translationInView:self].y / kPointsPerStep,
                        toVector([recognizer locationInView:self]));
    [recognizer setTranslation:CGPointZero inView:self];
    [self.delegate moleculeViewTouched:self];
}

/// A pointer or a pencil above the glass.
- (void)hover:(UIHoverGestureRecognizer*)recognizer {
    if (!self.session) return;
    const BOOL there =
        recognizer.state == UIGestureRecognizerStateBegan || recognizer.state == UIGestureRecognizerStateChanged;
    self.session->hover(there ? std::optional(toVector([recognizer locationInView:self])) : std::nullopt);
    [self.delegate moleculeViewTouched:self];
}

- (void)transform:(UIGestureRecognizer*)recognizer scale:(double)scale turn:(double)turn {
    if (!self.session) return;
    Gesture gesture;
    gesture.kind = Gesture::Kind::transform;
    gesture.at = toVector([recognizer locationInView:self]);
    gesture.scale = scale;
    gesture.turn = turn;
    self.session->viewer().gesture(gesture, CACurrentMediaTime());
    [self.delegate moleculeViewTouched:self];
}

- (void)pinch:(UIPinchGestureRecognizer*)recognizer {
    [self transform:recognizer scale:recognizer.scale turn:0];
    recognizer.scale = 1;
}

- (void)twist:(UIRotationGestureRecognizer*)recognizer {
    [self transform:recognizer scale:1 turn:recognizer.rotation];
    recognizer.rotation = 0;
}

// --- keys

- (void)run:(ViewerCommand)command {
    if (self.session) self.session->run(command);
    [self.delegate moleculeViewTouched:self];
}

- (BOOL)canBecomeFirstResponder {
    return YES;
}

- (void)pressesBegan:(NSSet<UIPress*>*)presses withEvent:(nullable UIPressesEvent*)event {
    BOOL known = NO;
    for (UIPress* press in presses) {
        UIKey* key = press.key;
        const auto command = key ? commandOfKey(key) : std::nullopt;
        if (!command) continue;
        known = YES;
        [self run:*command];
    }
    if (!known) [super pressesBegan:presses withEvent:event];
}

@end
