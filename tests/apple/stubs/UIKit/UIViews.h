#pragma once
// See Foundation/Foundation.h.

#import <UIKit/UIEvents.h>

#pragma clang assume_nonnull begin
@class UIWindow;

@interface UIColor : NSObject
+ (UIColor*)colorWithRed:(CGFloat)red green:(CGFloat)green blue:(CGFloat)blue alpha:(CGFloat)alpha;
@property(nonatomic, readonly) CGColorRef CGColor;
@end
@interface UIImage : NSObject
+ (nullable UIImage*)systemImageNamed:(NSString*)name;
+ (UIImage*)imageWithCGImage:(CGImageRef)image;
@end
extern "C" NSData* _Nullable UIImagePNGRepresentation(UIImage* image);
typedef NSString* UIFontTextStyle;
extern UIFontTextStyle const UIFontTextStyleBody, UIFontTextStyleHeadline, UIFontTextStyleFootnote;
@interface UIFont : NSObject
+ (UIFont*)preferredFontForTextStyle:(UIFontTextStyle)style;
@end
@interface UIBezierPath : NSObject
+ (instancetype)bezierPath;
+ (instancetype)bezierPathWithOvalInRect:(CGRect)rect;
@property(nonatomic) CGPathRef CGPath;
- (void)moveToPoint:(CGPoint)point;
- (void)addLineToPoint:(CGPoint)point;
- (void)appendPath:(UIBezierPath*)path;
@end
@interface UIScreen : NSObject
@property(class, nonatomic, readonly) UIScreen* mainScreen;
@property(nonatomic, readonly) CGFloat nativeScale;
@property(nonatomic, readonly) NSInteger maximumFramesPerSecond;
@end

// --- layout

@class NSLayoutXAxisAnchor, NSLayoutYAxisAnchor, NSLayoutDimension;
@interface NSLayoutConstraint : NSObject
+ (void)activateConstraints:(NSArray<NSLayoutConstraint*>*)constraints;
@end
@interface NSLayoutAnchor<Kind> : NSObject
- (NSLayoutConstraint*)constraintEqualToAnchor:(NSLayoutAnchor<Kind>*)anchor;
- (NSLayoutConstraint*)constraintEqualToAnchor:(NSLayoutAnchor<Kind>*)anchor constant:(CGFloat)constant;
- (NSLayoutConstraint*)constraintLessThanOrEqualToAnchor:(NSLayoutAnchor<Kind>*)anchor constant:(CGFloat)constant;
@end
@interface NSLayoutXAxisAnchor : NSLayoutAnchor <NSLayoutXAxisAnchor*>
@end
@interface NSLayoutYAxisAnchor : NSLayoutAnchor <NSLayoutYAxisAnchor*>
@end
@interface NSLayoutDimension : NSLayoutAnchor <NSLayoutDimension*>
- (NSLayoutConstraint*)constraintEqualToConstant:(CGFloat)constant;
@end
@interface UILayoutGuide : NSObject
@property(readonly, strong) NSLayoutXAxisAnchor *trailingAnchor, *centerXAnchor;
@property(readonly, strong) NSLayoutYAxisAnchor *topAnchor, *bottomAnchor;
@property(readonly, strong) NSLayoutDimension *widthAnchor, *heightAnchor;
@end

// --- views

typedef struct UIEdgeInsets {
    CGFloat top, left, bottom, right;
} UIEdgeInsets;
typedef NS_OPTIONS(NSUInteger, UIViewAutoresizing) {
    UIViewAutoresizingFlexibleWidth = 1 << 1,
    UIViewAutoresizingFlexibleHeight = 1 << 4,
};
@interface UIView : UIResponder
@property(class, nonatomic, readonly) Class layerClass;
- (instancetype)initWithFrame:(CGRect)frame NS_DESIGNATED_INITIALIZER;
- (nullable instancetype)initWithCoder:(NSCoder*)coder NS_DESIGNATED_INITIALIZER;
@property(nonatomic, readonly, strong) CALayer* layer;
@property(nonatomic, readonly, nullable) UIWindow* window;
@property(nonatomic) CGRect bounds;
@property(nonatomic) CGFloat contentScaleFactor;
@property(nonatomic, getter=isUserInteractionEnabled) BOOL userInteractionEnabled;
@property(nonatomic, getter=isMultipleTouchEnabled) BOOL multipleTouchEnabled;
@property(nonatomic, getter=isHidden) BOOL hidden;
@property(nullable, nonatomic, copy) UIColor* backgroundColor;
@property(null_resettable, nonatomic, strong) UIColor* tintColor;
@property(nonatomic) UIViewAutoresizing autoresizingMask;
@property(nonatomic) BOOL translatesAutoresizingMaskIntoConstraints;
@property(nonatomic, readonly, strong) UILayoutGuide* safeAreaLayoutGuide;
@property(nonatomic, readonly) UIEdgeInsets safeAreaInsets;
@property(nonatomic, readonly, strong) NSLayoutXAxisAnchor *trailingAnchor, *centerXAnchor;
@property(nonatomic, readonly, strong) NSLayoutYAxisAnchor *topAnchor, *bottomAnchor;
@property(nonatomic, readonly, strong) NSLayoutDimension *widthAnchor, *heightAnchor;
- (void)addSubview:(UIView*)view;
- (void)layoutSubviews;
- (void)setNeedsLayout;
- (void)addGestureRecognizer:(UIGestureRecognizer*)recognizer;
@end
@interface UIWindow : UIView
@property(nonatomic, strong) UIScreen* screen;
- (void)makeKeyAndVisible;
@end
typedef NS_ENUM(NSInteger, NSTextAlignment) { NSTextAlignmentLeft, NSTextAlignmentCenter };
@interface UILabel : UIView
@property(nullable, nonatomic, copy) NSString* text;
@property(null_resettable, nonatomic, strong) UIFont* font;
@property(null_resettable, nonatomic, strong) UIColor* textColor;
@property(nonatomic) NSTextAlignment textAlignment;
@property(nonatomic) NSInteger numberOfLines;
@property(nonatomic) BOOL adjustsFontForContentSizeCategory;
@end
@interface UITextView : UIView
@property(null_resettable, nonatomic, copy) NSString* text;
@property(nullable, nonatomic, strong) UIFont* font;
@property(nonatomic, getter=isEditable) BOOL editable;
@property(nonatomic) BOOL adjustsFontForContentSizeCategory;
@end
typedef NS_ENUM(NSInteger, UILayoutConstraintAxis) { UILayoutConstraintAxisHorizontal, UILayoutConstraintAxisVertical };
typedef NS_ENUM(NSInteger, UIStackViewAlignment) { UIStackViewAlignmentFill, UIStackViewAlignmentCenter = 3 };
@interface UIStackView : UIView
- (instancetype)initWithArrangedSubviews:(NSArray<UIView*>*)views;
@property(nonatomic) UILayoutConstraintAxis axis;
@property(nonatomic) UIStackViewAlignment alignment;
@property(nonatomic) CGFloat spacing;
@end

// --- accessibility

typedef uint64_t UIAccessibilityTraits;
extern UIAccessibilityTraits UIAccessibilityTraitImage, UIAccessibilityTraitAdjustable,
    UIAccessibilityTraitAllowsDirectInteraction, UIAccessibilityTraitButton, UIAccessibilityTraitStaticText,
    UIAccessibilityTraitHeader, UIAccessibilityTraitSelected, UIAccessibilityTraitNotEnabled;
@class UIAccessibilityCustomAction;
@interface NSObject (UIAccessibility)
@property(nonatomic) BOOL isAccessibilityElement;
@property(nullable, nonatomic, copy) NSString* accessibilityLabel;
@property(nullable, nonatomic, copy) NSString* accessibilityValue;
@property(nonatomic) UIAccessibilityTraits accessibilityTraits;
@property(nullable, nonatomic, strong) NSArray<UIAccessibilityCustomAction*>* accessibilityCustomActions;
- (void)accessibilityIncrement;
@property(nullable, nonatomic, strong) NSArray* accessibilityElements;
- (void)accessibilityDecrement;
- (BOOL)accessibilityActivate;
@end
@interface UIAccessibilityElement : UIResponder
- (instancetype)initWithAccessibilityContainer:(id)container;
@property(nonatomic, assign) CGRect accessibilityFrameInContainerSpace;
@end
typedef BOOL (^UIAccessibilityCustomActionHandler)(UIAccessibilityCustomAction* action);
@interface UIAccessibilityCustomAction : NSObject
- (instancetype)initWithName:(NSString*)name actionHandler:(nullable UIAccessibilityCustomActionHandler)handler;
@end
typedef uint32_t UIAccessibilityNotifications;
extern UIAccessibilityNotifications UIAccessibilityAnnouncementNotification, UIAccessibilityLayoutChangedNotification;
extern "C" {
void UIAccessibilityPostNotification(UIAccessibilityNotifications notification, id _Nullable argument);
BOOL UIAccessibilityDarkerSystemColorsEnabled(void);
BOOL UIAccessibilityIsReduceTransparencyEnabled(void);
}
#pragma clang assume_nonnull end
