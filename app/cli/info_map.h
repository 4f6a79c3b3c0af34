#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "engine/volume/density_map.h"

namespace nacre::app {

/// What `info --json` says of a density map: format, and `map`: grid (nodes along a, b, c: of a crystal's whole cell,
/// else of the box), cell (a, b, c in Å and three angles in degrees), origin (place of the file's first node, Å), axes
/// (which of a, b, c columns, rows and sections of the file are), space_group, box {size, start} as the file has it,
/// and of the grid's known values min, max, mean and rms (deviation from the mean: 1 sigma).
nlohmann::ordered_json mapInfoJson(const DensityMap& map);

/// The same for people.
std::string mapInfoText(const std::string& name, const nlohmann::ordered_json& json);

}  // namespace nacre::app
