#pragma once
// What `nacre bench` says about the occlusion bake.

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/renderer.h"

namespace nacre::app {

using Json = nlohmann::ordered_json;

/// {"min", "median", "p99"} of times; at least one.
Json timesJson(std::vector<double> samples);

/// Times the whole bake by every path of its depth maps, each in turn within a round, so that the machine's moods meet
/// all of them. @returns a row for each path; none if there are no directions
Json compareMaps(RenderSettings settings, Renderer& renderer);

/// The rows of compareMaps as a table.
void printOcclusion(const Json& rows, std::ostream& out);

}  // namespace nacre::app
