#pragma once
// Of Apple's Foundation and libdispatch what the apps use, declared as Apple's documentation states it, so that a
// compiler without Apple's SDK checks names, arguments, types, nullability and the systems that have them. Not more: an
// app that uses another call declares it here first.

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef bool BOOL;  // of 64-bit systems
#define YES __objc_yes
#define NO __objc_no
#define nil nullptr
#define API_AVAILABLE_IOS(version) __attribute__((availability(ios, introduced = version)))
#define NS_UNAVAILABLE __attribute__((unavailable))
#define NS_DESIGNATED_INITIALIZER __attribute__((objc_designated_initializer))
#define NS_NOESCAPE __attribute__((noescape))
#define NS_ENUM(type, name) \
    enum name : type name;  \
    enum name : type
#define NS_OPTIONS(type, name) \
    type name;                 \
    enum __attribute__((flag_enum)) : type  // as Apple has it for C++
#define NS_ASSUME_NONNULL_BEGIN _Pragma("clang assume_nonnull begin")
#define NS_ASSUME_NONNULL_END _Pragma("clang assume_nonnull end")
#define FOUNDATION_EXPORT extern "C"
#pragma clang assume_nonnull begin

typedef long NSInteger;
typedef unsigned long NSUInteger;
typedef double CGFloat;
typedef double NSTimeInterval;
typedef unsigned short unichar;
typedef struct objc_selector* SEL;
typedef const void* CFDataRef;
struct CGPoint {
    CGFloat x, y;
};
struct CGSize {
    CGFloat width, height;
};
struct CGRect {
    CGPoint origin;
    CGSize size;
};
typedef struct CGPoint CGPoint;
typedef struct CGSize CGSize;
typedef struct CGRect CGRect;
typedef struct _NSZone NSZone;

typedef void (^dispatch_block_t)(void);
@class NSObject;
typedef NSObject* dispatch_queue_t;
extern "C" {
dispatch_queue_t dispatch_get_main_queue(void);
void dispatch_async(dispatch_queue_t queue, dispatch_block_t block);
typedef NSObject* dispatch_semaphore_t;
typedef unsigned long long dispatch_time_t;
enum : dispatch_time_t { DISPATCH_TIME_NOW = 0 };
dispatch_time_t dispatch_time(dispatch_time_t when, long long delta);
dispatch_semaphore_t dispatch_semaphore_create(long value);
long dispatch_semaphore_wait(dispatch_semaphore_t semaphore, dispatch_time_t timeout);
long dispatch_semaphore_signal(dispatch_semaphore_t semaphore);
}

@class NSString, NSDictionary, NSError, NSData, NSURL, NSArray, NSSet;

@protocol NSObject
- (BOOL)isEqual:(nullable id)object;
- (BOOL)respondsToSelector:(SEL)selector;
@end
__attribute__((objc_root_class))
@interface NSObject<NSObject>
+ (instancetype)alloc;
- (instancetype)init;
- (void)dealloc;
+ (Class)class;
- (BOOL)isKindOfClass:(Class)type;
@end
@protocol NSCopying
@end
@interface NSCoder : NSObject
@end

FOUNDATION_EXPORT NSString* NSStringFromClass(Class type);
FOUNDATION_EXPORT NSString* NSTemporaryDirectory(void);

@interface NSString : NSObject <NSCopying>
@property(readonly) NSUInteger length;
@property(nullable, readonly) const char* UTF8String __attribute__((objc_returns_inner_pointer));
@property(readonly, copy) NSString* lowercaseString;
- (unichar)characterAtIndex:(NSUInteger)index;
- (BOOL)isEqualToString:(NSString*)other;
- (BOOL)hasSuffix:(NSString*)suffix;
- (NSString*)stringByAppendingString:(NSString*)other;
- (nullable NSData*)dataUsingEncoding:(NSUInteger)encoding;
+ (nullable instancetype)stringWithUTF8String:(const char*)text;
+ (instancetype)stringWithFormat:(NSString*)format, ... __attribute__((format(__NSString__, 1, 2)));
@end
@interface NSConstantString : NSString
@end
enum : NSUInteger { NSUTF8StringEncoding = 4 };

@protocol NSFastEnumeration
- (NSUInteger)countByEnumeratingWithState:(void*)state
                                  objects:(id __unsafe_unretained _Nullable[_Nonnull])buffer
                                    count:(NSUInteger)count;
@end

@interface NSArray<__covariant T> : NSObject <NSFastEnumeration>
@property(readonly) NSUInteger count;
@property(nullable, nonatomic, readonly) T firstObject;
- (T)objectAtIndexedSubscript:(NSUInteger)index;
+ (instancetype)arrayWithObjects:(const T _Nonnull[_Nonnull])objects count:(NSUInteger)count;
@end
@interface NSMutableArray<T> : NSArray <T>
+ (instancetype)array;
- (void)addObject:(T)object;
@end
@interface NSSet<__covariant T> : NSObject <NSFastEnumeration>
@property(readonly) NSUInteger count;
@end
@interface NSDictionary<__covariant K, __covariant V> : NSObject <NSFastEnumeration>
- (nullable V)objectForKeyedSubscript:(K)key;
@end
@interface NSMutableDictionary<K, V> : NSDictionary <K, V>
+ (instancetype)dictionary;
- (void)setObject:(nullable V)object forKeyedSubscript:(K<NSCopying>)key;
@end

@interface NSError : NSObject
@property(readonly, copy) NSString* localizedDescription;
@end

typedef NS_OPTIONS(NSUInteger, NSDataReadingOptions) { NSDataReadingMappedIfSafe = 1 };
typedef NS_OPTIONS(NSUInteger, NSDataWritingOptions) { NSDataWritingAtomic = 1 };
@interface NSData : NSObject
@property(readonly) NSUInteger length;
@property(readonly) const void* bytes __attribute__((objc_returns_inner_pointer));
+ (instancetype)dataWithBytes:(nullable const void*)bytes length:(NSUInteger)length;
+ (nullable instancetype)dataWithContentsOfURL:(NSURL*)url
                                       options:(NSDataReadingOptions)options
                                         error:(NSError* _Nullable __autoreleasing* _Nullable)error;
- (BOOL)writeToURL:(NSURL*)url
           options:(NSDataWritingOptions)options
             error:(NSError* _Nullable __autoreleasing* _Nullable)error;
@end

typedef NS_OPTIONS(NSUInteger, NSURLBookmarkCreationOptions) { NSURLBookmarkCreationMinimalBookmark = 1 << 9 };
typedef NS_OPTIONS(NSUInteger, NSURLBookmarkResolutionOptions) { NSURLBookmarkResolutionWithoutUI = 1 << 8 };
@interface NSURL : NSObject <NSCopying>
@property(nullable, readonly, copy) NSString* path;
@property(nullable, readonly, copy) NSString* lastPathComponent;
@property(readonly, getter=isFileURL) BOOL fileURL;
+ (NSURL*)fileURLWithPath:(NSString*)path;
+ (nullable instancetype)URLWithString:(NSString*)text;
- (nullable NSURL*)URLByAppendingPathComponent:(NSString*)component;
- (BOOL)startAccessingSecurityScopedResource;
- (void)stopAccessingSecurityScopedResource;
- (nullable NSData*)bookmarkDataWithOptions:(NSURLBookmarkCreationOptions)options
             includingResourceValuesForKeys:(nullable NSArray<NSString*>*)keys
                              relativeToURL:(nullable NSURL*)relative
                                      error:(NSError* _Nullable __autoreleasing* _Nullable)error;
+ (nullable instancetype)URLByResolvingBookmarkData:(NSData*)bookmark
                                            options:(NSURLBookmarkResolutionOptions)options
                                      relativeToURL:(nullable NSURL*)relative
                                bookmarkDataIsStale:(BOOL* _Nullable)stale
                                              error:(NSError* _Nullable __autoreleasing* _Nullable)error;
@end

@interface NSURLResponse : NSObject
@end
@interface NSHTTPURLResponse : NSURLResponse
@property(readonly) NSInteger statusCode;
@end
@interface NSURLSessionTask : NSObject
@property(readonly) int64_t countOfBytesReceived, countOfBytesExpectedToReceive;
- (void)resume;
- (void)cancel;
@end
@interface NSURLSessionDataTask : NSURLSessionTask
@end
@interface NSURLSession : NSObject
@property(class, readonly, strong) NSURLSession* sharedSession;
- (NSURLSessionDataTask*)dataTaskWithURL:(NSURL*)url
                       completionHandler:(void (^)(NSData* _Nullable data, NSURLResponse* _Nullable response,
                                                   NSError* _Nullable error))completionHandler;
@end

typedef NS_ENUM(NSUInteger, NSSearchPathDirectory) {
    NSDocumentDirectory = 9,
    NSCachesDirectory = 13,
    NSPicturesDirectory = 19,
};
typedef NS_OPTIONS(NSUInteger, NSSearchPathDomainMask) { NSUserDomainMask = 1 };
@interface NSFileManager : NSObject
@property(class, readonly, strong) NSFileManager* defaultManager;
- (BOOL)fileExistsAtPath:(NSString*)path;
- (BOOL)removeItemAtURL:(NSURL*)url error:(NSError* _Nullable __autoreleasing* _Nullable)error;
- (BOOL)changeCurrentDirectoryPath:(NSString*)path;
- (nullable NSURL*)URLForDirectory:(NSSearchPathDirectory)directory
                          inDomain:(NSSearchPathDomainMask)domain
                 appropriateForURL:(nullable NSURL*)url
                            create:(BOOL)create
                             error:(NSError* _Nullable __autoreleasing* _Nullable)error;
@end

typedef NS_OPTIONS(NSUInteger, NSFileCoordinatorReadingOptions) { NSFileCoordinatorReadingWithoutChanges = 1 };
@protocol NSFilePresenter <NSObject>
@end
@interface NSFileCoordinator : NSObject
- (instancetype)initWithFilePresenter:(nullable id<NSFilePresenter>)presenter;
- (void)coordinateReadingItemAtURL:(NSURL*)url
                           options:(NSFileCoordinatorReadingOptions)options
                             error:(NSError* _Nullable __autoreleasing* _Nullable)error
                        byAccessor:(void(NS_NOESCAPE ^)(NSURL* current))reader;
@end

typedef NS_ENUM(NSInteger, NSProcessInfoThermalState) {
    NSProcessInfoThermalStateNominal,
    NSProcessInfoThermalStateFair,
    NSProcessInfoThermalStateSerious,
    NSProcessInfoThermalStateCritical,
};
@interface NSProcessInfo : NSObject
@property(class, readonly, strong) NSProcessInfo* processInfo;
@property(readonly) NSProcessInfoThermalState thermalState API_AVAILABLE_IOS(11.0);
@end

@interface NSBundle : NSObject
@property(class, readonly, strong) NSBundle* mainBundle;
@end

typedef NSString* NSRunLoopMode;
FOUNDATION_EXPORT NSRunLoopMode const NSRunLoopCommonModes;
@class NSTimer;
@interface NSRunLoop : NSObject
@property(class, readonly, strong) NSRunLoop* mainRunLoop;
- (void)addTimer:(NSTimer*)timer forMode:(NSRunLoopMode)mode;
@end
@interface NSTimer : NSObject
+ (NSTimer*)timerWithTimeInterval:(NSTimeInterval)interval repeats:(BOOL)repeats block:(void (^)(NSTimer* timer))block;
- (void)invalidate;
@end

@interface NSUserActivity : NSObject
- (instancetype)initWithActivityType:(NSString*)type;
@property(nullable, copy) NSDictionary* userInfo;
- (void)addUserInfoEntriesFromDictionary:(NSDictionary*)entries;
@end

typedef NSString* NSNotificationName;
@interface NSNotification : NSObject
@end
@interface NSOperationQueue : NSObject
@end
@interface NSNotificationCenter : NSObject
@property(class, readonly, strong) NSNotificationCenter* defaultCenter;
- (void)addObserver:(id)observer
           selector:(SEL)selector
               name:(nullable NSNotificationName)name
             object:(nullable id)object;
@end

#pragma clang assume_nonnull end
