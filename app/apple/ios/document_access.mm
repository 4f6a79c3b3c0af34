#import "app/apple/ios/document_access.h"

#include "engine/error.h"

@implementation DocumentAccess {
    BOOL _scoped;
}

- (instancetype)initWithURL:(NSURL*)url {
    if ((self = [super init])) {
        _url = url;
        _scoped = [url startAccessingSecurityScopedResource];  // NO for the app's own files, which need no access right
    }
    return self;
}

+ (nullable instancetype)accessWithBookmark:(NSData*)bookmark {
    BOOL stale = NO;
    NSURL* url = [NSURL URLByResolvingBookmarkData:bookmark
                                           options:0
                                     relativeToURL:nil
                               bookmarkDataIsStale:&stale
                                             error:nil];
    return url ? [[DocumentAccess alloc] initWithURL:url] : nil;
}

- (nullable NSData*)bookmark {
    return [_url bookmarkDataWithOptions:0 includingResourceValuesForKeys:nil relativeToURL:nil error:nil];
}

- (void)dealloc {
    if (_scoped) [_url stopAccessingSecurityScopedResource];
}

@end

namespace nacre::app {

std::string toString(NSString* _Nullable string) {
    const char* text = string.UTF8String;
    return text ? text : "";
}

NSString* toNSString(const std::string& text) {
    NSString* string = [NSString stringWithUTF8String:text.c_str()];
    return string ? string : @"";  // nil if it is not UTF-8
}

NSURL* _Nullable findFolder(NSSearchPathDirectory kind) {
    return [NSFileManager.defaultManager URLForDirectory:kind
                                                inDomain:NSUserDomainMask
                                       appropriateForURL:nil
                                                  create:YES
                                                   error:nil];
}

/// The file itself, or the one of that name among the app's own documents.
static NSURL* present(const std::string& path) {
    NSURL* url = [NSURL fileURLWithPath:toNSString(path)];
    NSString* name = url.lastPathComponent;
    NSURL* own = name ? [findFolder(NSDocumentDirectory) URLByAppendingPathComponent:name] : nil;
    const auto exists = [](NSURL* _Nullable file) {
        NSString* at = file.path;
        return at && [NSFileManager.defaultManager fileExistsAtPath:at];
    };
    return own && !exists(url) && exists(own) ? own : url;
}

std::string readDocument(const std::string& path) {
    NSURL* url = present(path);
    NSError* refusal = nil;
    __block NSError* failure = nil;
    __block NSData* data = nil;
    NSFileCoordinator* coordinator = [[NSFileCoordinator alloc] initWithFilePresenter:nil];
    [coordinator coordinateReadingItemAtURL:url
                                    options:NSFileCoordinatorReadingWithoutChanges
                                      error:&refusal
                                 byAccessor:^(NSURL* current) {
                                   NSError* error = nil;
                                   data = [NSData dataWithContentsOfURL:current
                                                                options:NSDataReadingMappedIfSafe
                                                                  error:&error];
                                   failure = error;
                                 }];
    if (!data)
        throw Error("cannot read molecule", toString(url.lastPathComponent),
                    toString((refusal ? refusal : failure).localizedDescription));
    return std::string(static_cast<const char*>(data.bytes), data.length);
}

}  // namespace nacre::app
