#pragma once
// The session of one activity: what a phone's does, on Android's windows. Everything here belongs to the render thread.

#include <android/native_window.h>
#include <android/rect.h>

#include <string>

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
    void densityChanged(double pixelsPerPoint);
    void started();
    void paused();
    void stopped();
    /// The display that the window is on shows so many pictures per second.
    void displayRefreshes(double rate) { viewer().schedule().setDisplayInterval(1 / rate); }
    /// As Frames::await.
    void awaitFrame();

private:
    static PhoneHost onWindow(PhoneHost host, ANativeWindow* const& window);
    void settle() { setSeen(window_ && started_); }
    PixelSize size() const;

    std::string viewFile_;
    ANativeWindow* window_ = nullptr;
    ARect content_{};
    bool started_ = false;
};

}  // namespace nacre::app
