#pragma once
// What stands over the picture: marks at the picked atoms, and what they are and measure, in words. Takes no touches.

#import <UIKit/UIKit.h>

#include "app/apple/label_colors.h"
#include "app/viewer/viewer.h"

NS_ASSUME_NONNULL_BEGIN

@interface OverlayView : UIView

- (void)show:(const nacre::app::Annotations&)annotations colors:(const nacre::app::LabelColors&)colors;

@end

namespace nacre::app {
UIColor* colorOf(const LabelColor& color);
}

NS_ASSUME_NONNULL_END
