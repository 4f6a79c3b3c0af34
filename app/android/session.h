#pragma once
// A phone session for one activity, on Android's windows. Everything here belongs to the render thread.

#include <android/native_window.h>
#include <android/rect.h>

#include <functional>
#include <memory>
#include <string>

#include "app/android/performance.h"
#include "app/android/surface.h"
#include "app/phone/session.h"

namespace nacre::app {

class AndroidSession : public PhoneSession {
public:
    /// @param host      without a clock and a surface
    /// @param viewFile  for the last view
    AndroidSession(PhoneHost host, const PictureDescription& first, double pixelsPerPoint, std::string viewFile);

    void windowCreated(ANativeWindow* window);
    /// The window has another size, or lost its contents.
    void windowChanged();
    void windowDestroyed();
    void contentChanged(const ARect& content);
    /// Widths of the window's edges under bars, cutouts and gestures, pixels.
    void covered(int left, int top, int right, int bottom);
    void densityChanged(double pixelsPerPoint);
    void started();
    void paused();
    void stopped();
    /// Like ComponentCallbacks2.onTrimMemory. @param level  of that callback
    void trimMemory(int level);
    /// The frame rate of the window's display, and its maximum, per second.
    void displayRefreshes(double rate, double most);
    /// The display begins a frame. @param nanoseconds  of the steady clock
    void tick(std::int64_t nanoseconds);
    /// Takes a step, and reports it to the system. @returns as step()
    double turn();
    /// @param animate  called when continuous drawing begins or ends; tick() is needed in between
    void onMotion(std::function<void(bool)> animate) { animate_ = std::move(animate); }
    /// Like Viewer::awaitFrame.
    void awaitFrame();

private:
    AndroidSession(std::shared_ptr<NativeWindow> window, PhoneHost host, const PictureDescription& first,
                   double pixelsPerPoint, std::string viewFile);
    void settle() { setSeen(window_->get() && started_); }
    PixelSize size() const;

    std::string viewFile_;
    std::shared_ptr<NativeWindow> window_;
    void setMoving(bool moving);

    ARect content_{};
    Insets covered_;
    Performance performance_;
    std::function<void(bool)> animate_;
    double most_ = 0;            // maximum frame rate of the display, per second; 0: unknown
    double ticked_ = -1e9;       // last tick of the display
    double moved_ = -1e9;        // time of the last frame of a motion
    std::uint64_t motions_ = 0;  // frames of motions so far
    bool moving_ = false;
    bool started_ = false;
};

}  // namespace nacre::app
