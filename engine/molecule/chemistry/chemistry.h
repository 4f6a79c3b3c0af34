#pragma once
// Bond orders, rings, aromaticity, charges and missing hydrogens: what a molecule's atoms and bonds mean to a chemist.
// docs/interactions.md states each definition with its source.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// A ring of a smallest set of rings (where several such sets are, of all of them). Atoms stand in the order of the
/// ring.
struct Ring {
    std::vector<std::uint32_t> atoms;  ///< indices into Molecule::atoms
    bool aromatic = false;             ///< by Hückel's rule, alone or with the rings fused to it
    bool planar = false;               ///< by its torsions; as aromatic where there are no coordinates in space
};

/// Largest ring that is looked for: beyond it lie macrocycles, which are neither flat nor aromatic as a whole.
constexpr std::size_t kLargestRing = 9;

struct Neighbour {
    std::uint32_t atom = 0;  ///< index into Molecule::atoms
    std::uint32_t bond = 0;  ///< index into Molecule::bonds
};

/// Everything is by the molecule's atoms or bonds as they were when it was made. Positions may change, as they do in
/// a trajectory; atoms and bonds may not.
struct Chemistry {
    std::vector<std::uint8_t> present;   ///< by atom: it belongs to the conformer that was asked for
    std::vector<std::uint32_t> first;    ///< by atom, one more: where its neighbours begin in `neighbours`
    std::vector<Neighbour> neighbours;   ///< present ones, hydrogens among them; bonds to metals are left out
    std::vector<std::uint8_t> order;     ///< by bond: 1, 2 or 3, aromatic rings in one Kekulé structure
    std::vector<std::uint8_t> aromatic;  ///< by bond: in an aromatic ring
    std::vector<std::uint8_t>
        delocalised;                   ///< by bond: of carboxylate, nitro, phosphate, sulphonate, amidine, guanidine
    std::vector<std::uint8_t> hybrid;  ///< by atom: 1 linear, 2 planar, 3 tetrahedral; 0 not an atom with such bonds
    std::vector<std::uint8_t> aromaticAtom;  ///< by atom
    std::vector<std::int8_t> charge;         ///< by atom: formal charge at neutral pH, in the Kekulé structure
    std::vector<std::uint8_t> hydrogens;  ///< by atom: hydrogens at neutral pH, those that are there and those missing
    std::vector<Ring> rings;

    std::span<const Neighbour> of(std::uint32_t atom) const {
        return {neighbours.data() + first[atom], neighbours.data() + first[atom + 1]};
    }
};

/// Orders as the file states them (SDF, MOL2, CML, MMTF, _chem_comp_bond, repeated CONECT records); of standard
/// residues by template; of anything else from geometry. Linear time but for the rings of large cages.
/// @param atoms  of one conformer, ascending, such as drawnAtoms() with water and hydrogens
Chemistry perceiveChemistry(const Molecule& molecule, std::span<const std::uint32_t> atoms);

}  // namespace nacre
