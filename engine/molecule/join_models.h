#pragma once
// Joins all models of a file into one molecule.

#include <string>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Atoms, residues and bonds of the models in order. Chains stay separate and keep their model, so that bonds and
/// selections do not cross models; subchains and entities with the same name are merged. Title and assemblies are those
/// of the first model.
/// @param name    file name for messages
/// @param models  at least one, with complete bonds
/// @throws Error if they have more than maxAtoms together
Molecule joinModels(const std::string& name, std::vector<Molecule> models, std::size_t maxAtoms);

}  // namespace nacre
