#pragma once
// What `nacre bench` says about frames: by every path, and of the one in use what it submits and its floor.

#include <iosfwd>

#include "app/cli/bench_occlusion.h"
#include "app/cli/options.h"
#include "app/cli/progress.h"

namespace nacre::app {

/// Milliseconds of a part after which no further round of it begins.
constexpr double kBenchMilliseconds = 3'000;

/// The settings of a frame of a turn about the vertical axis. @param radius  of the scene @param frame  from 0
RenderSettings benchFrame(const BenchOptions& options, double radius, int frame);

/// Times frames by the paths that were asked for, and adds to a report `paths`, `lacks`, `times`, `floor` and counts.
/// @throws Error if the device lacks the one path that was asked for
void addFrames(const BenchOptions& options, const Representation& scene, Json& report, Progress& progress);

/// What addFrames found, as a table.
void printFrames(const Json& report, std::ostream& out);

}  // namespace nacre::app
