#include "app/viewer/idle_test.h"

#include <exception>

#include "engine/self_test.h"
#include "engine/threads.h"

namespace nacre::app {

IdleTest::~IdleTest() {
    stop();
    join();
}

void IdleTest::join() {
    if (thread_.joinable()) thread_.join();
}

bool IdleTest::wanted(const DeviceOptions& options, const DeviceInfo& device) {
    if (running_ || needless_) return false;
    needless_ = !lacksSelfTest(options, device);
    return !needless_;
}

void IdleTest::begin(const DeviceOptions& options, const DeviceInfo& device) {
    join();
    stop_ = false;
    running_ = true;
    DeviceOptions alone = options;
    alone.surface = {};
    alone.onSelfTest = {};
    thread_ = startThread([this, alone, device] {
        try {
            testPaths(alone, device, &stop_);
            DeviceInfo tested = device;
            addSelfTest(tested, alone.selfTests);
            foundNone_ = tested.visibility == "none";
        } catch (const std::exception&) {
            // The next start tests what is missing.
        }
        running_ = false;
    });
}

}  // namespace nacre::app
