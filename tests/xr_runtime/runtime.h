#pragma once
// A headset for tests: an OpenXR runtime without display, that a test leads and listens to. It keeps the rules of
// OpenXR 1.0 and XR_KHR_vulkan_enable2 as their specification states them, and notes what the program does against
// them. Loader and test load the same library. For one thread.

#define XR_USE_GRAPHICS_API_VULKAN
#include <vulkan/vulkan.h>
//
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace xr_runtime {

/// What a program showed at a time.
struct ShownFrame {
    XrTime time = 0;
    bool layered = false;  ///< it has pictures; otherwise nothing was shown
    std::array<XrPosef, 2> poses{};
    std::array<XrFovf, 2> fovs{};
    std::array<std::vector<std::uint8_t>, 2> pixels;  ///< RGBA, coded as sRGB, row 0 on top
};

struct Hand {
    bool tracked = false, select = false, menu = false;
    XrPosef pose{{0, 0, 0, 1}, {0, 0, 0}};
};

struct Runtime {
    // The device:
    bool connected = true, vulkan = true;
    std::uint32_t width = 96, height = 80;
    std::int64_t format = VK_FORMAT_R8G8B8A8_SRGB;
    /// Eyes at a time, left and right.
    std::function<std::array<XrView, 2>(XrTime)> eyes;
    std::function<std::array<Hand, 2>(XrTime)> hands;
    bool tracked = true;
    XrDuration period = 10'000'000, lead = 25'000'000;  ///< between frames; until one is seen, ns

    // What happens at the beginning of a frame, by its number in all sessions:
    std::function<void(int frame)> before;
    /// Calls of the session fail from now on, until there is another.
    void loseSession();
    /// As a user who takes the headset off for good.
    void stop();
    /// The session's state as runtimes announce it.
    void announce(XrSessionState state);

    // What the program did:
    std::vector<ShownFrame> frames;
    int sessions = 0;
    std::vector<std::string> faults;  ///< against the rules

    void reset();
};

/// The one of this process.
Runtime& runtime();

}  // namespace xr_runtime
