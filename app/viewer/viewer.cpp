#include "app/viewer/viewer.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/annotation/measurement.h"
#include "app/drawing/aim.h"
#include "app/picture/input_names.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr double kHandSeconds = 0.1;  // a hand that rests this long no longer moves the picture
constexpr double kMessageSeconds = 4;
constexpr double kHoverSeconds = 0.08;  // that a pointer rests before what it is over is looked for

}  // namespace

std::string Viewer::nameOf(const std::string& input) {
    return input.starts_with("sample:") ? input : std::filesystem::path(input).filename().string();
}

double Viewer::handRests() const { return handMoved_ + kHandSeconds; }

Viewer::Viewer(Screen& screen, Sources sources, const SavedView& view, const ViewerOptions& options,
               std::function<void()> wake)
    : screen_(screen), options_(options), loader_(std::move(sources), wake), view_(view), wake_(wake) {
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
    hoverAgain(now);
    schedule_.windowChanged(now);
}

void Viewer::touch(const TouchEvent& event, double now) { apply(touches_.handle(event, now), now); }

void Viewer::mouseMove(glm::dvec2 at, double now) {
    const Viewport v = viewport();
    const bool held = mouse_.held();
    apply(mouse_.move(at, freeOrigin() + glm::dvec2(v.width / 2, v.height / 2)), now);
    if (held) return pointerLeft();
    pointerAt_ = at;
    hoverDue_ = now + kHoverSeconds;
}

/// Something else may lie under the pointer by now: what did has no name any longer, and what does is looked for when
/// it has come to rest.
void Viewer::hoverAgain(double now) {
    hovered_ = 0;
    if (pointerAt_) hoverDue_ = now + kHoverSeconds;
}

void Viewer::mouseButton(MouseButton button, bool down, glm::dvec2 at, Modifiers with, double now) {
    apply(mouse_.button(button, down, at, with, now), now);
}

void Viewer::wheel(double steps, glm::dvec2 at, double now) {
    if (now >= handRests()) remember();
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
            case Gesture::Kind::undo:
                undo(now);
                break;
            case Gesture::Kind::redo:
                redo(now);
                break;
        }
    }
}

void Viewer::aim(const Aim& aim, double now) {
    if (loader_.busy() || !document())
        aim_ = aim;
    else
        takeAim(aim, true, now);
}

/// What a close-up cut away, or a view left out, comes back.
void Viewer::unclip() {
    if (std::exchange(clipped_, false)) view_.effects.clip.near = -Clip::kNone;
    if (!std::exchange(view_.uncover, std::nullopt) || !document_.molecule) return;
    loader_.build(view(), document_);
}

void Viewer::takeAim(Aim aim, bool fly, double now) {
    for (std::optional<Selection>* selection : {&aim.lookAt, &aim.zoomTo, &aim.uncover})
        if (*selection && !document_.view.further.empty()) nameInputs(inputNames(inputOf(document_.view)), **selection);
    try {
        Camera from = motion_.camera();
        if (aim.zoomTo || aim.principal) from.zoom = 1;
        const Aimed to = aimed(from, aim, *document_.placed, document_.scene, {freeSize().width, freeSize().height});
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

void Viewer::setCovered(const Insets& pixels, double now) {
    if (pixels == covered_) return;
    covered_ = pixels;
    hoverAgain(now);
    schedule_.windowChanged(now);
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
    if (document())
        for (const FurtherInput& further : document_.view.further) title += " + " + nameOf(further.path);
    if (question_) title = "question";
    if (loader_.busy()) title += title.empty() ? "reading" : ", building";
    if (document() && occlusion_ < 1 && !playback_.playing())
        title += ", occlusion " + std::to_string(static_cast<int>(100 * occlusion_)) + " %";
    return title.empty() ? "Nacre" : title + " - Nacre";
}

}  // namespace nacre::app
