#include "app/android/session.h"

#include <algorithm>
#include <utility>

#include "app/android/render_thread.h"
#include "app/viewer/kept_files.h"

namespace nacre::app {

namespace {

PhoneHost onWindow(PhoneHost host, const std::shared_ptr<NativeWindow>& window) {
    host.clock = steadySeconds;
    host.surface = NativeWindow::makeSurface(window);
    host.windowMayGo = true;
    return host;
}

}  // namespace

AndroidSession::AndroidSession(PhoneHost host, const PictureDescription& first, double pixelsPerPoint,
                               std::string viewFile)
    : AndroidSession(std::make_shared<NativeWindow>(), std::move(host), first, pixelsPerPoint, std::move(viewFile)) {}

AndroidSession::AndroidSession(std::shared_ptr<NativeWindow> window, PhoneHost host, const PictureDescription& first,
                               double pixelsPerPoint, std::string viewFile)
    : PhoneSession(onWindow(std::move(host), window), first, pixelsPerPoint),
      viewFile_(std::move(viewFile)),
      window_(std::move(window)) {}

PixelSize AndroidSession::size() const {
    ANativeWindow* window = window_->get();
    if (!window) return {};
    return {static_cast<std::uint32_t>(std::max(ANativeWindow_getWidth(window), 0)),
            static_cast<std::uint32_t>(std::max(ANativeWindow_getHeight(window), 0))};
}

void AndroidSession::windowCreated(ANativeWindow* window) {
    window_->set(window);
    windowChanged();
}

void AndroidSession::windowChanged() { densityChanged(scale()); }

void AndroidSession::windowDestroyed() {
    // A device being opened may already have a surface of this window; it will be finished soon.
    if (window_->set(nullptr)) awaitDevice();
    releaseWindow();
    settle();
}

void AndroidSession::contentChanged(const ARect& content) {
    content_ = content;
    Insets insets{static_cast<float>(content.left), static_cast<float>(content.top),
                  static_cast<float>(size().width) - static_cast<float>(content.right),
                  static_cast<float>(size().height) - static_cast<float>(content.bottom)};
    // While the window rotates, its content may still have the other orientation.
    const bool fits = content.left < content.right && content.top < content.bottom &&
                      std::min({insets.left, insets.top, insets.right, insets.bottom}) >= 0;
    if (!fits) insets = {};
    setInsets({std::max(insets.left, covered_.left), std::max(insets.top, covered_.top),
               std::max(insets.right, covered_.right), std::max(insets.bottom, covered_.bottom)});
}

void AndroidSession::covered(int left, int top, int right, int bottom) {
    covered_ = {static_cast<float>(left), static_cast<float>(top), static_cast<float>(right),
                static_cast<float>(bottom)};
    contentChanged(content_);
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

/// Another window has the focus, or will have it; this one may stay visible.
void AndroidSession::paused() {
    viewer().pause();
    forgetTouch();
    keepView(viewFile_, viewer().restartView());
    settle();
}

void AndroidSession::stopped() {
    started_ = false;
    settle();
}

/// From API level 34 on the system sends only these two levels, and never calls onLowMemory.
void AndroidSession::trimMemory(int level) {
    constexpr int kUiHidden = 20, kBackground = 40;
    if (level >= kBackground) return lowMemory();
    if (level >= kUiHidden && !seen()) releaseWindow();  // its images; the device stays for a quick return
}

// --- frames

void AndroidSession::displayRefreshes(double rate, double most) {
    viewer().schedule().setDisplayInterval(1 / rate);
    most_ = most;
}

void AndroidSession::tick(std::int64_t nanoseconds) { ticked_ = 1e-9 * static_cast<double>(nanoseconds); }

/// Requests the display's best rate only during motion, and not on a hot phone.
void AndroidSession::setMoving(bool moving) {
    if (std::exchange(moving_, moving) == moving) return;
    constexpr double kHot = 0.95, kHotRate = 60;
    const double rate = performance_.heat() > kHot ? std::min(most_, kHotRate) : most_;
    performance_.setFrameRate(window_->get(), moving ? rate : 0);
    if (animate_) animate_(moving);
}

double AndroidSession::turn() {
    const double begin = now(), interval = viewer().schedule().displayInterval();
    if (seen()) viewer().schedule().setHeat(performance_.heatAt(begin));
    const double wake = step();
    const double end = now();
    const std::uint64_t motions = viewer().schedule().motionFrames().frames;
    const bool moves = seen() && motions != motions_;
    motions_ = motions;
    if (moves) performance_.worked(end - begin, interval), moved_ = end;
    constexpr double kPause = 0.25;  // seconds; a motion may continue after a shorter pause
    const bool goesOn = seen() && end < moved_ + kPause;
    setMoving(goesOn);
    // Frames of a motion start with the display's ticks, while it reports them.
    const bool ticks = end - ticked_ < 4 * interval;
    if (moves && ticks) return std::max(wake, end + 2 * interval);
    return goesOn ? std::min(wake, moved_ + kPause) : wake;
}

void AndroidSession::awaitFrame() {
    if (seen()) viewer().frames().await(now());
}

}  // namespace nacre::app
