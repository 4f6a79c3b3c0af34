#pragma once
// The session of the phones' apps, led as their systems would lead it.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "app/phone/session.h"

namespace nacre::test {

/// As the display link does: steps until nothing is due for `quiet` seconds. @param now  the clock, which leaps to what
/// is due
inline void runToRest(app::PhoneSession& session, double& now, double quiet = 5) {
    for (int steps = 0; steps < 20'000; ++steps) {
        const double wake = session.step();
        if (session.viewer().reading().loader().busy())
            session.viewer().reading().loader().wait();
        else if (wake > now + quiet)
            return;
        // The device bakes beside the frames, in its own time.
        std::this_thread::sleep_for(std::chrono::microseconds(500));
        now = std::max(now + 1.0 / 60, std::isfinite(wake) ? wake : now);
    }
    ADD_FAILURE() << "it never rests";
}

}  // namespace nacre::test
