#pragma once
// Tests the paths of a device (engine/self_test.h) on a thread of its own while a window is idle. The next start uses
// the result. For one thread.

#include <atomic>
#include <thread>

#include "engine/device_options.h"
#include "engine/results.h"

namespace nacre::app {

class IdleTest {
public:
    IdleTest() = default;
    IdleTest(const IdleTest&) = delete;
    /// Stops, and waits.
    ~IdleTest();

    /// Whether the device needs a test that does not run. Asks the disk until it needs none.
    bool wanted(const DeviceOptions& options, const DeviceInfo& device);
    void begin(const DeviceOptions& options, const DeviceInfo& device);
    /// Asks it to stop; begin() continues with the path that was interrupted.
    void stop() { stop_ = true; }
    bool running() const { return running_; }

private:
    void join();

    std::thread thread_;
    std::atomic<bool> stop_{false}, running_{false};
    bool needless_ = false;
};

}  // namespace nacre::app
