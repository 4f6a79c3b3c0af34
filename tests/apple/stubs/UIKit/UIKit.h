#pragma once
// See Foundation/Foundation.h.

#import <QuartzCore/QuartzCore.h>
#import <UIKit/UIEvents.h>
#import <UIKit/UIViews.h>

#pragma clang assume_nonnull begin

// --- menus

@interface UIMenuElement : NSObject
@end
typedef NS_ENUM(NSInteger, UIMenuElementState) { UIMenuElementStateOff, UIMenuElementStateOn };
typedef NS_OPTIONS(NSUInteger, UIMenuOptions) { UIMenuOptionsDisplayInline = 1 };
@interface UIMenu : UIMenuElement
+ (UIMenu*)menuWithTitle:(NSString*)title
                   image:(nullable UIImage*)image
              identifier:(nullable NSString*)identifier
                 options:(UIMenuOptions)options
                children:(NSArray<UIMenuElement*>*)children;
@end
@interface UIAction : UIMenuElement
+ (instancetype)actionWithTitle:(NSString*)title
                          image:(nullable UIImage*)image
                     identifier:(nullable NSString*)identifier
                        handler:(void (^)(__kindof UIAction* action))handler;
@property(nonatomic) UIMenuElementState state;
@end
API_AVAILABLE_IOS(14.0)
@interface UIDeferredMenuElement : UIMenuElement
+ (instancetype)elementWithUncachedProvider:(void (^)(void (^completion)(NSArray<UIMenuElement*>* elements)))provider
    API_AVAILABLE_IOS(15.0);
@end

typedef NS_ENUM(NSInteger, UIButtonType) { UIButtonTypeCustom, UIButtonTypeSystem };
typedef NS_OPTIONS(NSUInteger, UIControlState) { UIControlStateNormal = 0 };
@interface UIControl : UIView
@end
@interface UIButton : UIControl
+ (instancetype)buttonWithType:(UIButtonType)type;
- (void)setImage:(nullable UIImage*)image forState:(UIControlState)state;
@property(nonatomic, readwrite, copy, nullable) UIMenu* menu API_AVAILABLE_IOS(14.0);
@property(nonatomic) BOOL showsMenuAsPrimaryAction API_AVAILABLE_IOS(14.0);
@end

// --- controllers

typedef NS_ENUM(NSInteger, UIUserInterfaceStyle) {
    UIUserInterfaceStyleUnspecified,
    UIUserInterfaceStyleLight,
    UIUserInterfaceStyleDark
};
@interface UITraitCollection : NSObject
@property(nonatomic, readonly) UIUserInterfaceStyle userInterfaceStyle;
@end
@class UIPopoverPresentationController;
@interface UIViewController : UIResponder
- (instancetype)initWithNibName:(nullable NSString*)name bundle:(nullable NSBundle*)bundle NS_DESIGNATED_INITIALIZER;
- (nullable instancetype)initWithCoder:(NSCoder*)coder NS_DESIGNATED_INITIALIZER;
@property(null_resettable, nonatomic, strong) UIView* view;
@property(nonatomic, readonly) UITraitCollection* traitCollection;
- (void)loadViewIfNeeded;
@property(nullable, nonatomic, readonly) UIPopoverPresentationController* popoverPresentationController;
- (void)viewDidLoad;
- (void)viewDidAppear:(BOOL)animated;
- (void)didReceiveMemoryWarning;
- (void)traitCollectionDidChange:(nullable UITraitCollection*)previous;
- (void)presentViewController:(UIViewController*)controller
                     animated:(BOOL)animated
                   completion:(void (^__nullable)(void))completion;
@end
@interface UIPopoverPresentationController : NSObject
@property(nullable, nonatomic, strong) UIView* sourceView;
@property(nonatomic, assign) CGRect sourceRect;
@end
typedef NSString* UIActivityType;
typedef void (^UIActivityViewControllerCompletionWithItemsHandler)(UIActivityType _Nullable type, BOOL completed,
                                                                   NSArray* _Nullable items, NSError* _Nullable error);
@interface UIActivityViewController : UIViewController
- (instancetype)initWithActivityItems:(NSArray*)items
                applicationActivities:(nullable NSArray*)activities NS_DESIGNATED_INITIALIZER;
@property(nullable, nonatomic, copy) UIActivityViewControllerCompletionWithItemsHandler completionWithItemsHandler;
@end
typedef NS_ENUM(NSInteger, UIAlertControllerStyle) { UIAlertControllerStyleActionSheet, UIAlertControllerStyleAlert };
typedef NS_ENUM(NSInteger, UIAlertActionStyle) { UIAlertActionStyleDefault, UIAlertActionStyleCancel };
@interface UIAlertAction : NSObject
+ (instancetype)actionWithTitle:(nullable NSString*)title
                          style:(UIAlertActionStyle)style
                        handler:(void (^__nullable)(UIAlertAction* action))handler;
@end
@interface UITextField : UIView
@property(nullable, nonatomic, copy) NSString* text;
@end
@interface UIAlertController : UIViewController
+ (instancetype)alertControllerWithTitle:(nullable NSString*)title
                                 message:(nullable NSString*)message
                          preferredStyle:(UIAlertControllerStyle)style;
- (void)addAction:(UIAlertAction*)action;
- (void)addTextFieldWithConfigurationHandler:(void (^__nullable)(UITextField* textField))configurationHandler;
@property(nullable, nonatomic, readonly) NSArray<UITextField*>* textFields;
@end

@class UTType, UIDocumentPickerViewController;
@protocol UIDocumentPickerDelegate <NSObject>
@optional
- (void)documentPicker:(UIDocumentPickerViewController*)controller didPickDocumentsAtURLs:(NSArray<NSURL*>*)urls;
@end
@interface UIDocumentPickerViewController : UIViewController
- (instancetype)initForOpeningContentTypes:(NSArray<UTType*>*)types NS_DESIGNATED_INITIALIZER API_AVAILABLE_IOS(14.0);
@property(nullable, nonatomic, weak) id<UIDocumentPickerDelegate> delegate;
@end

// --- app and scenes

@interface UIScene : UIResponder
@property(null_resettable, nonatomic, copy) NSString* title;
@end
@interface UIWindowScene : UIScene
@end
@interface UIWindow (Scenes)
- (instancetype)initWithWindowScene:(UIWindowScene*)scene;
@property(nonatomic, weak, nullable) UIWindowScene* windowScene;
@property(nullable, nonatomic, strong) UIViewController* rootViewController;
@end
@interface UISceneSession : NSObject
@property(nullable, nonatomic, readonly) NSUserActivity* stateRestorationActivity;
@end
@interface UIOpenURLContext : NSObject
@property(nonatomic, readonly, copy) NSURL* URL;
@end
@interface UISceneConnectionOptions : NSObject
@property(nonatomic, readonly, copy) NSSet<UIOpenURLContext*>* URLContexts;
@end
@protocol UISceneDelegate <NSObject>
@optional
- (void)scene:(UIScene*)scene willConnectToSession:(UISceneSession*)session options:(UISceneConnectionOptions*)options;
- (void)scene:(UIScene*)scene openURLContexts:(NSSet<UIOpenURLContext*>*)contexts;
- (nullable NSUserActivity*)stateRestorationActivityForScene:(UIScene*)scene;
- (void)sceneWillEnterForeground:(UIScene*)scene;
- (void)sceneDidEnterBackground:(UIScene*)scene;
@end
@protocol UIWindowSceneDelegate <UISceneDelegate>
@optional
@property(nullable, nonatomic, strong) UIWindow* window;
@end
@protocol UIApplicationDelegate <NSObject>
@end
extern "C" int UIApplicationMain(int argc, char* _Nullable argv[_Nonnull], NSString* _Nullable principal,
                                 NSString* _Nullable delegate);
@interface UIDevice : NSObject
@property(class, nonatomic, readonly) UIDevice* currentDevice;
@property(nonatomic, readonly, strong) NSString* systemName;
@property(nonatomic, readonly, strong) NSString* systemVersion;
@property(nonatomic, readonly, strong) NSString* model;
@end

@interface UIPasteboard : NSObject
@property(class, nonatomic, readonly) UIPasteboard* generalPasteboard;
@property(nullable, nonatomic, copy) NSString* string;
@end

@interface UIFontMetrics : NSObject
@property(class, readonly, strong) UIFontMetrics* defaultMetrics;
- (CGFloat)scaledValueForValue:(CGFloat)value;
@end

#pragma clang assume_nonnull end
