#pragma once

#include "app/headless/options.h"
#include "engine/molecule/molecule.h"

namespace nacre::app {

/// Reads the molecule that INPUT names. @throws Error
Molecule loadMolecule(const InputOptions& input);

}  // namespace nacre::app
