#pragma once
// The options of the commands that draw pictures.

#include <CLI/CLI.hpp>

#include "app/cli/options.h"

namespace nacre::app {

void addRender(CLI::App& app, RenderOptions& options);
#ifdef NACRE_DESKTOP
void addWindow(CLI::App& app, ViewOptions& options);
#endif

/// INPUT, or the one of the saved view. @returns whether there is one
bool takeInput(RenderOptions& options);
/// What no option alone can tell. @throws UsageError
void checkDebug(const RenderOptions& options);
void checkRender(RenderOptions& options);

}  // namespace nacre::app
