#pragma once

#include <functional>

#include "app/shared/input_options.h"
#include "engine/molecule/molecule.h"

namespace nacre::app {

/// Reads the molecule that INPUT names, downloading it if need be.
/// @param onDownload  called as a download's bytes arrive, with the share that is there, 0..1
/// @throws Error
Molecule loadMolecule(const InputOptions& input, const std::function<void(double)>& onDownload = {});

}  // namespace nacre::app
