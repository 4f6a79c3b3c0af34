#pragma once
// One scene of the app: the molecule, what stands over it, and the menu.

#import <UIKit/UIKit.h>

NS_ASSUME_NONNULL_BEGIN

@interface MoleculeController : UIViewController

/// @param state what -state gave in an earlier run; may be nil
- (instancetype)initWithState:(nullable NSDictionary*)state;
- (instancetype)initWithNibName:(nullable NSString*)name bundle:(nullable NSBundle*)bundle NS_UNAVAILABLE;
- (instancetype)initWithCoder:(NSCoder*)coder NS_UNAVAILABLE;

/// A file that was chosen, here or in another app.
- (void)openDocument:(NSURL*)url;
/// What restores this scene; property-list values alone.
@property(nonatomic, readonly) NSDictionary* state;

- (void)enterForeground;
- (void)enterBackground;

@end

NS_ASSUME_NONNULL_END
