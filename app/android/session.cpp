#include "app/android/session.h"

#include <algorithm>

#include "app/android/render_thread.h"
#include "app/android/surface.h"
#include "app/viewer/kept_files.h"

namespace nacre::app {

AndroidSession::AndroidSession(PhoneHost host, const PictureDescription& first, double pixelsPerPoint,
                               std::string viewFile)
    : PhoneSession(onWindow(std::move(host), window_), first, pixelsPerPoint), viewFile_(std::move(viewFile)) {}

PhoneHost AndroidSession::onWindow(PhoneHost host, ANativeWindow* const& window) {
    host.clock = steadySeconds;
    host.surface = surfaceOf([&window] { return window; });
    host.windowMayGo = true;
    return host;
}

PixelSize AndroidSession::size() const {
    if (!window_) return {};
    return {static_cast<std::uint32_t>(std::max(ANativeWindow_getWidth(window_), 0)),
            static_cast<std::uint32_t>(std::max(ANativeWindow_getHeight(window_), 0))};
}

void AndroidSession::windowCreated(ANativeWindow* window) {
    window_ = window;
    windowChanged();
}

void AndroidSession::windowChanged() { densityChanged(scale()); }

void AndroidSession::windowDestroyed() {
    releaseWindow();
    window_ = nullptr;
    settle();
}

void AndroidSession::contentChanged(const ARect& content) {
    content_ = content;
    const Insets insets{static_cast<float>(content.left), static_cast<float>(content.top),
                        static_cast<float>(size().width) - static_cast<float>(content.right),
                        static_cast<float>(size().height) - static_cast<float>(content.bottom)};
    // While the window turns, its content may still be that of the other way up.
    const bool fits = content.left < content.right && content.top < content.bottom &&
                      std::min({insets.left, insets.top, insets.right, insets.bottom}) >= 0;
    setInsets(fits ? insets : Insets{});
}

void AndroidSession::densityChanged(double pixelsPerPoint) {
    resize(size(), pixelsPerPoint);
    contentChanged(content_);
    settle();
}

void AndroidSession::started() {
    started_ = true;
    settle();
}

/// Another window has the user's attention, or will; this one may still be seen.
void AndroidSession::paused() {
    viewer().pause();
    forgetTouch();
    keepView(viewFile_, viewer().view());
    settle();
}

void AndroidSession::stopped() {
    started_ = false;
    settle();
}

void AndroidSession::awaitFrame() {
    if (seen()) viewer().frames().await(now());
}

}  // namespace nacre::app
