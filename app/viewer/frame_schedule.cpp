#include "app/viewer/frame_schedule.h"

#include <algorithm>
#include <iterator>

namespace nacre::app {
namespace {

constexpr struct { double scale, meshError; } kLevels[] = {{1, 2}, {1, 8}, {0.85, 8}, {0.7, 8}, {0.55, 8}, {0.4, 8}};
constexpr int kLevelOfMeshes = 1;  // without effect in scenes without meshes
constexpr double kRoom = 0.9;      // fraction of the display's interval that a frame may take without missing it

}  // namespace

double ResolutionControl::scale() const {
    const double hot = std::clamp((heat_ - kWarm) / (1 - kWarm), 0.0, 1.0);
    return std::max(std::min(kLevels[level_].scale, 1 - hot * (1 - kHotScale)), leastScale_);
}
double ResolutionControl::meshError() const { return kLevels[level_].meshError; }

/// The next level in a direction; unchanged at the end.
int ResolutionControl::nextLevel(int step) const {
    int next = level_ + step;
    if (next == kLevelOfMeshes && !meshes_) next += step;
    const bool there = next >= 0 && next < static_cast<int>(std::size(kLevels)) && kLevels[next].scale >= leastScale_;
    return there ? next : level_;
}

void ResolutionControl::change(int step) {
    level_ = nextLevel(step);
    slow_ = fast_ = 0;
    unsettled_ = kInFlight;
}

void ResolutionControl::frameTook(double seconds, double device, double longest) {
    if (unsettled_ > 0) {
        --unsettled_;
        return;
    }
    // GPU time shows how close the device is to missing a frame; wall-clock time only shows misses.
    const bool slow = device > 0 ? device > kRoom * longest : seconds > 1.5 * longest;
    slow_ = slow ? slow_ + 1 : 0;
    if (slow_ >= kPatience && nextLevel(1) != level_) return change(1);
    if (device == 0 || level_ == 0) return;
    // Restoring triangles costs about as much as a step of resolution.
    const double more = std::max(kLevels[nextLevel(-1)].scale / kLevels[level_].scale, 1.2);
    fast_ = device * more * more < 0.7 * longest ? fast_ + 1 : 0;
    if (fast_ >= kConfidence) change(-1);
}

void ResolutionControl::rest() { level_ = slow_ = fast_ = unsettled_ = 0; }

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
        if (moving) next.meshError = resolution_.meshError();
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
