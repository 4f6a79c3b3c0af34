#pragma once
// One of several INPUTs superposed on another: --fit by sequence, --align by structure.

#include <functional>
#include <string>

#include "app/picture/input_options.h"
#include "engine/molecule/molecule.h"

namespace nacre::app {

/// Moves the INPUTs of a joined molecule as its options say, in order: fits, then alignments.
/// @param tell  is called with each result @throws Error if atoms of a selection are missing or of several INPUTs
void fitInputs(const InputOptions& input, Molecule& molecule, const std::function<void(const std::string&)>& tell);

}  // namespace nacre::app
