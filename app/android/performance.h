#pragma once
// Performance functions of newer Android versions: the display's rate, thermal forecasts, and hints about a frame's
// duration. Looked up by name, since minSdk is older; missing functions do nothing. For the render thread.

#include <limits>

struct ANativeWindow;
struct AThermalManager;
struct APerformanceHintSession;

namespace nacre::app {

class Performance {
public:
    Performance() = default;
    ~Performance();
    Performance(const Performance&) = delete;

    /// Requests a frame rate for a window's display, per second; 0: the system's choice. Android 11.
    void setFrameRate(ANativeWindow* window, double rate);
    /// Thermal forecast for ten seconds from now: 1 means that the device will throttle. Queries the system every ten
    /// seconds; 0 if unknown. Android 12.
    double heatAt(double now);
    double heat() const { return heat_; }
    /// Reports a frame's duration on this thread and its target duration, seconds. Android 13.
    void worked(double seconds, double target);

private:
    AThermalManager* thermal_ = nullptr;
    APerformanceHintSession* hints_ = nullptr;
    bool begun_ = false, hintsBegun_ = false;
    double heat_ = 0, asked_ = -std::numeric_limits<double>::infinity(), target_ = 0;
};

}  // namespace nacre::app
