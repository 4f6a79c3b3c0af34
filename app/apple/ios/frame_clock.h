#pragma once
// Calls a step when the display wants a frame, as long as there is one to draw, and not at all after that.

#import <UIKit/UIKit.h>

#include <functional>

NS_ASSUME_NONNULL_BEGIN

@interface FrameClock : NSObject

/// @param step given the seconds that the display takes for a picture; returns when it wants to be called again, in
///             seconds of CACurrentMediaTime(), infinity for never
- (instancetype)initWithStep:(std::function<double(double interval)>)step;
- (instancetype)init NS_UNAVAILABLE;

/// The device is hot: pictures come no more often than 60 times per second.
@property(nonatomic, getter=isHot) BOOL hot;
/// Something happened: step with the next frame of the display.
- (void)wake;
/// Nothing is to be seen: no steps until NO is set.
@property(nonatomic, getter=isSuspended) BOOL suspended;
/// For ever. The clock keeps itself alive until then.
- (void)stop;

@end

NS_ASSUME_NONNULL_END
