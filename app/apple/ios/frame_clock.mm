#import "app/apple/ios/frame_clock.h"

#import <QuartzCore/QuartzCore.h>

#include <cmath>

@implementation FrameClock {
    std::function<double(double)> _step;
    CADisplayLink* _link;
    NSTimer* _alarm;
}

- (instancetype)initWithStep:(std::function<double(double)>)step {
    if ((self = [super init])) {
        _step = std::move(step);
        _link = [CADisplayLink displayLinkWithTarget:self selector:@selector(frame:)];
        self.hot = NO;
        [_link addToRunLoop:NSRunLoop.mainRunLoop forMode:NSRunLoopCommonModes];
    }
    return self;
}

- (void)frame:(CADisplayLink*)link {
    const double now = CACurrentMediaTime();
    // The current rate, not the best: displays slow down in low power mode, and when hot.
    const double next = _step(link.targetTimestamp - link.timestamp);
    if (next <= now + link.duration) return;
    link.paused = YES;
    [_alarm invalidate];
    _alarm = nil;
    if (!std::isfinite(next)) return;
    __weak FrameClock* weakSelf = self;
    _alarm = [NSTimer timerWithTimeInterval:next - now
                                    repeats:NO
                                      block:^(NSTimer*) {
                                        [weakSelf wake];
                                      }];
    [NSRunLoop.mainRunLoop addTimer:_alarm forMode:NSRunLoopCommonModes];
}

- (void)setHot:(BOOL)hot {
    _hot = hot;
    const float best = static_cast<float>(UIScreen.mainScreen.maximumFramesPerSecond);
    const float most = hot && best > 60 ? 60 : best;
    // A 120 Hz display keeps that rate if the minimum is 80.
    _link.preferredFrameRateRange = CAFrameRateRangeMake(most > 60 ? 80 : 30, most, most);
}

- (void)wake {
    if (!_suspended) _link.paused = NO;
}

- (void)setSuspended:(BOOL)suspended {
    _suspended = suspended;
    [_alarm invalidate];
    _alarm = nil;
    _link.paused = suspended;
}

- (void)stop {
    self.suspended = YES;
    [_link invalidate];
    _step = nullptr;
}

@end
