// A window that closes while a frame is drawn: the event that closed it is handled, and no further one comes.

#include <gtest/gtest.h>

#include <condition_variable>
#include <limits>
#include <mutex>
#include <thread>

#include "app/desktop/window.h"
#include "tests/desktop/environment.h"
#include "tests/desktop/x_session.h"

namespace nacre::test {
namespace {

TEST(ClosingWindow, WaitsForNoFurtherEvent) {
    const Variable display("DISPLAY", XSession::display());
    const Variable wayland("WAYLAND_DISPLAY", std::nullopt);
    app::WindowEvents events;
    events.resized = events.damaged = [] {};
    app::Window window({200, 100}, events);
    for (int i = 0; i < 10; ++i) window.handleEvents(0.02);  // those of a new window
    window.close();
    std::mutex mutex;
    std::condition_variable ended;
    bool returned = false, woken = false;
    std::thread rescue([&] {
        std::unique_lock lock(mutex);
        woken = !ended.wait_for(lock, std::chrono::seconds(20), [&] { return returned; });
        if (woken) app::Window::wake();
    });
    window.handleEvents(std::numeric_limits<double>::infinity());
    {
        const std::lock_guard lock(mutex);
        returned = true;
    }
    ended.notify_all();
    rescue.join();
    EXPECT_FALSE(woken) << "it slept until something else woke it";
}

}  // namespace
}  // namespace nacre::test
