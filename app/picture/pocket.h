#pragma once
// The picture of a ligand in its pocket: sets several options at once.

#include <string_view>

#include "app/picture/description.h"

namespace nacre::app {

constexpr double kPocketReach = 4;  ///< Å: residues with an atom this close form the pocket

/// The ligand and the residues around it as sticks, their interactions, labels of the residues, a faint cartoon, and
/// the camera on the side that shows most of the ligand. Existing rules and labels come after these.
/// @throws Error as parseSelection()
void applyPocket(std::string_view ligand, PictureDescription& d);

}  // namespace nacre::app
