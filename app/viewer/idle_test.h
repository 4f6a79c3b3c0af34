#pragma once
// Tests the paths of a device (engine/self_test.h) on a separate thread while a window is idle. The next start uses the
// result. For one thread.

#include <atomic>
#include <thread>

#include "engine/device_options.h"
#include "engine/results.h"

namespace nacre::app {

class IdleTest {
public:
    IdleTest() = default;
    IdleTest(const IdleTest&) = delete;
    /// Stops the test, and waits for its end.
    ~IdleTest();

    /// Whether the device needs a test and none is running. Reads the disk until no test is needed.
    bool wanted(const DeviceOptions& options, const DeviceInfo& device);
    void begin(const DeviceOptions& options, const DeviceInfo& device);
    /// Stops the test early; begin() continues with the interrupted path.
    void stop() { stop_ = true; }
    bool running() const { return running_; }
    /// Whether a test has ended, and no path drew right.
    bool foundNone() const { return foundNone_; }

private:
    void join();

    std::thread thread_;
    std::atomic<bool> stop_{false}, running_{false}, foundNone_{false};
    bool needless_ = false;
};

}  // namespace nacre::app
