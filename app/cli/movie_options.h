#pragma once
// `nacre movie`: motion, duration and frame rate. Options of the picture are those of `nacre render`.

#include "app/cli/options.h"

namespace nacre::app {

/// The options of the motion only.
void addMotion(CommandSpec& command, MovieOptions& options);
/// The inputs after the first are conformations of it, not molecules beside it. @throws UsageError
void takeMorph(MovieOptions& options);
/// Checks that need more than one option. @throws UsageError
void checkMotion(const MovieOptions& options);

/// Whether an option of the picture was given. @param name  without dashes
bool isGiven(const MovieOptions& options, const char* name);

/// Number of frames. @param models  of the molecule, if they are to be shown
std::uint64_t framesOf(const MovieOptions& options, std::uint64_t models);

/// Time of a frame, 0..1. In a loop the last frame is before 1, which is the start again; otherwise it is at 1.
double timeOf(const MovieOptions& options, std::uint64_t frame, std::uint64_t frames);

}  // namespace nacre::app
