#pragma once
// One scene of the app: the molecule, its overlay, and the menu.

#import <UIKit/UIKit.h>

NS_ASSUME_NONNULL_BEGIN

@interface MoleculeController : UIViewController

/// @param state from -state of an earlier run; may be nil
- (instancetype)initWithState:(nullable NSDictionary*)state;
- (instancetype)initWithNibName:(nullable NSString*)name bundle:(nullable NSBundle*)bundle NS_UNAVAILABLE;
- (instancetype)initWithCoder:(NSCoder*)coder NS_UNAVAILABLE;

/// Opens a file that the user chose, here or in another app.
- (void)openDocument:(NSURL*)url;
/// Restores this scene in a later run; property-list values only.
@property(nonatomic, readonly) NSDictionary* state;

- (void)enterForeground;
- (void)enterBackground;

@end

NS_ASSUME_NONNULL_END
