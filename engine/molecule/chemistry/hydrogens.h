#pragma once
// Hydrogens that a file leaves out.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/molecule/chemistry/chemistry.h"

namespace nacre {

/// How to place what geometry leaves free.
struct HydrogenPlacing {
    float carbon = 1.09f, nitrogen = 1.01f, oxygen = 0.96f, sulphur = 1.34f;  ///< bond lengths, Å
    float flatNitrogen = 1.01f, flatOxygen = 0.96f;                           ///< of planar atoms, Å
    /// A hydrogen that could turn stands trans to a neighbour of its atom's one neighbour: the first in the file, or,
    /// as Open Babel has it, the last that was bonded (comesLater()), but for acids: trans to the other oxygen.
    bool asOpenBabel = false;
};

/// Open Babel bonds what a file states first, in the file's order, then what distances tell, in the order of z. Where
/// it has a choice, of an acid's double bond or of what a hydroxyl turns away from, this order decides.
/// @param l, r  neighbours of one atom
bool comesLater(const Molecule& molecule, const Neighbour& l, const Neighbour& r);

/// Directions from an atom in which `count` further hydrogens go, ideal angles: 109.5 degrees about tetrahedral atoms,
/// 120 degrees about planar ones. Determined by the neighbours but for atoms of one neighbour that may turn.
/// @returns positions, Å
std::vector<glm::vec3> hydrogenPositions(const Molecule& molecule, const Chemistry& chemistry, std::uint32_t atom,
                                         std::size_t count, const HydrogenPlacing& placing = {});

/// The molecule with the hydrogens that it lacks at neutral pH (Chemistry::hydrogens), each after the atoms of its
/// residue, with a bond to its atom. Those of standard residues have the PDB's names (HA, HB2, HD21, HO2'), others H1,
/// H2, ... Nothing determines where those of water point. Every index of an atom moves; residues, chains and what else
/// refers to residues stay. Partial charges and radii, which hydrogens lack, are dropped.
Molecule withHydrogens(const Molecule& molecule, const Chemistry& chemistry);
/// The same with the chemistry that perceiveChemistry() finds of the drawn conformer. Other models are left out, as
/// they have other atoms then.
Molecule withMissingHydrogens(const Molecule& molecule);

}  // namespace nacre
