#pragma once
// What `nacre bench` says about frames: by every path, and of the one in use what it submits and its floor.

#include <iosfwd>
#include <nlohmann/json.hpp>

#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "engine/scene/representation.h"

namespace nacre::app {

using Json = nlohmann::ordered_json;

/// Times frames by the paths that were asked for, and adds to a report `paths`, `lacks`, `times`, `floor` and counts.
/// @throws Error if the device lacks the one path that was asked for
void addFrames(const BenchOptions& options, const Representation& scene, Json& report, Progress& progress);

/// What addFrames found, as a table.
void printFrames(const Json& report, std::ostream& out);

}  // namespace nacre::app
