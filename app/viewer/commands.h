#pragma once
// What keys, panel and menus can ask of the viewer. One table gives every command its keys and its words, so that the
// help cannot miss one.

#include <optional>
#include <span>

#include "app/viewer/events.h"

namespace nacre::app {

enum class ViewerCommand {
    rotateLeft,
    rotateRight,
    rotateUp,
    rotateDown,
    panLeft,
    panRight,
    panUp,
    panDown,
    zoomIn,
    zoomOut,
    rollLeft,
    rollRight,
    fit,
    reset,
    orient,
    lookAt,
    zoomTo,
    autoRotate,
    rock,
    nextModel,
    previousModel,
    playModels,
    firstModel,
    lastModel,
    slower,
    faster,
    spacefill,
    ballAndStick,
    licorice,
    cartoon,
    surface,
    nextColor,
    nextPreset,
    nextLook,
    nextBackground,
    water,
    hydrogens,
    perspective,
    lighting,
    occlusion,
    measure,
    keepMeasurement,
    legend,
    scaleBar,
    clearPicks,
    undo,
    redo,
    openFile,
    saveAs,
    copyPicture,
    savePicture,
    saveView,
    keepView,
    record,
    captureFrame,
    panel,
    help,
    quit,
};

struct Binding {
    ViewerCommand command;
    KeyEvent key;
    const char* keys;  ///< as the help names them
    const char* what;
    bool listed = true;  ///< in the help; what developers use is not
};

std::span<const Binding> keyBindings();
std::optional<ViewerCommand> commandOf(const KeyEvent& event);

/// What the pointer and fingers do; for the help.
struct PointerBinding {
    const char* mouse;  ///< null: it has none
    const char* touch;
    const char* what;
};
std::span<const PointerBinding> pointerBindings();

}  // namespace nacre::app
