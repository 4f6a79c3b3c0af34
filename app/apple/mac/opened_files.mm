#include "app/apple/mac/opened_files.h"

#import <AppKit/AppKit.h>

#include <utility>

@interface OpenedFiles : NSObject
@end

@implementation OpenedFiles {
@public
    std::vector<std::string> _paths;
    std::function<void()> _opened;
}

/// AppKit's own handler is installed by now, and would ask GLFW's delegate, which does not handle files.
- (void)willFinishLaunching:(NSNotification*)notification {
    [NSAppleEventManager.sharedAppleEventManager setEventHandler:self
                                                     andSelector:@selector(openFiles:reply:)
                                                   forEventClass:kCoreEventClass
                                                      andEventID:kAEOpenDocuments];
}

- (void)openFiles:(NSAppleEventDescriptor*)event reply:(NSAppleEventDescriptor*)reply {
    NSAppleEventDescriptor* files = [event paramDescriptorForKeyword:keyDirectObject];
    for (NSInteger i = 1; i <= files.numberOfItems; ++i) {
        NSURL* file = [files descriptorAtIndex:i].fileURLValue;
        const char* path = file.path.UTF8String;
        if (path) _paths.emplace_back(path);
    }
    if (_opened) _opened();
}

@end

namespace nacre::app {
namespace {

OpenedFiles* listener() {
    static OpenedFiles* const only = [[OpenedFiles alloc] init];
    return only;
}

}  // namespace

void listenForOpenedFiles(std::function<void()> opened) {
    listener()->_opened = std::move(opened);
    [NSNotificationCenter.defaultCenter addObserver:listener()
                                           selector:@selector(willFinishLaunching:)
                                               name:NSApplicationWillFinishLaunchingNotification
                                             object:nil];
}

std::vector<std::string> takeOpenedFiles() { return std::exchange(listener()->_paths, {}); }

}  // namespace nacre::app
