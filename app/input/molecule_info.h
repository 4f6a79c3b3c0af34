#pragma once

#include <nlohmann/json.hpp>

#include "engine/molecule/molecule.h"

namespace nacre::app {

/// Output of `info --json` for a molecule: the keys listed in docs/json.md. Keys that a format or file lacks are null.
nlohmann::ordered_json infoJson(const Molecule& molecule);
/// An entry of its list `reading`.
nlohmann::ordered_json noteJson(const ReadNote& note);

}  // namespace nacre::app
