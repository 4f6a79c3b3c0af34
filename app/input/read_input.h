#pragma once
// From an input's name to a molecule, without network access.

#include <cstdint>
#include <functional>
#include <string>

#include "app/picture/input_options.h"
#include "engine/molecule/molecule.h"
#include "engine/volume/read_map.h"

namespace nacre::app {

/// A share of the machine's memory, in bytes. @param parts  the whole divided by this number
std::uint64_t memoryShare(unsigned parts);

/// A molecule as read, with hydrogens added if requested. @throws Error if they would not move with a trajectory
Molecule completed(const InputOptions& input, Molecule molecule);

/// Limits for a density map: a quarter of the machine's memory.
MapLimits mapLimits();

/// Reads a sample, a file or standard input; treats `input.path` as nothing else.
/// @param bytes     memory limit for the molecule
/// @param readFile  returns a file's bytes, if a path alone does not open it
/// @param onModel   for all models of a file: called after each with the share read, 0..1
/// @throws Error
Molecule readLocally(const InputOptions& input, std::uint64_t bytes,
                     const std::function<std::string(const std::string&)>& readFile = {},
                     const std::function<void(double)>& onModel = {});

}  // namespace nacre::app
