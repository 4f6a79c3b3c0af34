#pragma once
// The options of the commands that draw pictures.

#include "app/cli/options.h"

namespace nacre::app {

/// `nacre looks`.
void addLooks(CommandSpec& command, LooksOptions& options);
/// @throws UsageError
void checkLooks(const LooksOptions& options);

/// --look. Goes behind --view and before the options that it stands for, so that those prevail.
void addLook(CommandSpec& command, RenderOptions& options);
/// Lines, halos, fog, shadow, planes, light.
void addEffects(CommandSpec& command, RenderOptions& options);

void addRender(CommandSpec& command, RenderOptions& options);
void addMovie(CommandSpec& command, MovieOptions& options);
/// What is seen in a movie: its options but for the file and the motion.
void addMoviePicture(CommandSpec& command, RenderOptions& options);
/// What a window shows at first is said as for `render`; `size` is the window's.
void addWindow(CommandSpec& command, RenderOptions& first);

/// Names of several INPUTs, in selections of how they are seen, become what they mean; the carbons of each get a colour
/// of its own, unless a saved view has them.
void nameInputs(RenderOptions& options);
/// What no option alone can tell; INPUT is that of the saved view if there is no other. @throws UsageError
void checkRender(RenderOptions& options);
/// The same for a movie; INPUT may also be that of its first key view. @throws UsageError, Error
void checkMovie(MovieOptions& options);
/// The same for a window. @returns whether there is an INPUT
bool checkWindow(RenderOptions& first);

}  // namespace nacre::app
