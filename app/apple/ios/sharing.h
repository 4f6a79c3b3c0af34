#pragma once

#import <UIKit/UIKit.h>

#include "app/phone/session.h"

NS_ASSUME_NONNULL_BEGIN

namespace nacre::app {

/// The picture as PNG in sRGB; nil if memory is short.
NSData* _Nullable encodePng(const PictureBytes& picture);

/// Shows the share sheet for bytes under a file name. @param from target of its arrow
void share(NSData* data, NSString* name, UIViewController* over, UIView* from);

/// Shows an error or a long text, with one button.
void tell(NSString* title, NSString* _Nullable text, UIViewController* over);

/// Asks for a line of text. @param typed  called with it; not if the user cancels
void ask(NSString* title, NSString* text, UIViewController* over, void (^typed)(NSString* text));

}  // namespace nacre::app

NS_ASSUME_NONNULL_END
