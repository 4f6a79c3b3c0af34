#pragma once
// Bond orders, rings, aromaticity, charges and missing hydrogens of a molecule. docs/interactions.md states each
// definition with its source.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// A ring of a smallest set of smallest rings (if there are several such sets, of all of them). Atoms are in ring
/// order.
struct Ring {
    std::vector<std::uint32_t> atoms;  ///< indices into Molecule::atoms
    bool aromatic = false;             ///< by Hückel's rule, alone or with the rings fused to it
    bool planar = false;               ///< by its torsions; as aromatic without 3D coordinates
    /// Drawn as aromatic: it and all conjugated rings fused to it are aromatic, and no double bond leads out of them.
    /// Others are drawn as their Kekulé structure: haem, fullerenes, caffeine.
    bool drawnAromatic = false;
};

/// Largest ring considered: larger ones are macrocycles, neither flat nor aromatic as a whole.
constexpr std::size_t kLargestRing = 9;

struct Neighbour {
    std::uint32_t atom = 0;  ///< index into Molecule::atoms
    std::uint32_t bond = 0;  ///< index into Molecule::bonds
};

/// Indexed by the molecule's atoms or bonds at construction. Positions may change, as in a trajectory; atoms and bonds
/// may not.
struct Chemistry {
    std::vector<std::uint8_t> present;   ///< by atom: it belongs to the requested conformer
    std::vector<std::uint32_t> first;    ///< by atom, plus one: begin of its neighbours in `neighbours`
    std::vector<Neighbour> neighbours;   ///< present ones, including hydrogens; without bonds to metals
    std::vector<std::uint8_t> order;     ///< by bond: 1, 2 or 3, aromatic rings as one Kekulé structure
    std::vector<std::uint8_t> aromatic;  ///< by bond: in an aromatic ring
    std::vector<std::uint8_t>
        delocalised;                   ///< by bond: of carboxylate, nitro, phosphate, sulphonate, amidine, guanidine
    std::vector<std::uint8_t> hybrid;  ///< by atom: 1 linear, 2 planar, 3 tetrahedral; 0 for others
    std::vector<std::uint8_t> aromaticAtom;  ///< by atom
    std::vector<std::int8_t> charge;         ///< by atom: formal charge at neutral pH, in the Kekulé structure
    std::vector<std::uint8_t> hydrogens;     ///< by atom: hydrogens at neutral pH, existing and missing ones
    std::vector<Ring> rings;

    std::span<const Neighbour> of(std::uint32_t atom) const {
        return {neighbours.data() + first[atom], neighbours.data() + first[atom + 1]};
    }
    /// Sum of the orders of an atom's bonds.
    int orders(std::uint32_t atom) const {
        int sum = 0;
        for (const Neighbour& n : of(atom)) sum += order[n.bond] < 3 ? order[n.bond] : 3;
        return sum;
    }
};

/// Orders come from the file if it states them (SDF, MOL2, CML, MMTF, _chem_comp_bond, repeated CONECT records), from
/// templates for standard residues, else from geometry. Linear time except for the rings of large cages.
/// @param atoms  of one conformer, ascending, such as drawnAtoms() with water and hydrogens
Chemistry perceiveChemistry(const Molecule& molecule, std::span<const std::uint32_t> atoms);

/// Order of each bond, 1 to 3, or 4 in an aromatic ring: perceived for ligands and small molecules, in every conformer;
/// from the molecule for polymers.
std::vector<std::uint8_t> perceivedOrders(const ResidueFacts& facts);

}  // namespace nacre
