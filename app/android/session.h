#pragma once
// The session of one activity: what a phone's does, on Android's windows. Everything here belongs to the render thread.

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
    /// @param viewFile  where the last view is kept
    AndroidSession(PhoneHost host, const PictureDescription& first, double pixelsPerPoint, std::string viewFile);

    void windowCreated(ANativeWindow* window);
    /// It has another size, or lost what was in it.
    void windowChanged();
    void windowDestroyed();
    void contentChanged(const ARect& content);
    /// Bars, cutouts and gestures of the system lie over so much of the window's edges, pixels.
    void covered(int left, int top, int right, int bottom);
    void densityChanged(double pixelsPerPoint);
    void started();
    void paused();
    void stopped();
    /// The display that the window is on shows so many pictures per second, and could show so many.
    void displayRefreshes(double rate, double most);
    /// The display begins a picture. @param nanoseconds  of the steady clock
    void tick(std::int64_t nanoseconds);
    /// A step, and what the system is told of it. @returns as step()
    double turn();
    /// @param animate  called when frame after frame begins to be drawn, and when that ends: tick() is wanted meanwhile
    void onMotion(std::function<void(bool)> animate) { animate_ = std::move(animate); }
    /// As Viewer::awaitFrame.
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
    double most_ = 0;            // pictures per second of the display at its best; 0: nobody says
    double ticked_ = -1e9;       // when the display began a picture last
    double moved_ = -1e9;        // when a frame of a motion was drawn last
    std::uint64_t motions_ = 0;  // frames of motions so far
    bool moving_ = false;
    bool started_ = false;
};

}  // namespace nacre::app
