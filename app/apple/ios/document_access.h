#pragma once
// Files of other apps and of iCloud, opened in place.

#import <Foundation/Foundation.h>

#include <string>

NS_ASSUME_NONNULL_BEGIN

/// Keeps the right to one file that the user chose.
@interface DocumentAccess : NSObject

- (instancetype)initWithURL:(NSURL*)url;
/// nil where the file is gone. @param bookmark of an earlier run
+ (nullable instancetype)accessWithBookmark:(NSData*)bookmark;
- (instancetype)init NS_UNAVAILABLE;

@property(nonatomic, readonly) NSURL* url;
/// Names the file in a later run; nil where the system gives none.
@property(nonatomic, readonly, nullable) NSData* bookmark;

@end

namespace nacre::app {

/// Empty for nil.
std::string textOf(NSString* _Nullable string);
NSString* stringOf(const std::string& text);

/// A file's bytes, waiting until they are downloaded and no one writes them. A file that is not there is looked for
/// under its name among the app's own documents. @throws Error
std::string readDocument(const std::string& path);

/// The app's folder of a kind, made if it is missing; nil if it cannot be.
NSURL* _Nullable folderOf(NSSearchPathDirectory kind);

}  // namespace nacre::app

NS_ASSUME_NONNULL_END
