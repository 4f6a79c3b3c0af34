#pragma once

#include "app/headless/options.h"
#include "engine/molecule/molecule.h"

namespace nacre::app {

/// What is drawn of a molecule, in its style and colours. @throws Error if that is nothing
Representation sceneOf(const Molecule& molecule, const std::string& name, const DrawnAtomsOptions& drawn,
                       const RepresentationOptions& look);

/// Reads the molecule that INPUT names. @throws Error
Molecule loadMolecule(const InputOptions& input);

}  // namespace nacre::app
