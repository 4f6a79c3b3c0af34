#pragma once
// What stands for libandroid.so and liblog.so: looper, input, configuration, log.

#include <android/configuration.h>
#include <android/input.h>
#include <android/looper.h>
#include <android/native_activity.h>

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

struct AInputEvent {
    struct Pointer {
        std::int32_t id;
        float x, y;  ///< pixels
    };
    std::int32_t type = AINPUT_EVENT_TYPE_MOTION, source = AINPUT_SOURCE_TOUCHSCREEN, action = 0;
    std::vector<Pointer> pointers;
    float scroll = 0;
    std::int64_t time = 0;  ///< nanoseconds
    std::int32_t key = 0, meta = 0, tool = AMOTION_EVENT_TOOL_TYPE_FINGER, buttons = 0;
};

struct AInputQueue {
    std::deque<std::unique_ptr<AInputEvent>> waiting;
    std::map<const AInputEvent*, std::unique_ptr<AInputEvent>> taken;  ///< and not finished yet
    int handled = 0, refused = 0;
    bool inputMethodTakesNext = false;  ///< preDispatchEvent says so once
    ALooper_callbackFunc callback = nullptr;
    void* data = nullptr;

    /// Puts an event in and lets the looper call. @returns whether the app took it for its own
    bool deliver(AInputEvent event);
};

struct AAssetManager {
    std::int32_t density = 160;
};

namespace nacre::test {

/// Lines that the app wrote to the log so far, and forgets them.
std::vector<std::string> takeLog();

/// Work that the app reported, frames in all, and the time that it was said to have, nanoseconds.
int workReports();
std::int64_t workTarget();

/// Activities that asked to be finished.
bool finishAsked(const ANativeActivity* activity);

}  // namespace nacre::test
