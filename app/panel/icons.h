#pragma once
// Icons of buttons, drawn as lines.

#include <imgui.h>

namespace nacre::app {

enum class Icon {
    none,
    open,
    save,
    undo,
    redo,
    fit,
    spin,
    help,
    close,
    fold,
    eye,
    eyeOff,
    play,
    pause,
    up,
    down,
    copy,
    look,
    parts,
    select,
    label,
    more,
    previous,
    next,
    record
};

/// @param middle, size  of its square, pixels
void drawIcon(ImDrawList& list, Icon icon, ImVec2 middle, float size, ImU32 color);

}  // namespace nacre::app
