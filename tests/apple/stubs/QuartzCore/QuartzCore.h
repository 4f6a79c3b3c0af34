#pragma once
// See Foundation/Foundation.h.

#import <CoreGraphics/CoreGraphics.h>

#pragma clang assume_nonnull begin
extern "C" NSTimeInterval CACurrentMediaTime(void);

@interface CALayer : NSObject
+ (instancetype)layer;
@property(getter=isOpaque) BOOL opaque;
@property CGFloat contentsScale;
@property CGFloat cornerRadius;
@property BOOL masksToBounds;
- (void)addSublayer:(CALayer*)layer;
@end
@interface CAMetalLayer : CALayer
@property CGSize drawableSize;
@end
@interface CAShapeLayer : CALayer
@property(nullable) CGPathRef path;
@property(nullable) CGColorRef fillColor;
@property(nullable) CGColorRef strokeColor;
@property CGFloat lineWidth;
@end
@interface CATransaction : NSObject
@property(class) BOOL disableActions;
+ (void)begin;
+ (void)commit;
@end

struct CAFrameRateRange {
    float minimum, maximum, preferred;
};
typedef struct CAFrameRateRange CAFrameRateRange;
extern "C" CAFrameRateRange CAFrameRateRangeMake(float minimum, float maximum, float preferred) API_AVAILABLE_IOS(15.0);
@interface CADisplayLink : NSObject
+ (CADisplayLink*)displayLinkWithTarget:(id)target selector:(SEL)selector;
- (void)addToRunLoop:(NSRunLoop*)loop forMode:(NSRunLoopMode)mode;
- (void)invalidate;
@property(readonly, nonatomic) NSTimeInterval timestamp, duration, targetTimestamp;
@property(getter=isPaused, nonatomic) BOOL paused;
@property(nonatomic) CAFrameRateRange preferredFrameRateRange API_AVAILABLE_IOS(15.0);
@end
#pragma clang assume_nonnull end
