#pragma once
// `nacre movie`: motion, duration and frame rate. Options of the picture are those of `nacre render`.

#include "app/cli/options.h"

namespace nacre::app {

/// The options of the motion only.
void addMotion(CommandSpec& command, MovieOptions& options);
/// Makes the inputs after the first its conformations, not additional molecules. @throws UsageError
void takeMorph(MovieOptions& options);
/// Checks that need more than one option. @throws UsageError
void checkMotion(const MovieOptions& options);

/// Whether an option of the picture was given. @param name  without dashes
bool isGiven(const MovieOptions& options, const char* name);

/// Number of frames. @param models  of the molecule, if the movie shows them
std::uint64_t countFrames(const MovieOptions& options, std::uint64_t models);

/// Time of a frame, 0..1. In a loop the last frame is before 1, which equals the start; otherwise it is at 1.
double frameTime(const MovieOptions& options, std::uint64_t frame, std::uint64_t frames);

}  // namespace nacre::app
