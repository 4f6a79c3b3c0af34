#pragma once
// See Foundation/Foundation.h.

#import <QuartzCore/QuartzCore.h>

#pragma clang assume_nonnull begin
@class UIView, UITouch, UIEvent, UIPress, UIPressesEvent;

typedef NS_ENUM(NSInteger, UIEventSubtype) { UIEventSubtypeNone = 0, UIEventSubtypeMotionShake = 1 };

@interface UIResponder : NSObject
- (void)touchesBegan:(NSSet<UITouch*>*)touches withEvent:(nullable UIEvent*)event;
- (void)touchesMoved:(NSSet<UITouch*>*)touches withEvent:(nullable UIEvent*)event;
- (void)touchesEnded:(NSSet<UITouch*>*)touches withEvent:(nullable UIEvent*)event;
- (void)touchesCancelled:(NSSet<UITouch*>*)touches withEvent:(nullable UIEvent*)event;
- (void)motionEnded:(UIEventSubtype)motion withEvent:(nullable UIEvent*)event;
- (void)pressesBegan:(NSSet<UIPress*>*)presses withEvent:(nullable UIPressesEvent*)event;
@property(nonatomic, readonly) BOOL canBecomeFirstResponder;
- (BOOL)becomeFirstResponder;
@end

typedef NS_ENUM(NSInteger, UITouchType) {
    UITouchTypeDirect,
    UITouchTypeIndirect,
    UITouchTypePencil,
    UITouchTypeIndirectPointer __attribute__((availability(ios, introduced = 13.4))),
};
@interface UITouch : NSObject
@property(nonatomic, readonly) NSTimeInterval timestamp;
@property(nonatomic, readonly) UITouchType type;
- (CGPoint)locationInView:(nullable UIView*)view;
@end

typedef NS_ENUM(NSInteger, UIEventType) {
    UIEventTypeTouches,
    UIEventTypeScroll __attribute__((availability(ios, introduced = 13.4))) = 10,
    UIEventTypeHover __attribute__((availability(ios, introduced = 13.4))) = 11,
    UIEventTypeTransform __attribute__((availability(ios, introduced = 13.4))) = 14,
};
typedef NS_OPTIONS(NSInteger, UIEventButtonMask) { UIEventButtonMaskPrimary = 1, UIEventButtonMaskSecondary = 2 };
typedef NS_OPTIONS(NSInteger, UIKeyModifierFlags) {
    UIKeyModifierAlphaShift = 1 << 16,
    UIKeyModifierShift = 1 << 17,
    UIKeyModifierControl = 1 << 18,
    UIKeyModifierAlternate = 1 << 19,
    UIKeyModifierCommand = 1 << 20,
};
@interface UIEvent : NSObject
@property(nonatomic, readonly) UIEventType type;
@property(nonatomic, readonly) UIKeyModifierFlags modifierFlags API_AVAILABLE_IOS(13.4);
@property(nonatomic, readonly) UIEventButtonMask buttonMask API_AVAILABLE_IOS(13.4);
@end

typedef NS_ENUM(long, UIKeyboardHIDUsage) {
    UIKeyboardHIDUsageKeyboardEscape = 0x29,
    UIKeyboardHIDUsageKeyboardHome = 0x4A,
    UIKeyboardHIDUsageKeyboardRightArrow = 0x4F,
    UIKeyboardHIDUsageKeyboardLeftArrow = 0x50,
    UIKeyboardHIDUsageKeyboardDownArrow = 0x51,
    UIKeyboardHIDUsageKeyboardUpArrow = 0x52,
};
API_AVAILABLE_IOS(13.4)
@interface UIKey : NSObject
@property(nonatomic, readonly) NSString* characters;
@property(nonatomic, readonly) NSString* charactersIgnoringModifiers;
@property(nonatomic, readonly) UIKeyModifierFlags modifierFlags;
@property(nonatomic, readonly) UIKeyboardHIDUsage keyCode;
@end
@interface UIPress : NSObject
@property(nonatomic, nullable, readonly) UIKey* key API_AVAILABLE_IOS(13.4);
@end
@interface UIPressesEvent : UIEvent
@end

@class UIGestureRecognizer;
@protocol UIGestureRecognizerDelegate <NSObject>
@optional
- (BOOL)gestureRecognizer:(UIGestureRecognizer*)recognizer
    shouldRecognizeSimultaneouslyWithGestureRecognizer:(UIGestureRecognizer*)other;
- (BOOL)gestureRecognizer:(UIGestureRecognizer*)recognizer shouldReceiveEvent:(UIEvent*)event API_AVAILABLE_IOS(13.4);
@end
@class NSNumber;
typedef NS_ENUM(NSInteger, UIGestureRecognizerState) {
    UIGestureRecognizerStatePossible,
    UIGestureRecognizerStateBegan,
    UIGestureRecognizerStateChanged,
    UIGestureRecognizerStateEnded,
    UIGestureRecognizerStateCancelled,
    UIGestureRecognizerStateFailed,
};
@interface UIGestureRecognizer : NSObject
- (instancetype)initWithTarget:(nullable id)target action:(nullable SEL)action;
- (CGPoint)locationInView:(nullable UIView*)view;
@property(nonatomic, readonly) UIGestureRecognizerState state;
@property(nullable, nonatomic, weak) id<UIGestureRecognizerDelegate> delegate;
@property(nonatomic, copy) NSArray<NSNumber*>* allowedTouchTypes;
@property(nonatomic) BOOL cancelsTouchesInView;
@end
typedef NS_OPTIONS(NSInteger, UIScrollTypeMask) {
    UIScrollTypeMaskDiscrete = 1,
    UIScrollTypeMaskContinuous = 2,
    UIScrollTypeMaskAll = 3,
};
@interface UIPanGestureRecognizer : UIGestureRecognizer
- (CGPoint)translationInView:(nullable UIView*)view;
- (void)setTranslation:(CGPoint)translation inView:(nullable UIView*)view;
@property(nonatomic) UIScrollTypeMask allowedScrollTypesMask API_AVAILABLE_IOS(13.4);
@end
@interface UIHoverGestureRecognizer : UIGestureRecognizer
@end
@interface UIPinchGestureRecognizer : UIGestureRecognizer
@property(nonatomic) CGFloat scale;
@end
@interface UIRotationGestureRecognizer : UIGestureRecognizer
@property(nonatomic) CGFloat rotation;
@end
#pragma clang assume_nonnull end
