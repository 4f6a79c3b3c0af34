#include "app/viewer/frame_schedule.h"

#include <algorithm>

namespace nacre::app {
namespace {

constexpr double kScales[] = {1.0, 0.85, 0.7, 0.55, 0.4};
constexpr int kLowest = 4;
constexpr double kRoom = 0.9;  // share of the display's interval that a frame may take and not miss it

}  // namespace

double ResolutionControl::scale() const { return kScales[level_]; }

void ResolutionControl::change(int step) {
    level_ += step;
    slow_ = fast_ = 0;
    unsettled_ = kInFlight;
}

void ResolutionControl::frameTook(double seconds, double device, double longest) {
    if (unsettled_ > 0) {
        --unsettled_;
        return;
    }
    // The device's own time tells how near it is to missing a picture; from outside one sees only that it did.
    const bool slow = device > 0 ? device > kRoom * longest : seconds > 1.5 * longest;
    slow_ = slow ? slow_ + 1 : 0;
    if (slow_ >= kPatience && level_ < kLowest) return change(1);
    if (device == 0 || level_ == 0) return;
    const double more = kScales[level_ - 1] / kScales[level_];
    fast_ = device * more * more < 0.7 * longest ? fast_ + 1 : 0;
    if (fast_ >= kConfidence) change(-1);
}

void ResolutionControl::rest() { *this = {}; }

void FrameSchedule::pictureChanged(double now) {
    pictureChanged_ = true;
    refined_ = 0;
    lastChange_ = now;
}

void FrameSchedule::windowChanged(double now) { pictureChanged(now); }

void FrameSchedule::setDisplayInterval(double seconds) {
    if (seconds >= 0.001 && seconds <= 1) interval_ = seconds;
}

FrameSchedule::Next FrameSchedule::next(double now, bool moving, double occlusion) const {
    Next next;
    if (!visible_) return next;
    if (moving || pictureChanged_ || occlusion != shownOcclusion_) {
        next.draw = Draw::live;
        next.scale = moving ? resolution_.scale() : 1.0;
        next.wake = now;
    } else if (refined_ >= samples_) {
        if (overlayChanged_) next.draw = Draw::keep;
    } else if (occlusion >= 1 && now >= lastChange_ + kSettleSeconds) {
        next.draw = Draw::refine;
        next.sample = refined_;
        next.wake = now;
    } else {
        if (overlayChanged_) next.draw = Draw::live;
        next.wake = occlusion < 1 ? now + kBakeSeconds : lastChange_ + kSettleSeconds;
    }
    return next;
}

void FrameSchedule::shown(const Next& frame, double now, bool moving, double occlusion, double deviceSeconds) {
    if (frame.draw == Draw::nothing) return;
    if (moving && wasMoving_)
        resolution_.frameTook(now - lastFrame_, deviceSeconds, std::max(interval_, longest_ / kRoom));
    if (!moving) resolution_.rest();
    if (moving) {
        ++motion_.frames;
        motion_.reduced += frame.scale < 1;
        motion_.smallestScale = std::min(motion_.smallestScale, frame.scale);
    }
    if (moving || occlusion != shownOcclusion_) lastChange_ = now;
    wasMoving_ = moving;
    lastFrame_ = now;
    overlayChanged_ = false;
    if (frame.draw == Draw::keep) return;
    pictureChanged_ = false;
    shownOcclusion_ = occlusion;
    refined_ = frame.draw == Draw::refine ? frame.sample + 1 : 0;
}

}  // namespace nacre::app
