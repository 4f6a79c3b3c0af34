#pragma once

#include <memory>
#include <mutex>

#include "engine/device_options.h"

struct ANativeWindow;

namespace nacre::app {

/// The current window. It may end while another thread makes a surface from it, which then belongs to a window that is
/// no longer shown.
class NativeWindow {
public:
    NativeWindow() = default;
    ~NativeWindow() { set(nullptr); }
    NativeWindow(const NativeWindow&) = delete;

    /// @param window  null: none. @returns whether a surface was made from the previous one
    bool set(ANativeWindow* window);
    ANativeWindow* get() const { return window_; }
    /// Makes Vulkan draw into the current window.
    static SurfaceSource makeSurface(std::shared_ptr<NativeWindow> window);

private:
    std::mutex mutex_;
    ANativeWindow* window_ = nullptr;
    bool taken_ = false;
};

}  // namespace nacre::app
