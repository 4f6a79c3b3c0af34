#pragma once
// Several molecules in one picture: read one by one, laid onto each other, joined.

#include <functional>
#include <string>
#include <vector>

#include "app/picture/input_options.h"
#include "engine/molecule/molecule.h"

namespace nacre::app {

/// One molecule of those that were read, in the order of the INPUTs, fitted as the options say.
/// @param tell  what each fit came to, in a line
/// @throws Error if a fit has fewer than three pairs of atoms, or moves what it stays on
Molecule joinInputs(const InputOptions& input, std::vector<Molecule> molecules,
                    const std::function<void(const std::string&)>& tell);

}  // namespace nacre::app
