#pragma once

#include <nlohmann/json.hpp>

#include "engine/molecule/molecule.h"

namespace nacre::app {

/// Output of `info --json` for a molecule: the keys that docs/json.md lists. Those that a format or file lacks are
/// null.
nlohmann::ordered_json infoJson(const Molecule& molecule);

}  // namespace nacre::app
