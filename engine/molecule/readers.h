#pragma once
// One reader per format, behind readMolecule() of read.h. Each takes inflated text, leaves bonds at what the file
// states, and throws Error (what, file name, line, why). Must also compile as C++17.

#include <string>
#include <string_view>

#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre {

Molecule readPdb(const std::string& name, std::string_view text, const ReadOptions& options);

}  // namespace nacre
