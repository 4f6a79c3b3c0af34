#pragma once
// Several molecules in one picture: read one by one, superposed, joined.

#include <functional>
#include <string>
#include <vector>

#include "app/picture/input_options.h"
#include "engine/molecule/molecule.h"

namespace nacre::app {

/// Joins molecules in the order of the INPUTs, fitted as the options say.
/// @param tell  receives the result of each fit, one line
/// @throws Error if a fit has fewer than three pairs of atoms, or moves its reference
Molecule joinInputs(const InputOptions& input, std::vector<Molecule> molecules,
                    const std::function<void(const std::string&)>& tell);

}  // namespace nacre::app
