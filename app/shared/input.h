#pragma once

#include <functional>

#include "app/cli/options.h"
#include "engine/molecule/molecule.h"

namespace nacre::app {

/// What is drawn of a molecule, in its style and colours. @throws Error if that is nothing
Representation sceneOf(const Molecule& molecule, const std::string& name, const DrawnAtomsOptions& drawn,
                       const RepresentationOptions& look);

/// Reads the molecule that INPUT names, downloading it if need be.
/// @param onDownload  called as a download's bytes arrive, with the share that is there, 0..1
/// @throws Error
Molecule loadMolecule(const InputOptions& input, const std::function<void(double)>& onDownload = {});

/// Folder that finished bakes are kept in; empty: none are.
std::string occlusionCacheFolder(const InputOptions& input);

}  // namespace nacre::app
