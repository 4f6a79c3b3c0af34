#pragma once
// A headset by OpenXR: its session, poses, hands, and the images that it lends.

#include <array>
#include <optional>
#include <vector>

#include "app/xr/calls.h"
#include "app/xr/eyes.h"
#include "engine/device_options.h"
#include "engine/settings.h"

namespace nacre::app {

/// A hand that is tracked, and what its buttons do. Buttons and poses of both hands where there are two.
struct Hand {
    Pose pose;
    bool holds = false;  ///< trigger
};

class Headset {
public:
    /// @throws Error without loader, runtime, its Vulkan extension or headset
    Headset();
    ~Headset();
    Headset(const Headset&) = delete;

    /// For the device of a renderer. It must live from before begin() until after end().
    HeadsetSource source();
    /// Makes a session with the device that source() made last. @throws Error
    void begin();
    /// Ends the session, if there is one. Call before its device goes.
    void end() noexcept;

    /// Follows the runtime's wishes. @throws Error
    void handleEvents();
    /// Whether the runtime wants frames.
    bool running() const { return running_; }
    /// Whether user or runtime ended it.
    bool over() const { return over_; }
    /// The session is lost, or about to be: end it. The next one may succeed.
    bool lost() const { return lost_; }
    /// Asks for the end.
    void leave();

    /// A frame of the display.
    struct Frame {
        XrTime time = 0;  ///< when it will be seen
        bool shows = false;
    };
    /// Waits until the next frame may begin, and begins it.
    Frame beginFrame();
    /// Both eyes at a frame's time, left and right; none while the head is not tracked.
    std::optional<std::array<EyePose, 2>> eyes(const Frame& frame);
    /// The hand that holds, of two the one that held before, else any that is tracked.
    std::optional<Hand> hand(const Frame& frame);
    /// Whether the menu button went down since the last call of hand().
    bool menu() const { return menu_; }
    /// The next image, to be drawn into until give().
    HeadsetImage take();
    void give();
    /// @param shown  what the last image shows; none: nothing is shown
    void endFrame(const Frame& frame, const std::optional<std::array<EyePose, 2>>& shown);

    std::uint32_t width() const { return width_; }
    std::uint32_t height() const { return height_; }

private:
    void findSystem();
    void makeActions();
    void makeSwapchain();
    void makeSpaces();
    XrPath path(const char* text) const;
    bool pressed(XrAction action, XrPath hand) const;

    XrInstance instance_ = XR_NULL_HANDLE;
    XrCalls xr_;
    XrSystemId system_ = XR_NULL_SYSTEM_ID;
    XrGraphicsBindingVulkan2KHR binding_{};
    XrActionSet actions_ = XR_NULL_HANDLE;
    XrAction grip_ = XR_NULL_HANDLE, hold_ = XR_NULL_HANDLE, menuAction_ = XR_NULL_HANDLE;
    std::array<XrPath, 2> hands_{};
    // Of a session:
    XrSession session_ = XR_NULL_HANDLE;
    XrSpace room_ = XR_NULL_HANDLE;
    std::array<XrSpace, 2> grips_{};
    XrSwapchain swapchain_ = XR_NULL_HANDLE;
    std::vector<XrSwapchainImageVulkan2KHR> images_;
    int format_ = 0;
    std::uint32_t width_ = 0, height_ = 0;
    bool running_ = false, focused_ = false, over_ = false, lost_ = false, menu_ = false;
    std::size_t holding_ = 0;  // the hand that held last
};

}  // namespace nacre::app
