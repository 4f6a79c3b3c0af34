#pragma once
// Frames in `nacre bench`: times by path, and submitted geometry and lower bound of the default path.

#include <iosfwd>
#include <nlohmann/json.hpp>

#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "engine/scene/build/representation.h"

namespace nacre::app {

using Json = nlohmann::ordered_json;

/// Times frames by the requested paths, and adds to a report `paths`, `lacks`, `times`, `floor` and counts.
/// @throws Error if the device lacks the only path requested
void addFrames(const BenchOptions& options, const Representation& scene, Json& report, Progress& progress);

/// The report as a table.
void printFrames(const Json& report, std::ostream& out);

}  // namespace nacre::app
