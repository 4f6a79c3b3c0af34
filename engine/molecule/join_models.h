#pragma once
// All models of a file as one molecule.

#include <string>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Atoms, residues and bonds of one model after the other. Chains stay apart, each with its model, so that nothing is
/// bonded or chosen across models; subchains and entities of the same name are joined. Title and assemblies are those
/// of the first model.
/// @param name    file name for messages
/// @param models  at least one; their bonds are complete
/// @throws Error if they have more than maxAtoms together
Molecule joinModels(const std::string& name, std::vector<Molecule> models, std::size_t maxAtoms);

}  // namespace nacre
