// Executes the viewer's commands.

#include <utility>

#include "app/picture/looks.h"
#include "app/picture/options.h"
#include "app/viewer/presets.h"
#include "app/viewer/viewer.h"

namespace nacre::app {
namespace {

struct OptionCommand {
    ViewerCommand command;
    const char* key;
    const char* value = nullptr;  ///< value to set; null: the next choice of its control
};

constexpr OptionCommand kOptionCommands[] = {{ViewerCommand::spacefill, "style", "spacefill"},
                                             {ViewerCommand::ballAndStick, "style", "ball-and-stick"},
                                             {ViewerCommand::licorice, "style", "licorice"},
                                             {ViewerCommand::cartoon, "style", "cartoon"},
                                             {ViewerCommand::surface, "style", "surface"},
                                             {ViewerCommand::nextColor, "color"},
                                             {ViewerCommand::nextBackground, "background"},
                                             {ViewerCommand::water, "water"},
                                             {ViewerCommand::hydrogens, "hydrogens"},
                                             {ViewerCommand::perspective, "projection"},
                                             {ViewerCommand::stereo, "stereo"},
                                             {ViewerCommand::lighting, "lighting"},
                                             {ViewerCommand::occlusion, "occlusion"},
                                             {ViewerCommand::legend, "legend"},
                                             {ViewerCommand::scaleBar, "scale-bar"}};

}  // namespace

/// Flies to the picked atoms, else to the ligands, or to the view along the principal axes.
void Viewer::aimAt(ViewerCommand command, double now) {
    if (!stage_.shown()) return;
    Aim aim;
    aim.principal = command == ViewerCommand::orient;
    if (!aim.principal) {
        // Residues, since a single atom has no orientation.
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
    for (const OptionCommand& of : kOptionCommands) {
        if (of.command != command) continue;
        const Option& row = option(of.key);
        if (of.value)
            row.value.parse(of.value, look);
        else
            said = std::string(row.control.label) + ": " + row.control.choices[stepOption(row, look)].label;
        if (!said.empty()) stage_.messages.say(said, now);
        return true;
    }
    switch (command) {
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
        case C::keepMeasurement:
            look = picking_.measuredView();
            picking_.drop();
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
    if (PictureDescription look = view(); changeLook(command, look, now)) {
        const Aim aim = std::exchange(look.aim, view().aim);
        setLook(look, now);
        if (aim.zoomTo) camera_.aim(aim, now);
        return;
    }
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
            if (picking_.picks().empty()) picking_.measure(Measuring::off);
            picking_.drop();
            picking_.select("");
            stage_.messages.clear();
            return stage_.schedule.overlayChanged();
        case C::measure:
            return picking_.measure(
                static_cast<Measuring>((static_cast<std::size_t>(picking_.measuring()) + 1) % std::size(kMeasurings)));
        case C::undo:
            return undo(now);
        case C::redo:
            return redo(now);
        default:
            return;  // handled by the shell
    }
}

}  // namespace nacre::app
