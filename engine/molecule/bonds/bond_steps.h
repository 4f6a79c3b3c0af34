#pragma once
// The steps of perceiveBonds() and their shared data. Internal to bonds.cpp, template_bonds.cpp, distance_bonds.cpp.

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Consecutive residues at one position (chain, number, insertion code): several for microheterogeneity.
struct PositionGroup {
    std::uint32_t firstResidue = 0;
    std::uint32_t residueCount = 0;
    std::uint32_t firstAtom = 0;
    std::uint32_t atomCount = 0;
};

/// Whether two atoms can exist together: different alternate locations exclude each other.
inline bool coexist(char alternateA, char alternateB) {
    return alternateA == '\0' || alternateB == '\0' || alternateA == alternateB;
}

constexpr float kShortestBond = 0.4f;  ///< Å; closer atoms are duplicates, not neighbours
/// Atoms closer than this fraction of the sum of their covalent radii are not bonded by distance: they are alternatives
/// of one atom. The shortest bonds have 0.76 (N2), or 0.66 with hydrogens and metals (OH, MoO).
constexpr float kShortestShare = 0.7f, kShortestLightShare = 0.6f;
constexpr float kBondTolerance = 0.45f;       ///< Å beyond the sum of the covalent radii
constexpr float kLongestTemplateBond = 2.5f;  ///< Å; templates do not bond across a gap

struct BondWork {
    Molecule& molecule;
    std::vector<PositionGroup> groups;
    std::vector<std::uint32_t> atomGroup;  ///< by atom
    std::vector<std::uint8_t> templated;   ///< by atom: the residue's template has it
    std::vector<std::uint8_t> settled;     ///< by atom: the file states all bonds of its residue
};

/// Adds the bonds of residue templates and links between consecutive residues; marks `templated`.
void addTemplateBonds(BondWork& work);

/// Adds bonds by distance. Needs Molecule::bonds sorted, a < b, no pair twice.
void addDistanceBonds(BondWork& work);

}  // namespace nacre
