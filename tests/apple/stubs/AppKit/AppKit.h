#pragma once
// See Foundation/Foundation.h.

#import <Foundation/Foundation.h>

#pragma clang assume_nonnull begin
typedef uint32_t AEEventClass, AEEventID, AEKeyword;
enum : AEEventClass { kCoreEventClass = 'aevt' };
enum : AEEventID { kAEOpenDocuments = 'odoc' };
enum : AEKeyword { keyDirectObject = '----' };

@interface NSAppleEventDescriptor : NSObject
- (nullable NSAppleEventDescriptor*)paramDescriptorForKeyword:(AEKeyword)keyword;
- (nullable NSAppleEventDescriptor*)descriptorAtIndex:(NSInteger)index;
@property(readonly) NSInteger numberOfItems;
@property(nullable, readonly, copy) NSURL* fileURLValue __attribute__((availability(macos, introduced=10.11)));
@end
@interface NSAppleEventManager : NSObject
+ (NSAppleEventManager*)sharedAppleEventManager;
- (void)setEventHandler:(id)handler
            andSelector:(SEL)selector
          forEventClass:(AEEventClass)eventClass
             andEventID:(AEEventID)eventID;
@end
extern NSNotificationName NSApplicationWillFinishLaunchingNotification;

typedef NSInteger NSModalResponse;
@interface NSAlert : NSObject
@property(copy) NSString* messageText;
@property(copy) NSString* informativeText;
- (NSModalResponse)runModal;
@end
#pragma clang assume_nonnull end
