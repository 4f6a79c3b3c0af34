#pragma once

#include <memory>
#include <mutex>

#include "engine/device_options.h"

struct ANativeWindow;

namespace nacre::app {

/// The window of the moment. It may go while another thread makes a surface of it; whoever still asks for its size then
/// asks one that is not shown any more.
class NativeWindow {
public:
    NativeWindow() = default;
    ~NativeWindow() { set(nullptr); }
    NativeWindow(const NativeWindow&) = delete;

    /// @param window  null: there is none. @returns whether a surface was made of the one before
    bool set(ANativeWindow* window);
    ANativeWindow* get() const { return window_; }
    /// Makes Vulkan draw into the window of the moment.
    static SurfaceSource surfaceOf(std::shared_ptr<NativeWindow> window);

private:
    std::mutex mutex_;
    ANativeWindow* window_ = nullptr;
    bool taken_ = false;
};

}  // namespace nacre::app
