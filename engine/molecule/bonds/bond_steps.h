#pragma once
// The steps of perceiveBonds() and what they share. Internal to bonds.cpp, template_bonds.cpp, distance_bonds.cpp.

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Residues in a row at one position (chain, number, insertion code): more than one where the sequence alternates.
struct PositionGroup {
    std::uint32_t firstResidue = 0;
    std::uint32_t residueCount = 0;
    std::uint32_t firstAtom = 0;
    std::uint32_t atomCount = 0;
};

/// Atoms of different alternate locations never stand in the molecule together.
inline bool coexist(char alternateA, char alternateB) {
    return alternateA == '\0' || alternateB == '\0' || alternateA == alternateB;
}

constexpr float kShortestBond = 0.4f;         ///< Å; what is nearer is a copy, not a neighbour
constexpr float kBondTolerance = 0.45f;       ///< Å beyond the sum of the covalent radii
constexpr float kLongestTemplateBond = 2.5f;  ///< Å; a template does not join what a gap tore apart

struct BondWork {
    Molecule& molecule;
    std::vector<PositionGroup> groups;
    std::vector<std::uint32_t> groupOf;   ///< by atom
    std::vector<std::uint8_t> templated;  ///< by atom: its residue's template names it
    std::vector<std::uint8_t> settled;    ///< by atom: the file states all of its residue's bonds, its own among them
};

/// Adds the bonds of residue templates and the links between neighbouring residues; marks `templated`.
void addTemplateBonds(BondWork& work);

/// Adds pairs by distance. Needs Molecule::bonds sorted with a < b and no pair twice.
void addDistanceBonds(BondWork& work);

}  // namespace nacre
