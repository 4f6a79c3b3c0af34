#pragma once
// Placing hydrogens that a file omits.

#include <cstdint>
#include <vector>

#include "engine/molecule/chemistry/chemistry.h"

namespace nacre {

/// Parameters that geometry does not determine.
struct HydrogenPlacing {
    float carbon = 1.09f, nitrogen = 1.01f, oxygen = 0.96f, sulphur = 1.34f;  ///< bond lengths, Å
    float flatNitrogen = 1.01f, flatOxygen = 0.96f;                           ///< of planar atoms, Å
    /// A rotatable hydrogen is trans to a neighbour of its atom's only neighbour: the first in the file or, as in Open
    /// Babel, the last bonded one (comesLater()). In acids it is trans to the other oxygen.
    bool asOpenBabel = false;
};

/// Open Babel adds the file's bonds first, in file order, then bonds by distance, in order of z. This order decides its
/// choices: an acid's double bond, or the direction of a hydroxyl.
/// @param l, r  neighbours of one atom
bool comesLater(const Molecule& molecule, const Neighbour& l, const Neighbour& r);

/// Positions of `count` further hydrogens of an atom, with ideal angles: 109.5 degrees at tetrahedral atoms, 120
/// degrees at planar ones. The neighbours determine them, except for rotatable groups with one neighbour.
/// @returns positions, Å
std::vector<glm::vec3> hydrogenPositions(const Molecule& molecule, const Chemistry& chemistry, std::uint32_t atom,
                                         std::size_t count, const HydrogenPlacing& placing = {});

/// The molecule with its missing hydrogens at neutral pH (Chemistry::hydrogens), each after the atoms of its residue,
/// with a bond to its atom. Standard residues get the PDB's names (HA, HB2, HD21, HO2'), others H1, H2, ...
/// Waters get arbitrary orientations. Atom indices change; residues, chains and references to residues stay. Drops
/// partial charges and radii, which hydrogens lack.
Molecule withHydrogens(const Molecule& molecule, const Chemistry& chemistry);
/// As above, with perceiveChemistry() of the drawn conformer. Drops other models, whose atoms would differ.
Molecule withMissingHydrogens(const Molecule& molecule);

}  // namespace nacre
