#include "engine/gpu/frame_pace.h"

#include <algorithm>
#include <numeric>

namespace nacre::gpu {

using State = WindowPace::State;

void FramePace::enter(State state) {
    state_ = state;
    timed_ = inRow_ = 0;
}

void FramePace::rest() {
    enter(State::resting);
    rest_ = nextRest_;
    nextRest_ = std::min(2 * nextRest_, kLastRest);
    waited_ = toDisplay_ = 0;
}

void FramePace::start(double now, bool queued) {
    if (state_ == State::resting && --rest_ <= 0) enter(State::freely);
    if (state_ == State::resting) return;
    if (!queued) {  // the frame is late or the first in a while: nothing to wait for
        inRow_ = 0;
        return;
    }
    // Two frames: where a display shows two in three intervals, the times of single ones differ.
    if (inRow_ == 2) times_[static_cast<std::size_t>(timed_++)] = now - before_[1];
    before_ = {now, before_[0]};
    inRow_ = std::min(inRow_ + 1, 2);
    if (timed_ < kRun) return;
    timed_ = 0;
    constexpr int kHitches = kRun / 8;  // which are no rate
    std::ranges::sort(times_);
    decide(std::accumulate(times_.begin(), times_.end() - kHitches, 0.0) / (kRun - kHitches));
}

void FramePace::decide(double twoFrames) {
    if (state_ == State::freely) {
        free_ = twoFrames;
        if (waited_ > kLoss * free_) return rest();
        return enter(State::waiting);
    }
    // The second frame started when the first was on display.
    toDisplay_ = twoFrames;
    if (twoFrames > kLoss * free_) {  // by waiting, or since the scene takes longer: time it without
        waited_ = twoFrames;
        return enter(State::freely);
    }
    free_ = std::min(free_, twoFrames);
    waited_ = 0;
    nextRest_ = kFirstRest;
}

}  // namespace nacre::gpu
