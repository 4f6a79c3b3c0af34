#pragma once
// What Android's newer versions offer to apps that draw much: the display's rate, the heat that is to come, and hints
// of how long the work of a frame takes. Looked up by name, since minSdk is older: what is not there does nothing. For
// the render thread.

#include <cstdint>
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

    /// Asks for so many pictures per second of a window's display; 0: as the system likes. Android 11.
    void setFrameRate(ANativeWindow* window, double rate);
    /// How near the device will be to slowing itself down, ten seconds from now: 1, it does. Asked of the system every
    /// ten seconds; 0 where it does not tell. Android 12.
    double heatAt(double now);
    double heat() const { return heat_; }
    /// A frame took the calling thread so many seconds, and may take as long as the display's picture. Android 13.
    void worked(double seconds, double target);

private:
    AThermalManager* thermal_ = nullptr;
    APerformanceHintSession* hints_ = nullptr;
    bool begun_ = false, hintsBegun_ = false;
    double heat_ = 0, asked_ = -std::numeric_limits<double>::infinity(), target_ = 0;
};

}  // namespace nacre::app
