#pragma once

#include <android/log.h>

#include <string_view>

#include "app/files/printable.h"

namespace nacre::app {

/// A line in the device's log, which people read in terminals.
inline void logError(std::string_view text) {
    __android_log_print(ANDROID_LOG_ERROR, "nacre", "%s", printable(text).c_str());
}

}  // namespace nacre::app
