#pragma once
// See Foundation/Foundation.h.

#import <Foundation/Foundation.h>

#pragma clang assume_nonnull begin
API_AVAILABLE_IOS(14.0)
@interface UTType : NSObject
+ (nullable instancetype)typeWithIdentifier:(NSString*)identifier;
@end
extern UTType* const UTTypeData API_AVAILABLE_IOS(14.0);
#pragma clang assume_nonnull end
