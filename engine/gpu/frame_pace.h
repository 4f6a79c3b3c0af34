#pragma once
// When a window's frames start. A frame that waits until the one before the last is on display shows newer input. But
// only two frames are then shown in the time from a frame's start to its display. Where a compositor takes long, that
// is fewer than the display could show. So the frames are timed with and without waiting, and wait where it costs
// nothing.

#include <array>

#include "engine/results.h"

namespace nacre::gpu {

class FramePace {
public:
    static constexpr int kRun = 16;                           ///< frames timed for a decision
    static constexpr double kLoss = 1.1;                      ///< time per frame that waiting may cost, as a factor
    static constexpr int kFirstRest = 600, kLastRest = 9600;  ///< frames until waiting is tried again

    /// `freely`, `waiting` or `resting`.
    WindowPace::State state() const { return state_; }
    bool waits() const { return state_ == WindowPace::State::waiting; }
    /// A frame starts. @param now  seconds @param queued  whether the last one is not on display yet
    void start(double now, bool queued);
    /// The display showed nothing for so long that the wait was given up.
    void timedOut() { rest(); }
    /// Time from a frame's start to its display, where frames wait; 0: unknown.
    double secondsToDisplay() const { return toDisplay_; }

private:
    void enter(WindowPace::State state);
    void rest();
    void decide(double twoFrames);

    WindowPace::State state_ = WindowPace::State::freely;
    std::array<double, kRun> times_{};  ///< of two frames each
    int timed_ = 0;
    std::array<double, 2> before_{};  ///< starts of the last frames in a row
    int inRow_ = 0;
    double free_ = 0, waited_ = 0, toDisplay_ = 0;
    int rest_ = 0, nextRest_ = kFirstRest;
};

}  // namespace nacre::gpu
