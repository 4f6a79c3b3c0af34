#include "app/apple/ios/fetching.h"

#include "app/apple/ios/document_access.h"

#import <Foundation/Foundation.h>

#include <algorithm>

#include "app/download/http.h"

namespace nacre::app {
namespace {

constexpr std::int64_t kGlance = 100'000'000;  // nanoseconds between checks for new data

}  // namespace

void fetchBySystem(const std::string& url, const HttpTake& take) {
    NSURL* address = [NSURL URLWithString:toNSString(url)];
    if (!address) throw HttpFailure("invalid address", false);
    __block NSData* bytes = nil;
    __block NSInteger status = 0;
    __block std::string failed;
    dispatch_semaphore_t done = dispatch_semaphore_create(0);
    NSURLSessionDataTask* task =
        [NSURLSession.sharedSession dataTaskWithURL:address
                                  completionHandler:^(NSData* data, NSURLResponse* response, NSError* error) {
                                    bytes = data;
                                    if ([response isKindOfClass:NSHTTPURLResponse.class])
                                        status = static_cast<NSHTTPURLResponse*>(response).statusCode;
                                    if (error) failed = error.localizedDescription.UTF8String;
                                    dispatch_semaphore_signal(done);
                                  }];
    [task resume];
    while (dispatch_semaphore_wait(done, dispatch_time(DISPATCH_TIME_NOW, kGlance)) != 0) {
        try {
            const auto come = std::max<std::int64_t>(task.countOfBytesReceived, 0);
            const auto all = std::max<std::int64_t>(task.countOfBytesExpectedToReceive, 0);
            take({}, static_cast<std::uint64_t>(come), static_cast<std::uint64_t>(all));  // throws if cancelled
        } catch (...) {
            [task cancel];
            throw;
        }
    }
    if (!failed.empty()) throw HttpFailure(failed, false);
    if (status == 404) throw HttpFailure("there is no such entry (404)", false);
    if (status != 200) throw HttpFailure("the server answers " + std::to_string(status), false);
    take({static_cast<const char*>(bytes.bytes), bytes.length}, bytes.length, bytes.length);
}

}  // namespace nacre::app
