// Nacre.app: `nacre view`, started by the Finder.

#import <AppKit/AppKit.h>

#include <exception>

#include "app/desktop/view_command.h"

namespace {

/// Pictures are saved in the current folder, which is the root for apps started by the Finder.
void goToPictures() {
    NSFileManager* files = NSFileManager.defaultManager;
    NSURL* pictures = [files URLForDirectory:NSPicturesDirectory
                                    inDomain:NSUserDomainMask
                           appropriateForURL:nil
                                      create:YES
                                       error:nil];
    NSString* path = pictures.path;
    if (path) [files changeCurrentDirectoryPath:path];
}

void tell(const char* why) {
    NSString* text = [NSString stringWithUTF8String:why];
    NSAlert* alert = [[NSAlert alloc] init];
    alert.messageText = @"Nacre has to quit";
    alert.informativeText = text ? text : @"";
    [alert runModal];
}

}  // namespace

int main() {
    @autoreleasepool {
        goToPictures();
        try {
            nacre::app::ViewOptions options;
            options.restore = true;
            nacre::app::viewCommand(options);
            return 0;
        } catch (const std::exception& error) {
            tell(error.what());
            return 1;
        }
    }
}
