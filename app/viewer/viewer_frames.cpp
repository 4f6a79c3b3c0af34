// When the viewer draws and what: frames, occlusion, and what fails of them.

#include <algorithm>
#include <limits>

#include "app/drawing/scenes.h"
#include "app/viewer/viewer.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

PixelSize Viewer::freeSize() const {
    const auto left = [](std::uint32_t side, float covered) {
        return static_cast<std::uint32_t>(std::max(static_cast<float>(side) - covered, 1.0f));
    };
    return {left(size_.width, covered_.left + covered_.right), left(size_.height, covered_.top + covered_.bottom)};
}

RenderSettings Viewer::settings() const {
    RenderSettings s = pictureSettings(freeSize());
    s.view.width = size_.width;
    s.view.height = size_.height;
    // From the middle of the window to that of what is free.
    s.view.pan +=
        glm::dvec2(covered_.left - covered_.right, covered_.bottom - covered_.top) / 2.0 / s.view.pixelsPerAngstrom;
    return s;
}

RenderSettings Viewer::pictureSettings(PixelSize size) const {
    RenderSettings s;
    s.view = viewOf(motion_.camera(), radius(), size.width, size.height);
    if (document_.moves()) reachTo(s.view, document_.scene.radius);
    s.background = view_.background;
    s.lighting = view_.lighting;
    s.effects = view_.effects;
    s.occlusion.directions = view_.occlusionDirections;
    s.occlusion.bytes = options_.occlusionBytes;
    s.occlusion.cache = options_.occlusionCache;
    s.tuning = options_.tuning;
    s.debug = debug_;
    return s;
}

std::uint32_t Viewer::refinedSamples() const {
    const std::uint32_t n = debug_ == DebugView::none ? options_.mostSamples : 1;  // numbers have no mean
    return n * n;
}

/// Moves what moves by itself. @returns when something is due
double Viewer::advance(double now) {
    apply(touches_.tick(now), now);
    if (motion_.advance(now)) changed(now);
    const double played = play(now);
    if (!message_.empty() && now >= messageUntil_) {
        message_.clear();
        schedule_.overlayChanged();
    }
    if (hoverDue_ && now >= *hoverDue_) hover(now);
    double due = std::min(played, message_.empty() ? kNever : messageUntil_);
    if (hoverDue_) due = std::min(due, *hoverDue_);
    if (const auto wake = touches_.wake()) due = std::min(due, *wake);
    return due;
}

double Viewer::update(double now, const std::function<const Overlay*()>& overlay) {
    updated_ = now;
    tookDocument(now);
    const double due = advance(now);
    const bool hand = now < handRests();
    const bool moving = motion_.moving() || hand;
    if (!schedule_.visible()) return kNever;
    if (!sceneThere_ && sceneRetry_.due(now)) putScene(now);
    if (document() && sceneThere_ && occlusion_ < 1 && occlusionRetry_.due(now))
        advanceOcclusion(now, moving || playback_.playing());
    if (deviceLost_) return now;
    if (!frameRetry_.due(now)) return std::min(due, frameRetry_.at());
    schedule_.setSamples(refinedSamples());
    schedule_.setMeshes(!document_.scene.triangles.empty());
    const FrameSchedule::Next next = schedule_.next(now, moving, bakedShare());
    if (next.draw != Draw::nothing) draw(next, now, moving, overlay);
    const FrameSchedule::Next after = schedule_.next(now, moving, bakedShare());
    double wake = after.draw != Draw::nothing ? now : after.wake;
    if (after.draw == Draw::nothing && !occlusionRetry_.due(now)) wake = occlusionRetry_.at();
    wake = std::min(wake, hand ? handRests() : kNever);
    if (!sceneThere_) wake = std::min(wake, sceneRetry_.at());
    if (!frameRetry_.due(now)) wake = frameRetry_.at();
    return std::min(due, wake);
}

void Viewer::awaitFrame(double now) {
    const bool moving = motion_.moving() || now < handRests();
    if (!schedule_.visible() || deviceLost_ || !frameRetry_.due(now)) return;
    if (schedule_.next(now, moving, bakedShare()).draw != Draw::nothing) screen_.awaitFrame();
}

void Viewer::advanceOcclusion(double now, bool moving) {
    try {
        // At rest every change of it draws a frame, which is not to cost more than the work that it shows.
        const double shown = std::clamp(2 * screen_.frameMilliseconds(), 50.0, 250.0);
        const OcclusionPace pace = moving ? OcclusionPace{options_.movingMilliseconds, 0, true}
                                          : OcclusionPace{options_.restingMilliseconds, shown, false};
        occlusion_ = screen_.advanceOcclusion(settings(), pace);
        occlusionRetry_.succeeded();
        noticeLoss();
    } catch (const Error& error) {
        occlusion_ = 0;  // what there was is gone
        failed(error, occlusionRetry_, now);
    }
}

void Viewer::draw(const FrameSchedule::Next& next, double now, bool moving,
                  const std::function<const Overlay*()>& overlay) {
    WindowFrame frame;
    frame.quality = next.draw == Draw::live     ? WindowFrame::Quality::live
                    : next.draw == Draw::refine ? WindowFrame::Quality::refined
                                                : WindowFrame::Quality::kept;
    frame.scale = drawnScale_ = next.scale;
    frame.meshError = next.meshError;
    frame.samples = refinedSamples();
    frame.sample = next.sample;
    if (overlay) frame.overlay = overlay();
    FrameOutcome outcome = FrameOutcome::lost;
    try {
        outcome = screen_.present(settings(), frame);
        frameRetry_.succeeded();
    } catch (const Error& error) {
        return failed(error, frameRetry_, now);
    }
    switch (outcome) {
        case FrameOutcome::shown:
            schedule_.shown(next, now, moving, bakedShare(), screen_.frameMilliseconds() / 1000);
            expectScene(frame);
            break;
        case FrameOutcome::resized:
            resize(screen_.windowSize(), scale_, now);
            break;
        case FrameOutcome::hidden:
            schedule_.setVisible(false);  // until resume()
            break;
        case FrameOutcome::lost:
            noticeLoss();
            deviceLost_ = true;
            break;
    }
}

void Viewer::screenLost(double now) {
    deviceLost_ = false;
    if (!loss_.empty()) say(loss_, now);
    loss_.clear();
    expected_.clear();
    sceneThere_ = !document();
    sceneRetry_ = occlusionRetry_ = frameRetry_ = {};
    putScene(now);
    schedule_.windowChanged(now);
}

/// Puts the document's scene on the screen, where it is not.
void Viewer::putScene(double now) {
    occlusion_ = view_.occlusionDirections ? 0 : 1;
    if (sceneThere_) return;
    try {
        screen_.setScene(document_.scene);
        sceneThere_ = true;
        sceneRetry_.succeeded();
    } catch (const Error& error) {
        failed(error, sceneRetry_, now);
    }
}

void Viewer::failed(const std::exception& error, Retry& retry, double now) {
    retry.failed(now);
    if (!noticeLoss()) say(error.what(), now);
}

bool Viewer::noticeLoss() {
    const std::string loss = screen_.deviceLoss();
    if (loss.empty()) return false;
    loss_ = loss;
    deviceLost_ = true;
    return true;
}

}  // namespace nacre::app
