#pragma once

#include <android/log.h>

#include <string_view>

#include "app/files/printable.h"

namespace nacre::app {

/// Writes a line to the device's log.
inline void logError(std::string_view text) {
    __android_log_print(ANDROID_LOG_ERROR, "nacre", "%s", printable(text).c_str());
}

}  // namespace nacre::app
