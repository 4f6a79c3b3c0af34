#pragma once
// Files of other apps and of iCloud, opened in place.

#import <Foundation/Foundation.h>

#include <string>

NS_ASSUME_NONNULL_BEGIN

/// Holds the access right to one file that the user chose.
@interface DocumentAccess : NSObject

- (instancetype)initWithURL:(NSURL*)url;
/// nil if the file is gone. @param bookmark from an earlier run
+ (nullable instancetype)accessWithBookmark:(NSData*)bookmark;
- (instancetype)init NS_UNAVAILABLE;

@property(nonatomic, readonly) NSURL* url;
/// Identifies the file in a later run; nil if the system gives none.
@property(nonatomic, readonly, nullable) NSData* bookmark;

@end

namespace nacre::app {

/// Empty for nil.
std::string toString(NSString* _Nullable string);
NSString* toNSString(const std::string& text);

/// Returns a file's bytes. Waits until they are downloaded and nobody writes them. Looks for a missing file by name
/// among the app's own documents. @throws Error
std::string readDocument(const std::string& path);

/// A folder of the app, created if missing; nil on failure.
NSURL* _Nullable findFolder(NSSearchPathDirectory kind);

}  // namespace nacre::app

NS_ASSUME_NONNULL_END
