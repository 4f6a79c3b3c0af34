#include "app/viewer/viewer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "app/drawing/complete.h"
#include "app/drawing/focus.h"
#include "app/picture/input_names.h"
#include "app/picture/looks.h"
#include "app/picture/option_text.h"
#include "app/picture/options.h"
#include "app/viewer/explanation.h"
#include "app/viewer/file_kind.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr double kOneTurn = 1;  // seconds within which steps of a wheel form one undo step

std::string displayName(const std::string& input) {
    return input.starts_with("sample:") ? input : std::filesystem::path(input).filename().string();
}

}  // namespace

Viewer::Viewer(Screen& screen, Sources sources, const PictureDescription& view, const ViewerOptions& options,
               std::function<void()> wake)
    : stage_(view, options.errorsStay),
      frames_(screen, stage_, options),
      reading_(stage_, std::move(sources), wake),
      words_(stage_, frames_),
      picking_(stage_, frames_),
      playback_(
          stage_, frames_, reading_,
          [this](double now) {
              words_.follow(now);
              picking_.placeSelection();
          },
          wake),
      camera_(stage_, frames_, reading_) {}

// --- events

void Viewer::mouseMove(glm::dvec2 at, double now) {
    const Viewport v = frames_.viewport();
    const bool held = mouse_.held();
    apply(mouse_.move(at, frames_.freeOrigin() + glm::dvec2(v.width / 2, v.height / 2)), now);
    if (held)
        picking_.pointerLeft();
    else
        picking_.pointerMoved(at, now);
}

void Viewer::mouseButton(MouseButton button, bool down, glm::dvec2 at, Modifiers with, double now) {
    apply(mouse_.button(button, down, at, with, now), now);
}

void Viewer::wheel(double steps, glm::dvec2 at, double now) {
    if (now >= stage_.handRests()) stage_.remember();
    apply(mouse_.wheel(steps, at), now);
}

void Viewer::changeLevel(double steps, double now) {
    const MapOptions& maps = view().maps;
    std::size_t map = 0;
    while (map < maps.slices.size() && maps.slices[map].axis >= 0) ++map;
    if (!document() || map >= maps.files.size() || map >= document()->drawing.maps().sigmas.size())
        return messages().say("there is no density map", now);
    PictureDescription look = view();
    std::vector<MapLevel>& levels = look.maps.levels;
    levels.resize(std::max(levels.size(), map + 1));
    // A changed level is not built yet: counts from it.
    const bool turned = levels[map].unit == MapLevel::Unit::sigma;
    const double sigma = turned ? levels[map].value : document()->drawing.maps().sigmas[map];
    levels[map] = {MapLevel::Unit::sigma, std::round((sigma + 0.1 * steps) * 10) / 10};
    setLook(look, now, now < levelTurned_ + kOneTurn);
    levelTurned_ = now;
    messages().say("Level: " + numberText(levels[map].value) + " σ", now);
}

void Viewer::apply(const std::vector<Gesture>& gestures, double now) {
    for (const Gesture& g : gestures) {
        if (camera_.apply(g, now)) continue;
        if (g.kind == Gesture::Kind::undo) {
            undo(now);
        } else if (g.kind == Gesture::Kind::redo) {
            redo(now);
        } else if (g.kind == Gesture::Kind::menu) {
            picking_.ask(g.at, now);
        } else if (g.kind != Gesture::Kind::doubleTap) {
            picking_.tap(g.at, now);
        } else if (auto residue = picking_.doubleTap(g.at, now)) {
            Aim aim;
            aim.zoomTo = std::move(residue);
            camera_.take(aim, true, now);
        } else {
            camera_.fit(now);
        }
    }
}

void Viewer::pause() {
    stage_.schedule.setVisible(false);
    picking_.pointerLeft();
    touches_.clear();
    mouse_.clear();
    stage_.motion.touch();
}

void Viewer::resume(double now) {
    stage_.schedule.setVisible(true);
    stage_.schedule.windowChanged(now);
}

// --- files

void Viewer::open(const std::vector<std::string>& paths, bool beside, double now) {
    const auto view = std::ranges::find_if(paths, [](const auto& path) { return detectKind(path) == FileKind::view; });
    if (view == paths.end()) return beside ? reading_.add(paths, now) : reading_.open(paths, now);
    messages().dismissFailure();
    try {
        if (paths.size() > 1) throw Error("cannot open", *view, "a saved view opens alone: choose one file");
        showFile(*view, now);
    } catch (const std::exception& error) {
        messages().fail(error.what(), now);
    }
}

/// Shows a saved view; one without a structure, or a look, changes the current scene. @throws Error, UsageError
void Viewer::showFile(const std::string& path, double now) {
    PictureDescription to;
    applySavedView(path, to);
    if (to.input.path.empty()) {
        if (!stage_.shown())
            throw Error("cannot open", path, "it names no structure: open one first, then this file changes it");
        to = view();
        if (const auto look = lookAlone(path)) {
            applyLook(*look, to);
        } else {
            to.look.rules.clear();
            to.words = {};
            applySavedView(path, to);
        }
    }
    takeInput(to);
    takeMap(to);
    takeSeveral(to);
    show(withWholePaths(std::move(to)), now);
}

// --- current state

void Viewer::setLook(const PictureDescription& look, double now, bool continues) {
    const PictureDescription before = view();
    if (!continues) stage_.remember();
    stage_.history.acted();
    PictureDescription& wanted = stage_.wanted();
    wanted = look;
    nameInputs(wanted);
    stage_.motion.setProjection(look.camera.projection);
    stage_.changed(now);
    const Facets parts = difference(before, view());
    // Words that do not apply to this molecule are refused.
    if (has(parts, Facet::annotation) && !words_.place(now)) wanted.words = before.words;
    // The document being read will be shown in this look.
    const Rebuild rebuild = rebuildFor(before, view(), CameraBy::hand);
    if ((rebuild.scene || rebuild.maps) && stage_.shown() && !reading_.another()) reading_.build();
    if (has(parts, Facet::occlusion)) frames_.restartOcclusion();
}

void Viewer::undo(double now) {
    if (!stage_.shown()) return;
    if (const PictureDescription* to = stage_.history.undo(stage_.destination())) return restore(*to, now);
    stage_.messages.say("nothing to undo", now);
}

void Viewer::redo(double now) {
    if (!stage_.shown()) return;
    if (const PictureDescription* to = stage_.history.redo(stage_.destination())) return restore(*to, now);
    stage_.messages.say("nothing to redo", now);
}

void Viewer::show(const PictureDescription& to, double now, double seconds) {
    stage_.remember();
    restore(to, now, seconds);
    stage_.history.acted();
}

void Viewer::restore(const PictureDescription& saved, double now, double seconds) {
    const PictureDescription to = stage_.relative(saved);
    // The document may still be older than the wanted view.
    const Document& document = stage_.document;
    const Facets seen = difference(view(), to), parts = difference(document.view, to);
    const bool file = !stage_.shown() || has(parts, Facet::input);
    const bool oneModel = to.input.model != kAllModels && document.view.input.model != kAllModels;
    const bool frame =
        !file && document.moves() && oneModel && to.look.assembly == document.view.look.assembly;  // by the player
    const bool another = file || (!frame && has(parts, Facet::frame));
    const Rebuild rebuild = rebuildFor(view(), to, CameraBy::hand);
    CameraMotion& motion = stage_.motion;
    Camera camera = motion.camera();
    stage_.wanted() = to;
    if (!another || !to.camera.center) {  // else it takes the camera on arrival
        camera.projection = to.camera.projection;
        camera.fovDegrees = to.camera.fovDegrees;
        motion.set(camera);
        motion.fly(to.camera, now, seconds);
    }
    playback_.stop();
    camera_.forgetClip();
    stage_.messages.dismissFailure();
    if (another || rebuild.scene || rebuild.maps || reading_.loader().busy()) reading_.restore(to, another);
    if (!another) words_.place(now);
    if (frame) playback_.restore(to);
    if (has(seen, Facet::occlusion)) frames_.restartOcclusion();
    stage_.changed(now);
}

void Viewer::takeDocument(double now) {
    std::optional<Document> document = reading_.take(now);
    if (!document) return;
    if (document->molecule != stage_.document.molecule) frames_.setMarks({});
    try {
        frames_.setScene(document->drawing);
    } catch (const Error& error) {
        return stage_.messages.fail(error.what(), now);  // the previous document stays
    }
    const Reading::Arrival arrival = reading_.arrive(std::move(*document));
    if (arrival.another) {
        picking_.drop();
        if (!arrival.step) stage_.messages.clear();
    }
    if (arrival.opened) camera_.alignToAxes();
    camera_.arrived(!arrival.another, now);
    playback_.arrived(arrival);
    words_.place(now);
    if (view().input.path != saved_.input.path) noteSaved();
    if (arrival.another && !arrival.step) picking_.select("");
    picking_.placeSelection();
    if (stage_.history.empty())
        stage_.history.begin(view());
    else if (!arrival.restored)
        stage_.history.acted();
    frames_.restartOcclusion();
    frames_.retryOcclusion();
    const Document& shown = stage_.document;
    if (const auto& warnings = shown.drawing.scene().warnings; !warnings.empty())
        stage_.messages.say(warnings.front(), now);
    stage_.changed(now);
    if (arrival.another && has(difference(shown.view, view()), Facet::scene)) reading_.build();
}

/// Whether the camera's focus has left the one around which maps are drawn.
bool Viewer::focusMoved() const {
    constexpr double kFollows = 0.1;  // of the maps' radius
    const PictureDescription& wanted = view();
    const Drawing& drawing = stage_.document.drawing;
    const std::optional<glm::dvec3>& followed = drawing.maps().focus;
    if (!wanted.maps.aroundFocus || !followed) return false;
    const glm::dvec3 focus =
        findFocus(*document()->molecule, wanted, {wanted.camera, stage_.radius()}, drawing.scene().center);
    const double reach = wanted.maps.reach.value_or(wanted.maps.usualReach());
    return glm::distance(focus, *followed) > kFollows * reach;
}

/// Redraws maps around the camera's focus, once that rests.
void Viewer::followCamera(double now) {
    if (!stage_.shown() || followed_ == stage_.changes()) return;
    if (stage_.moving(now) || playback_.playing() || reading_.loader().busy()) return;
    followed_ = stage_.changes();
    if (focusMoved()) reading_.build();
}

std::string Viewer::explanation() const {
    if (stage_.shown() && stage_.document.molecule->guide)
        return "Styles, colours and view are those of the scene's file.";
    if (!stage_.shown()) return {};
    const Drawing& drawing = stage_.document.drawing;
    if (std::exchange(explained_, drawing.sceneNumber()) != drawing.sceneNumber())
        explanation_ = explanationText(stage_.document.view, drawing);
    return explanation_;
}

bool Viewer::hasUnsavedWork() const {
    return stage_.shown() && (view().words != saved_.words || view().look.rules != saved_.look.rules);
}

std::string Viewer::title() const {
    std::string title;
    if (stage_.shown()) {
        const PictureDescription& view = stage_.document.view;
        title = displayName(view.input.path);
        for (const FurtherInput& further : view.input.further) title += " + " + displayName(further.path);
    }
    if (reading_.question()) title = "question";
    if (title.empty() && reading_.failed()) title = "not opened";
    if (reading_.loader().busy()) title += title.empty() ? "reading" : ", building";
    if (stage_.shown() && frames_.occlusion() < 1 && !playback_.playing())
        title += ", occlusion " + std::to_string(static_cast<int>(100 * frames_.occlusion())) + " %";
    return title.empty() ? "Nacre" : title + " - Nacre";
}

// --- time

/// Advances automatic motion. @returns when something is due
double Viewer::advance(double now) {
    apply(touches_.tick(now), now);
    if (stage_.motion.advance(now)) stage_.changed(now);
    followCamera(now);
    double due = playback_.advance(now);
    due = std::min(due, stage_.messages.advance(now));
    due = std::min(due, picking_.advance(now));
    return std::min(due, touches_.wake().value_or(due));
}

double Viewer::update(double now, const std::function<const Overlay*()>& overlay) {
    takeDocument(now);
    const double due = advance(now);
    if (!stage_.schedule.visible()) return std::numeric_limits<double>::infinity();
    const double wake = frames_.update(now, playback_.playing(), overlay);
    if (frames_.drew() && reading_.loader().busy()) frames_.expectScene(reading_.loader().view());
    return std::min(due, wake);
}

}  // namespace nacre::app
