#include "app/viewer/viewer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "app/shared/measurement.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr double kHandSeconds = 0.1;  // a hand that rests this long no longer moves the picture
constexpr double kMessageSeconds = 4;
constexpr double kHoverSeconds = 0.08;  // that a pointer rests before what it is over is looked for
constexpr double kModelSeconds = 0.1;   // each, where the file is read as fast
constexpr double kNever = std::numeric_limits<double>::infinity();

std::string nameOf(const std::string& input) {
    return input.starts_with("sample:") ? input : std::filesystem::path(input).filename().string();
}

}  // namespace

Viewer::Viewer(Screen& screen, Sources sources, const SavedView& view, const ViewerOptions& options,
               std::function<void()> wake)
    : screen_(screen), options_(options), loader_(std::move(sources), std::move(wake)), view_(view) {
    motion_.set(view.camera);
    // What was saved looks as it was.
    if (!view.input.empty()) view.hash.empty() ? loader_.open(view_) : loader_.read(view_);
}

const SavedView& Viewer::view() const {
    view_.camera = motion_.camera();
    return view_;
}

// --- events

void Viewer::resize(PixelSize pixels, double pixelsPerPoint, double now) {
    size_ = {std::max(pixels.width, 1u), std::max(pixels.height, 1u)};
    scale_ = pixelsPerPoint;
    schedule_.windowChanged(now);
}

void Viewer::touch(const TouchEvent& event, double now) { apply(touches_.handle(event, now), now); }

void Viewer::mouseMove(glm::dvec2 at, double now) {
    const Viewport v = viewport();
    const bool held = mouse_.held();
    apply(mouse_.move(at, freeOrigin() + glm::dvec2(v.width / 2, v.height / 2)), now);
    if (held) return pointerLeft();
    hoverAt_ = at;
    hoverDue_ = now + kHoverSeconds;
}

void Viewer::mouseButton(MouseButton button, bool down, glm::dvec2 at, Modifiers with, double now) {
    apply(mouse_.button(button, down, at, with, now), now);
}

void Viewer::wheel(double steps, glm::dvec2 at, double now) {
    if (now - handMoved_ > kHandSeconds) remember();
    apply(mouse_.wheel(steps, at), now);
}

void Viewer::apply(const std::vector<Gesture>& gestures, double now) {
    for (const Gesture& g : gestures) {
        switch (g.kind) {
            case Gesture::Kind::touched:
                remember();
                motion_.touch();
                break;
            case Gesture::Kind::rotate:
                motion_.rotate(g.by, now);
                handMoved_ = now;
                changed(now);
                break;
            case Gesture::Kind::transform:
                motion_.pan(g.by, radius(), viewport());
                motion_.zoom(g.scale, g.at - freeOrigin(), radius(), viewport());
                motion_.roll(g.turn);
                handMoved_ = now;
                changed(now);
                break;
            case Gesture::Kind::tap:
            case Gesture::Kind::longPress:
                pick(g.at, now);
                break;
            case Gesture::Kind::doubleTap:
                doubleTap(g.at, now);
                break;
            case Gesture::Kind::released:
                motion_.release(now);
                break;
        }
    }
}

void Viewer::open(const std::string& path, double now) {
    question_.reset();
    dismissFailure();
    remember();
    restoring_ = false;
    SavedView fresh = view();
    fresh.input = path;
    fresh.format.reset();
    fresh.model = 1;
    fresh.look.assembly.clear();
    fresh.look.rules.clear();
    fresh.words.labels.clear();
    fresh.words.measures.clear();
    fresh.words.title.clear();
    fresh.camera = {};
    fresh.camera.projection = view_.camera.projection;
    loader_.open(fresh);
    say("reading " + nameOf(path), now);
}

void Viewer::aim(const Aim& aim, double now) {
    if (loader_.busy() || !document())
        aim_ = aim;
    else
        takeAim(aim, true, now);
}

/// What a close-up cut away comes back.
void Viewer::unclip() {
    if (std::exchange(clipped_, false)) view_.effects.clip.near = -Clip::kNone;
}

void Viewer::takeAim(const Aim& aim, bool fly, double now) {
    try {
        Camera from = motion_.camera();
        if (aim.zoomTo || aim.principal) from.zoom = 1;
        const Aimed to = aimed(from, aim, *document_.molecule, document_.scene, {freeSize().width, freeSize().height});
        remember();
        if (fly)
            motion_.fly(to.camera, now);
        else
            motion_.set(to.camera);
        if (to.clipNear || (aim.zoomTo && clipped_)) view_.effects.clip.near = to.clipNear.value_or(-Clip::kNone);
        clipped_ = to.clipNear.has_value();
        changed(now);
    } catch (const Error& error) {
        say(error.what(), now);
    }
}

void Viewer::answer(bool yes, double now) {
    if (!question_) return;
    const Question question = *question_;
    question_.reset();
    schedule_.overlayChanged();
    if (!yes) return say("not opened", now);
    question.accept();
    loader_.read(asked_);
    say("reading " + nameOf(asked_.input), now);
}

void Viewer::pause() {
    schedule_.setVisible(false);
    pointerLeft();
    touches_.clear();
    mouse_.clear();
    motion_.touch();
}

void Viewer::resume(double now) {
    schedule_.setVisible(true);
    schedule_.windowChanged(now);
}

void Viewer::screenLost(double now) {
    deviceLost_ = false;
    if (!loss_.empty()) say(loss_, now);
    loss_.clear();
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

void Viewer::setCovered(const Insets& pixels, double now) {
    if (pixels == covered_) return;
    covered_ = pixels;
    schedule_.windowChanged(now);
}

void Viewer::cancelLoading(double now) {
    if (!loader_.busy()) return;
    loader_.cancel();
    say("stopped", now);
}

void Viewer::fail(const std::string& what, double now) {
    if (!options_.errorsStay) return say(what, now);
    failure_ = what;
    message_.clear();
    schedule_.overlayChanged();
}

void Viewer::dismissFailure() {
    if (failure_.empty()) return;
    failure_.clear();
    schedule_.overlayChanged();
}

void Viewer::say(const std::string& message, double now) {
    message_ = message;
    messageUntil_ = now + kMessageSeconds;
    schedule_.overlayChanged();
}

void Viewer::setDebugView(DebugView view, double now) {
    debug_ = view;
    changed(now);
}

void Viewer::setLook(const SavedView& look, double now, bool continues) {
    const SavedView before = view();
    if (!continues) remember();
    unremembered_ = true;
    view_ = look;
    view_.camera = before.camera;
    motion_.setProjection(look.camera.projection);
    changed(now);
    // What cannot be said of this molecule is not kept.
    if (look.words != before.words && !putWords(now)) view_.words = before.words;
    const bool scene = look.look != before.look || look.drawn != before.drawn;
    // What is being read is seen in this look once it is there.
    const bool reading = loader_.busy() && loader_.view().input != document_.view.input;
    if (scene && document_.molecule && !reading) loader_.build(view(), document_.molecule);
    if (look.occlusionDirections != before.occlusionDirections) occlusion_ = look.occlusionDirections ? 0 : 1;
}

/// Finds the places of the words. @returns whether all of them have one
bool Viewer::putWords(double now) {
    if (!document()) return true;
    schedule_.overlayChanged();
    try {
        placedWords_ = placeWords(view_.words, *document_.molecule, document_.scene);
        return true;
    } catch (const Error& error) {
        say(error.what(), now);
        return false;
    }
}

// --- state

SavedView Viewer::savedView() const {
    SavedView saved = view();
    if (picks_.size() < 2) return saved;
    std::string atoms;
    for (const std::uint32_t pick : picks_) atoms += (atoms.empty() ? "" : ",") + std::to_string(pick + 1);
    const Measure measure = parseMeasure(atoms);
    std::vector<Measure>& kept = saved.words.measures;
    if (std::find(kept.begin(), kept.end(), measure) == kept.end()) kept.push_back(measure);
    return saved;
}

double Viewer::textSize() const { return (view_.words.size > 0 ? view_.words.size : kWordPoints) * scale_; }

std::string Viewer::title() const {
    std::string title = document() ? nameOf(document_.view.input) : "";
    if (question_) title = "question";
    if (loader_.busy()) title += title.empty() ? "reading" : ", building";
    if (document() && occlusion_ < 1)
        title += ", occlusion " + std::to_string(static_cast<int>(100 * occlusion_)) + " %";
    return title.empty() ? "Nacre" : title + " - Nacre";
}

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

// --- the loop

void Viewer::tookDocument(double now) {
    std::optional<Document> document;
    try {
        document = loader_.take();
    } catch (const Question& question) {
        question_ = question;
        asked_ = loader_.view();
        return schedule_.overlayChanged();
    } catch (const std::exception& error) {
        fail(error.what(), now);
        return;
    }
    if (!document) return;
    question_.reset();
    try {
        screen_.setScene(document->scene);
        sceneThere_ = true;
    } catch (const Error& error) {
        if (!noticeLoss()) return fail(error.what(), now);  // the document before stays
        sceneThere_ = false;                                // on the next device
    }
    const bool another = document->molecule != document_.molecule;
    // Another model of the same file: the camera stays in the hand that turns it.
    const bool step = another && document_.molecule && document->view.input == document_.view.input &&
                      document->view.model != document_.view.model;
    document_ = std::move(*document);
    if (another) {
        picks_.clear();
        view_.input = document_.view.input;
        view_.format = document_.view.format;
        view_.model = document_.view.model;
        view_.look.assembly = document_.view.look.assembly;
        if (!step && !view_.look.style) {
            view_.look.style = document_.view.look.style;
            view_.look.color = document_.view.look.color;
        }
        if (!firstDocument_ && !step && !restoring_) {
            view_.look.rules = document_.view.look.rules;
            view_.words = document_.view.words;
            motion_.set(document_.view.camera);
        }
        firstDocument_ = false;
        if (!step) {
            message_.clear();
            playing_ = false;
        }
        if (aim_.any()) takeAim(std::exchange(aim_, {}), false, now);
    }
    putWords(now);
    if (another) select(step ? selected_.text : "");
    placeSelection();
    hovered_ = 0;
    if (history_.empty())
        history_.begin(view());
    else if (!std::exchange(restoring_, false))
        unremembered_ = true;
    occlusion_ = view_.occlusionDirections ? 0 : 1;
    occlusionRetry_ = {};
    if (!document_.scene.warnings.empty()) say(document_.scene.warnings.front(), now);
    changed(now);
    if (another && (view_.look != document_.view.look || view_.drawn != document_.view.drawn))
        loader_.build(view(), document_.molecule);
}

/// Moves what moves by itself. @returns when something is due
double Viewer::advance(double now) {
    apply(touches_.tick(now), now);
    if (motion_.advance(now)) changed(now);
    if (playing_ && document() && !loader_.busy() && now >= nextModel_) {
        nextModel_ = now + kModelSeconds;
        stepModel(1, now);
    }
    if (!message_.empty() && now >= messageUntil_) {
        message_.clear();
        schedule_.overlayChanged();
    }
    if (hoverAt_ && now >= hoverDue_) hover(now);
    double due = message_.empty() ? kNever : messageUntil_;
    if (hoverAt_) due = std::min(due, hoverDue_);
    if (playing_ && !loader_.busy()) due = std::min(due, nextModel_);
    if (const auto wake = touches_.wake()) due = std::min(due, *wake);
    return due;
}

std::uint32_t Viewer::refinedSamples() const {
    const std::uint32_t n = debug_ == DebugView::none ? options_.mostSamples : 1;  // numbers have no mean
    return n * n;
}

double Viewer::update(double now, const std::function<const Overlay*()>& overlay) {
    tookDocument(now);
    const double due = advance(now);
    const bool hand = now - handMoved_ < kHandSeconds;
    const bool moving = motion_.moving() || hand;
    if (!schedule_.visible()) return kNever;
    if (!sceneThere_ && sceneRetry_.due(now)) putScene(now);
    if (document() && sceneThere_ && occlusion_ < 1 && occlusionRetry_.due(now)) advanceOcclusion(now, moving);
    if (deviceLost_) return now;
    if (!frameRetry_.due(now)) return std::min(due, frameRetry_.at());
    schedule_.setSamples(refinedSamples());
    const FrameSchedule::Next next = schedule_.next(now, moving, occlusion_);
    if (next.draw != Draw::nothing) draw(next, now, moving, overlay);
    const FrameSchedule::Next after = schedule_.next(now, moving, occlusion_);
    double wake = after.draw != Draw::nothing ? now : after.wake;
    if (after.draw == Draw::nothing && !occlusionRetry_.due(now)) wake = occlusionRetry_.at();
    wake = std::min(wake, hand ? handMoved_ + kHandSeconds : kNever);
    if (!sceneThere_) wake = std::min(wake, sceneRetry_.at());
    if (!frameRetry_.due(now)) wake = frameRetry_.at();
    return std::min(due, wake);
}

void Viewer::awaitFrame(double now) {
    const bool moving = motion_.moving() || now - handMoved_ < kHandSeconds;
    if (!schedule_.visible() || deviceLost_ || !frameRetry_.due(now)) return;
    if (schedule_.next(now, moving, occlusion_).draw != Draw::nothing) screen_.awaitFrame();
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
    frame.scale = next.scale;
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
            schedule_.shown(next, now, moving, occlusion_, screen_.frameMilliseconds() / 1000);
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

}  // namespace nacre::app
