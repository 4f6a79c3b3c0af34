#pragma once
// Commands for keys, panel and menus. One table contains each command's keys and text, so that the help is always
// complete.

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
    stereo,
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
    saveScene,
    keepView,
    record,
    captureFrame,
    panel,
    fullScreen,
    palette,
    help,
    quit,
};

struct Binding {
    ViewerCommand command;
    KeyEvent key;
    const char* keys;  ///< as shown in the help
    const char* what;
    bool listed = true;  ///< shown in the help; developers' commands are not
};

std::span<const Binding> keyBindings();
std::optional<ViewerCommand> findCommand(const KeyEvent& event);

/// Actions of pointer and fingers, for the help.
struct PointerBinding {
    const char* mouse;  ///< null: none
    const char* touch;
    const char* what;
};
std::span<const PointerBinding> pointerBindings();

}  // namespace nacre::app
