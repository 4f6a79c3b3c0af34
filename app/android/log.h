#pragma once

#include <android/log.h>

namespace nacre::app {

/// A line in the device's log.
inline void logError(const char* text) { __android_log_print(ANDROID_LOG_ERROR, "nacre", "%s", text); }

}  // namespace nacre::app
