#pragma once
// A molecule as bytes, for Python's pickle. Only the same version of Nacre can read them.

#include <string>
#include <string_view>

#include "engine/molecule/molecule.h"

namespace nacre::python {

/// All data of a molecule, including its file's other models.
std::string pickled(const Molecule& molecule);

/// @throws Error for bytes of another version, or invalid ones
Molecule unpickled(std::string_view bytes);

}  // namespace nacre::python
