#pragma once

#include <nlohmann/json.hpp>

#include "engine/molecule/molecule.h"

namespace nacre::app {

/// Output of `info --json` for a molecule: the keys that docs/json.md lists. Those that a format or file lacks are
/// null.
nlohmann::ordered_json infoJson(const Molecule& molecule);
/// A row of its list `reading`.
nlohmann::ordered_json noteJson(const ReadNote& note);

}  // namespace nacre::app
