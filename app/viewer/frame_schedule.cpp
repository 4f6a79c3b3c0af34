#include "app/viewer/frame_schedule.h"

namespace nacre::app {
namespace {

constexpr double kScales[] = {1.0, 0.75, 0.5, 0.375};
constexpr int kLowest = 3;

}  // namespace

double ResolutionControl::scale() const { return kScales[level_]; }

void ResolutionControl::frameTook(double seconds) {
    slow_ = seconds > kBudgetSeconds ? slow_ + 1 : 0;
    if (slow_ < kPatience || level_ == kLowest) return;
    ++level_;
    slow_ = 0;
}

void ResolutionControl::rest() { level_ = slow_ = 0; }

void FrameSchedule::pictureChanged(double now) {
    pictureChanged_ = true;
    refined_ = false;
    lastChange_ = now;
}

void FrameSchedule::windowChanged(double now) { pictureChanged(now); }

FrameSchedule::Next FrameSchedule::next(double now, bool moving, double occlusion) const {
    Next next;
    if (!visible_) return next;
    if (moving || pictureChanged_ || occlusion != shownOcclusion_) {
        next.draw = Draw::live;
        next.scale = moving ? resolution_.scale() : 1.0;
        next.wake = now;
    } else if (refined_) {
        if (overlayChanged_) next.draw = Draw::keep;
    } else if (occlusion >= 1 && now >= lastChange_ + kSettleSeconds) {
        next.draw = Draw::refine;
    } else {
        if (overlayChanged_) next.draw = Draw::live;
        next.wake = occlusion < 1 ? now + kBakeSeconds : lastChange_ + kSettleSeconds;
    }
    return next;
}

void FrameSchedule::shown(const Next& frame, double now, bool moving, double occlusion) {
    if (frame.draw == Draw::nothing) return;
    if (moving && wasMoving_) resolution_.frameTook(now - lastFrame_);
    if (!moving) resolution_.rest();
    if (moving || occlusion != shownOcclusion_) lastChange_ = now;
    wasMoving_ = moving;
    lastFrame_ = now;
    overlayChanged_ = false;
    if (frame.draw == Draw::keep) return;
    pictureChanged_ = false;
    shownOcclusion_ = occlusion;
    refined_ = frame.draw == Draw::refine;
}

}  // namespace nacre::app
