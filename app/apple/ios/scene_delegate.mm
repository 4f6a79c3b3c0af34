#import "app/apple/ios/molecule_controller.h"

@interface SceneDelegate : UIResponder <UIWindowSceneDelegate>
@property(nonatomic, strong, nullable) UIWindow* window;
@end

namespace {
NSString* const kActivity = @"org.nacre.app.view";  // NSUserActivityTypes in Info.plist
}

@implementation SceneDelegate {
    MoleculeController* _controller;
}

- (void)scene:(UIScene*)scene willConnectToSession:(UISceneSession*)session options:(UISceneConnectionOptions*)options {
    NSUserActivity* earlier = session.stateRestorationActivity;
    _controller = [[MoleculeController alloc] initWithState:earlier.userInfo];
    self.window = [[UIWindow alloc] initWithWindowScene:(UIWindowScene*)scene];
    self.window.rootViewController = _controller;
    [self.window makeKeyAndVisible];
    [self scene:scene openURLContexts:options.URLContexts];
}

- (void)scene:(UIScene*)scene openURLContexts:(NSSet<UIOpenURLContext*>*)contexts {
    for (UIOpenURLContext* context in contexts) [_controller openDocument:context.URL];
}

- (nullable NSUserActivity*)stateRestorationActivityForScene:(UIScene*)scene {
    NSUserActivity* activity = [[NSUserActivity alloc] initWithActivityType:kActivity];
    [activity addUserInfoEntriesFromDictionary:_controller.state];
    return activity;
}

- (void)sceneWillEnterForeground:(UIScene*)scene {
    [_controller enterForeground];
}

- (void)sceneDidEnterBackground:(UIScene*)scene {
    [_controller enterBackground];
}

@end
