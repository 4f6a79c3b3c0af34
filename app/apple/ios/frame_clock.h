#pragma once
// Calls a step for each frame of the display while there is something to draw, and not at all otherwise.

#import <UIKit/UIKit.h>

#include <functional>

NS_ASSUME_NONNULL_BEGIN

@interface FrameClock : NSObject

/// @param step given the display's frame interval, seconds; returns when to call it again, in seconds of
/// CACurrentMediaTime(), infinity for never
- (instancetype)initWithStep:(std::function<double(double interval)>)step;
- (instancetype)init NS_UNAVAILABLE;

/// The device is hot: limits the rate to 60 frames per second.
@property(nonatomic, getter=isHot) BOOL hot;
/// Something happened: step with the next frame of the display.
- (void)wake;
/// Nothing is visible: no steps until set to NO.
@property(nonatomic, getter=isSuspended) BOOL suspended;
/// Final. The clock keeps itself alive until then.
- (void)stop;

@end

NS_ASSUME_NONNULL_END
