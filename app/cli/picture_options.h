#pragma once
// The options of the commands that draw pictures.

#include "app/cli/options.h"

namespace nacre::app {

void addRender(CommandSpec& command, RenderOptions& options);
/// What a window shows at first is said as for `render`; `size` is the window's.
void addWindow(CommandSpec& command, RenderOptions& first);

/// INPUT, or the one of the saved view. @returns whether there is one
bool takeInput(RenderOptions& options);
/// What no option alone can tell. @throws UsageError
void checkDebug(const RenderOptions& options);
void checkRender(RenderOptions& options);

}  // namespace nacre::app
