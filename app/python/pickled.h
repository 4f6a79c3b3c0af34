#pragma once
// A molecule as bytes, for Python's pickle: to be read by the very version of Nacre that wrote them.

#include <string>
#include <string_view>

#include "engine/molecule/molecule.h"

namespace nacre::python {

/// Everything that a molecule holds, its file's other models too.
std::string pickled(const Molecule& molecule);

/// @throws Error for bytes of another version, or that are no molecule
Molecule unpickled(std::string_view bytes);

}  // namespace nacre::python
