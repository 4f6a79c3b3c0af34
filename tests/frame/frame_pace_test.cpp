// The rule by which a window's frames wait for its display, on displays that are computed.

#include "engine/gpu/frame_pace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace nacre::test {
namespace {

using gpu::FramePace;
using State = WindowPace::State;

/// A display that takes the next finished frame at each of its intervals, and shows it later. Three images.
struct ComputedDisplay {
    double interval = 1, later = 0;  ///< from taking a frame to showing it
    double host = 0.1, device = 0.2;
    double now = 0;
    std::vector<double> taken = {}, done = {};
    FramePace pace = {};

    void frame(double hitch = 0) {
        const std::size_t n = taken.size();
        const auto shown = [&](std::size_t i) { return taken[i] + later; };
        const bool queued = n > 0 && shown(n - 1) > now;
        if (queued && pace.waits() && n > 1) now = std::max(now, shown(n - 2));
        pace.start(now, queued);
        if (n > 2) now = std::max(now, taken[n - 2]);  // the image of the frame before that is free
        if (n > 1) now = std::max(now, done[n - 2]);   // two frames in flight
        now += host + hitch;
        done.push_back(std::max(now, n > 0 ? done[n - 1] : 0) + device);
        const double next = std::floor(done[n] / interval + 1) * interval;
        taken.push_back(n > 0 ? std::max(next, taken[n - 1] + interval) : next);
    }
    double run(int frames) {
        const double from = taken.empty() ? 0 : taken.back();
        for (int i = 0; i < frames; ++i) frame();
        return (taken.back() - from) / frames;
    }
};

TEST(FramePace, NeverCostsMoreThanTheTriesDo) {
    for (const double later : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0})
        for (const double host : {0.05, 0.3, 0.9})
            for (const double device : {0.1, 0.6, 1.3, 2.6}) {
                SCOPED_TRACE(std::to_string(later) + ", " + std::to_string(host) + ", " + std::to_string(device));
                ComputedDisplay paced{1, later, host, device}, free = paced;
                free.pace.timedOut();  // rests for 600 frames
                const double natural = free.run(500);
                paced.run(60);
                EXPECT_LE(paced.run(4000), FramePace::kLoss * natural);
                // Where it rests, next to nothing is lost.
                if (paced.pace.state() != State::waiting) {
                    EXPECT_LE(paced.run(9000), 1.01 * natural);
                }
            }
}

TEST(FramePace, WaitsOnFastDisplaysAlone) {
    for (const auto& [later, waits] :
         std::vector<std::pair<double, bool>>{{0, true}, {1, true}, {2, false}, {4, false}}) {
        ComputedDisplay display{1, later};
        display.run(100);
        EXPECT_EQ(display.pace.state(), waits ? State::waiting : State::resting) << later;
        if (waits) {
            EXPECT_NEAR(display.pace.secondsToDisplay(), 2, 1e-9);
        }
    }
}

TEST(FramePace, FollowsTheDisplayAndTheScene) {
    ComputedDisplay display{.later = 1};
    display.run(100);
    ASSERT_EQ(display.pace.state(), State::waiting);
    display.interval = 2;  // slower, as is a display that saves power
    display.later = 2;
    display.run(100);
    EXPECT_EQ(display.pace.state(), State::waiting);
    EXPECT_NEAR(display.run(100), 2, 0.05);
    display.later = 5;  // another compositor
    display.run(100);
    EXPECT_EQ(display.pace.state(), State::resting);
    EXPECT_NEAR(display.run(100), 2, 0.05);
}

TEST(FramePace, HitchesAreNoRate) {
    ComputedDisplay display{.later = 1};
    for (int i = 0; i < 2000; ++i) display.frame(i % 20 == 0 ? 7 : 0);
    EXPECT_EQ(display.pace.state(), State::waiting);
}

TEST(FramePace, LeavesFramesAloneThatNothingWaitsFor) {
    ComputedDisplay display;
    for (int i = 0; i < 500; ++i) {
        display.frame();
        display.now = display.taken.back() + 0.5;  // the next one is asked for when this one is seen
    }
    EXPECT_EQ(display.pace.state(), State::freely);
}

}  // namespace
}  // namespace nacre::test
