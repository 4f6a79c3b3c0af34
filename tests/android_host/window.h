#pragma once
// The fake window, and what of it host and Vulkan stand-in share.

#include <android/native_window.h>

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace nacre::test {

/// As a user sees it: row 0 on top, whichever way the display is mounted.
struct WindowPicture {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

/// What an app must not do, in words. Empty is what is right.
class Faults {
public:
    static void add(const std::string& fault);
    static std::vector<std::string> take();
};

}  // namespace nacre::test

/// Sizes are those of the upright picture; the display's own rows run otherwise when it is turned.
struct ANativeWindow {
    std::mutex mutex;
    std::int32_t width = 0, height = 0;
    int quarterTurns = 0;  ///< clockwise, that pictures have to be turned for this display
    bool alive = true;
    int references = 0;  ///< of the app
    float rate = -1;     ///< pictures per second that the app asked for; -1: it did not
    int surfaces = 0;    ///< VkSurfaceKHR that are there
    std::uint64_t frames = 0;
    nacre::test::WindowPicture picture;
};
