#pragma once

#import <UIKit/UIKit.h>

NS_ASSUME_NONNULL_BEGIN

namespace nacre::app {

/// What fingers and keys do.
NSString* helpText();

/// Nacre's licence and those of its parts.
void showNotices(UIViewController* over);

}  // namespace nacre::app

NS_ASSUME_NONNULL_END
