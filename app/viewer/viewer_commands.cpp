// What the viewer does at a command.

#include <algorithm>
#include <glm/trigonometric.hpp>

#include "app/picture/appearance_values.h"
#include "app/picture/looks.h"
#include "app/picture/option_text.h"
#include "app/viewer/presets.h"
#include "app/viewer/viewer.h"

namespace nacre::app {
namespace {

constexpr double kKeyDegrees = 5, kKeyPoints = 20, kKeyZoom = 1.15;

/// The choice after `current`, the first if that is none of them.
std::string nextOf(std::span<const char* const> choices, const std::string& current) {
    const auto at = std::find(choices.begin(), choices.end(), current);
    return at == choices.end() || at + 1 == choices.end() ? choices[0] : at[1];
}

}  // namespace

/// Commands of the camera. @returns whether it was one
bool Viewer::moveCamera(ViewerCommand command, double now) {
    using C = ViewerCommand;
    const Viewport v = viewport();
    const glm::dvec2 middle(v.width / 2, v.height / 2);
    const auto rotate = [&](double x, double y) {
        remember();
        motion_.touch();
        motion_.rotate({x * kKeyDegrees, y * kKeyDegrees}, now);
        changed(now);
    };
    const auto pan = [&](double x, double y) {
        remember();
        motion_.pan({x * kKeyPoints, y * kKeyPoints}, radius(), v);
        changed(now);
    };
    switch (command) {
        case C::rotateLeft:
            rotate(-1, 0);
            return true;
        case C::rotateRight:
            rotate(1, 0);
            return true;
        case C::rotateUp:
            rotate(0, -1);
            return true;
        case C::rotateDown:
            rotate(0, 1);
            return true;
        case C::panLeft:
            pan(-1, 0);
            return true;
        case C::panRight:
            pan(1, 0);
            return true;
        case C::panUp:
            pan(0, -1);
            return true;
        case C::panDown:
            pan(0, 1);
            return true;
        case C::zoomIn:
        case C::zoomOut:
            remember();
            motion_.zoom(command == C::zoomIn ? kKeyZoom : 1 / kKeyZoom, middle, radius(), v);
            changed(now);
            return true;
        case C::rollLeft:
        case C::rollRight:
            remember();
            motion_.roll(glm::radians(command == C::rollRight ? kKeyDegrees : -kKeyDegrees));
            changed(now);
            return true;
        case C::fit:
            remember();
            motion_.fit(now);
            unclip();
            return true;
        case C::reset:
            remember();
            motion_.reset(now);
            unclip();
            return true;
        case C::rock: {
            const bool on = !motion_.rocking();
            remember();
            motion_.touch();
            motion_.setRocking(on);
            return true;
        }
        case C::autoRotate: {
            const bool on = !motion_.autoRotation();
            remember();
            motion_.touch();
            motion_.setAutoRotation(on);
            return true;
        }
        default:
            return false;
    }
}

/// Commands that go by the molecule. @returns whether it was one
bool Viewer::aimCamera(ViewerCommand command, double now) {
    using C = ViewerCommand;
    if (command != C::orient && command != C::lookAt && command != C::zoomTo) return false;
    if (!document()) return true;
    // Residues, for one atom alone is no place.
    std::string picked;
    for (const std::uint32_t pick : picks_) picked += (picked.empty() ? "byres id " : "+") + std::to_string(pick + 1);
    Aim aim;
    aim.principal = command == C::orient;
    if (command == C::lookAt) aim.lookAt = parseSelection(picked.empty() ? "ligand" : picked);
    if (command == C::zoomTo) aim.zoomTo = parseSelection(picked.empty() ? "ligand" : picked);
    takeAim(aim, true, now);
    return true;
}

void Viewer::run(ViewerCommand command, double now) {
    using C = ViewerCommand;
    if (moveCamera(command, now) || aimCamera(command, now)) return;
    SavedView look = view();
    switch (command) {
        case C::spacefill:
            look.look.style = Style::spacefill;
            break;
        case C::ballAndStick:
            look.look.style = Style::ballAndStick;
            break;
        case C::licorice:
            look.look.style = Style::licorice;
            break;
        case C::nextColor:
            look.look.color = parseColoring(nextOf(colorChoices(), coloringText(look.look.color)));
            say("colours: " + coloringText(look.look.color), now);
            break;
        case C::nextPreset:
            preset_ = (preset_ + 1) % presets().size();
            applyPreset(presets()[preset_], look);
            say(presets()[preset_].name, now);
            break;
        case C::nextLook:
            lookNumber_ = (lookNumber_ + 1) % looks().size();
            applyLook(looks()[lookNumber_], look);
            say("look: " + looks()[lookNumber_].name, now);
            break;
        case C::nextBackground:
            look.background = parseColor(nextOf(backgroundChoices(), backgroundText(look.background)));
            break;
        case C::water:
            look.drawn.water = !look.drawn.water;
            say(look.drawn.water ? "water shown" : "water hidden", now);
            break;
        case C::hydrogens:
            look.drawn.hydrogens = !look.drawn.hydrogens;
            say(look.drawn.hydrogens ? "hydrogens shown" : "hydrogens hidden", now);
            break;
        case C::perspective:
            look.camera.projection =
                look.camera.projection == Projection::orthographic ? Projection::perspective : Projection::orthographic;
            break;
        case C::lighting:
            look.lighting = !look.lighting;
            break;
        case C::occlusion:
            look.occlusionDirections = look.occlusionDirections ? 0 : SavedView{}.occlusionDirections;
            break;
        case C::keepMeasurement:
            look = savedView();
            picks_.clear();
            break;
        case C::legend:
            look.words.legend = !look.words.legend;
            break;
        case C::scaleBar:
            look.words.scaleBar = static_cast<ScaleBar>((static_cast<int>(look.words.scaleBar) + 1) % 3);
            break;
        case C::nextModel:
        case C::previousModel:
            return stepFrame(command == C::nextModel ? 1 : -1, now);
        case C::firstModel:
            return showFrame(0, now);
        case C::lastModel:
            return showFrame(playback_.frames(), now);
        case C::playModels:
            return setPlaying(!playback_.playing(), now);
        case C::slower:
        case C::faster:
            playback_.stepRate(command == C::faster ? 1 : -1);
            return say(rateText(playback_.rate()), now);
        case C::clearPicks:
            if (question_) return answer(false, now);
            if (!failure_.empty()) return dismissFailure();
            picks_.clear();
            select("");
            message_.clear();
            return schedule_.overlayChanged();
        case C::undo:
            return undo(now);
        case C::redo:
            return redo(now);
        default:
            return;  // the shell's
    }
    setLook(look, now);
}

}  // namespace nacre::app
