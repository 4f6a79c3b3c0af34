// What the viewer does at a command.

#include <algorithm>

#include "app/picture/appearance_values.h"
#include "app/picture/looks.h"
#include "app/picture/option_text.h"
#include "app/viewer/presets.h"
#include "app/viewer/viewer.h"

namespace nacre::app {
namespace {

/// The choice after `current`, the first if that is none of them.
std::string nextOf(std::span<const char* const> choices, const std::string& current) {
    const auto at = std::find(choices.begin(), choices.end(), current);
    return at == choices.end() || at + 1 == choices.end() ? choices[0] : at[1];
}

std::vector<const char*> colorOptions() {
    std::vector<const char*> options;
    for (const ColorWord& word : colorWords()) options.push_back(word.option);
    return options;
}

}  // namespace

/// Flies to what is picked, to ligands where nothing is, or to where the molecule lies flat.
void Viewer::aimAt(ViewerCommand command, double now) {
    if (!stage_.shown()) return;
    Aim aim;
    aim.principal = command == ViewerCommand::orient;
    if (!aim.principal) {
        // Residues, for one atom alone is no place.
        std::string picked;
        for (const std::uint32_t pick : picking_.picks())
            picked += (picked.empty() ? "byres id " : "+") + std::to_string(pick + 1);
        const Selection to = parseSelection(picked.empty() ? "ligand" : picked);
        (command == ViewerCommand::lookAt ? aim.lookAt : aim.zoomTo) = to;
    }
    camera_.take(aim, true, now);
}

/// @returns whether it was a command that changes the look
bool Viewer::changeLook(ViewerCommand command, PictureDescription& look, double now) {
    using C = ViewerCommand;
    std::string said;
    const auto toggle = [](bool& value) { return value = !value; };
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
            look.look.color = parseColoring(nextOf(colorOptions(), coloringText(look.look.color)));
            said = "colours: " + coloringText(look.look.color);
            break;
        case C::nextPreset:
            preset_ = (preset_ + 1) % presets().size();
            applyPreset(presets()[preset_], look);
            said = presets()[preset_].name;
            break;
        case C::nextLook:
            look_ = (look_ + 1) % looks().size();
            applyLook(looks()[look_], look);
            said = "look: " + looks()[look_].name;
            break;
        case C::nextBackground:
            look.background = parseColor(nextOf(backgroundChoices(), backgroundText(look.background)));
            break;
        case C::water:
            said = toggle(look.drawn.water) ? "water shown" : "water hidden";
            break;
        case C::hydrogens:
            said = toggle(look.drawn.hydrogens) ? "hydrogens shown" : "hydrogens hidden";
            break;
        case C::perspective:
            look.camera.projection =
                look.camera.projection == Projection::orthographic ? Projection::perspective : Projection::orthographic;
            break;
        case C::lighting:
            toggle(look.lighting);
            break;
        case C::occlusion:
            look.occlusion.directions = look.occlusion.directions ? 0 : PictureDescription{}.occlusion.directions;
            break;
        case C::keepMeasurement:
            look = picking_.savedView();
            picking_.drop();
            break;
        case C::legend:
            toggle(look.words.legend);
            break;
        case C::scaleBar:
            look.words.scaleBar = static_cast<ScaleBar>((static_cast<int>(look.words.scaleBar) + 1) % 3);
            break;
        default:
            return false;
    }
    if (!said.empty()) stage_.messages.say(said, now);
    return true;
}

void Viewer::run(ViewerCommand command, double now) {
    using C = ViewerCommand;
    if (camera_.run(command, now)) return;
    if (PictureDescription look = view(); changeLook(command, look, now)) return setLook(look, now);
    switch (command) {
        case C::orient:
        case C::lookAt:
        case C::zoomTo:
            return aimAt(command, now);
        case C::nextModel:
        case C::previousModel:
            return playback_.step(command == C::nextModel ? 1 : -1, now);
        case C::firstModel:
            return playback_.show(0, now);
        case C::lastModel:
            return playback_.show(playback_.clock().frames(), now);
        case C::playModels:
            return playback_.playing() ? playback_.stop() : playback_.play(now);
        case C::slower:
        case C::faster:
            return playback_.stepRate(command == C::faster ? 1 : -1, now);
        case C::clearPicks:
            if (reading_.question()) return reading_.answer(false, now);
            if (!stage_.messages.failure().empty()) return stage_.messages.dismissFailure();
            picking_.drop();
            picking_.select("");
            stage_.messages.clear();
            return stage_.schedule.overlayChanged();
        case C::undo:
            return undo(now);
        case C::redo:
            return redo(now);
        default:
            return;  // the shell's
    }
}

}  // namespace nacre::app
