#pragma once
// `nacre movie`: what moves, how long, and how fast. What is seen is said as for `nacre render`.

#include "app/cli/options.h"

namespace nacre::app {

/// The options of the motion alone.
void addMotion(CommandSpec& command, MovieOptions& options);
/// What no option alone can tell. @throws UsageError
void checkMotion(const MovieOptions& options);

/// Whether an option of the picture was given, by its name without dashes.
bool isGiven(const MovieOptions& options, const char* name);

/// How many frames there are. @param models  of the molecule, if they are to be shown
std::uint64_t framesOf(const MovieOptions& options, std::uint64_t models);

/// Time of a frame, 0..1. What goes round begins anew at 1, which the last frame stays short of; else that is at 1.
double timeOf(const MovieOptions& options, std::uint64_t frame, std::uint64_t frames);

}  // namespace nacre::app
