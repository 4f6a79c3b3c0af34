#include "app/apple/ios/sharing.h"

#import <CoreGraphics/CoreGraphics.h>

namespace nacre::app {

NSData* _Nullable encodePng(const PictureBytes& picture) {
    NSData* bytes = [NSData dataWithBytes:picture.rgba.data() length:picture.rgba.size()];
    CGColorSpaceRef space = CGColorSpaceCreateWithName(kCGColorSpaceSRGB);
    CGDataProviderRef provider = CGDataProviderCreateWithCFData((__bridge CFDataRef)bytes);
    CGImageRef image = CGImageCreate(picture.width, picture.height, 8, 32, 4 * size_t{picture.width}, space,
                                     CGBitmapInfo{kCGImageAlphaLast} | kCGBitmapByteOrder32Big, provider, nullptr,
                                     false, kCGRenderingIntentDefault);
    NSData* png = image ? UIImagePNGRepresentation([UIImage imageWithCGImage:image]) : nil;
    CGImageRelease(image);
    CGDataProviderRelease(provider);
    CGColorSpaceRelease(space);
    return png;
}

void share(NSData* data, NSString* name, UIViewController* over, UIView* from) {
    NSURL* file = [[NSURL fileURLWithPath:NSTemporaryDirectory()] URLByAppendingPathComponent:name];
    NSError* error = nil;
    if (![data writeToURL:file options:NSDataWritingAtomic error:&error]) {
        tell(@"Cannot share", error.localizedDescription, over);
        return;
    }
    UIActivityViewController* sheet = [[UIActivityViewController alloc] initWithActivityItems:@[ file ]
                                                                        applicationActivities:nil];
    sheet.popoverPresentationController.sourceView = from;  // iPads need an anchor
    sheet.popoverPresentationController.sourceRect = from.bounds;
    sheet.completionWithItemsHandler = ^(UIActivityType, BOOL, NSArray*, NSError*) {
      [NSFileManager.defaultManager removeItemAtURL:file error:nil];
    };
    [over presentViewController:sheet animated:YES completion:nil];
}

void tell(NSString* title, NSString* _Nullable text, UIViewController* over) {
    UIAlertController* alert = [UIAlertController alertControllerWithTitle:title
                                                                   message:text
                                                            preferredStyle:UIAlertControllerStyleAlert];
    [alert addAction:[UIAlertAction actionWithTitle:@"OK" style:UIAlertActionStyleDefault handler:nil]];
    [over presentViewController:alert animated:YES completion:nil];
}

void ask(NSString* title, NSString* text, UIViewController* over, void (^typed)(NSString* text)) {
    UIAlertController* alert = [UIAlertController alertControllerWithTitle:title
                                                                   message:nil
                                                            preferredStyle:UIAlertControllerStyleAlert];
    [alert addTextFieldWithConfigurationHandler:^(UITextField* field) {
      field.text = text;
    }];
    __weak UIAlertController* weakAlert = alert;
    [alert addAction:[UIAlertAction actionWithTitle:@"Cancel" style:UIAlertActionStyleCancel handler:nil]];
    [alert addAction:[UIAlertAction actionWithTitle:@"OK"
                                              style:UIAlertActionStyleDefault
                                            handler:^(UIAlertAction*) {
                                              if (NSString* line = weakAlert.textFields.firstObject.text) typed(line);
                                            }]];
    [over presentViewController:alert animated:YES completion:nil];
}

}  // namespace nacre::app
