#pragma once
// See Foundation/Foundation.h.

#import <Foundation/Foundation.h>

#pragma clang assume_nonnull begin
typedef struct CGPath* CGPathRef;
typedef struct CGColor* CGColorRef;
typedef struct CGColorSpace* CGColorSpaceRef;
typedef struct CGDataProvider* CGDataProviderRef;
typedef struct CGImage* CGImageRef;
typedef const NSString* CFStringRef;

typedef NS_ENUM(uint32_t, CGImageAlphaInfo) {
    kCGImageAlphaNone,
    kCGImageAlphaPremultipliedLast,
    kCGImageAlphaLast = 3
};
typedef NS_OPTIONS(uint32_t, CGBitmapInfo) { kCGBitmapByteOrderDefault = 0, kCGBitmapByteOrder32Big = 4 << 12 };
typedef NS_ENUM(int32_t, CGColorRenderingIntent) { kCGRenderingIntentDefault };

extern "C" {
extern const CFStringRef kCGColorSpaceSRGB;
extern const CGPoint CGPointZero;
CGColorSpaceRef _Nullable CGColorSpaceCreateWithName(CFStringRef _Nullable name);
void CGColorSpaceRelease(CGColorSpaceRef _Nullable space);
CGDataProviderRef _Nullable CGDataProviderCreateWithCFData(CFDataRef _Nullable data);
void CGDataProviderRelease(CGDataProviderRef _Nullable provider);
CGImageRef _Nullable CGImageCreate(size_t width, size_t height, size_t bitsPerComponent, size_t bitsPerPixel,
                                   size_t bytesPerRow, CGColorSpaceRef _Nullable space, CGBitmapInfo info,
                                   CGDataProviderRef _Nullable provider, const CGFloat* _Nullable decode,
                                   bool shouldInterpolate, CGColorRenderingIntent intent);
void CGImageRelease(CGImageRef _Nullable image);
}
inline CGPoint CGPointMake(CGFloat x, CGFloat y) { return {x, y}; }
inline CGSize CGSizeMake(CGFloat width, CGFloat height) { return {width, height}; }
inline CGRect CGRectMake(CGFloat x, CGFloat y, CGFloat width, CGFloat height) { return {{x, y}, {width, height}}; }
#pragma clang assume_nonnull end
