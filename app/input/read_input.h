#pragma once
// From a name to a molecule, as far as no network is needed.

#include <cstdint>
#include <functional>
#include <string>

#include "app/picture/input_options.h"
#include "engine/molecule/molecule.h"
#include "engine/volume/read_map.h"

namespace nacre::app {

/// A part of the machine's memory, in bytes. @param parts  how many such parts there are
std::uint64_t memoryShare(unsigned parts);

/// A molecule as it was read, with the hydrogens that it is asked to have. @throws Error if they would not move with a
/// trajectory
Molecule completed(const InputOptions& input, Molecule molecule);

/// Those of a density map: a quarter of the machine's memory.
MapLimits mapLimits();

/// Reads a sample, a file or standard input, whatever else `input.path` looks like.
/// @param bytes     what the molecule may take
/// @param readFile  gives a file's bytes, where a path alone does not open it
/// @param onModel   of all models of a file: called after each with the share that is read, 0..1
/// @throws Error
Molecule readLocally(const InputOptions& input, std::uint64_t bytes,
                     const std::function<std::string(const std::string&)>& readFile = {},
                     const std::function<void(double)>& onModel = {});

}  // namespace nacre::app
