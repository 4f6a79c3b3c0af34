#pragma once
// Atoms and groups that take part in interactions. They depend on chemistry, not on positions: one set serves all
// frames of a trajectory. Internal to this folder.

#include <cstdint>
#include <vector>

#include "engine/molecule/chemistry/chemistry.h"
#include "engine/molecule/residue_kind.h"

namespace nacre {

/// Maximum number of atoms per amino acid: more indicate a file without residues.
constexpr std::uint32_t kLargestAminoAcid = 100;

struct Donor {
    std::uint32_t atom = 0;
    std::uint8_t hydrogens = 0;  ///< missing in the file; their positions are computed
};

struct ChargedGroup {
    std::vector<std::uint32_t> atoms;   ///< atoms with the charge
    std::vector<std::uint32_t> centre;  ///< atoms whose mean is the centre
    bool positive = false;
    bool tertiaryAmine = false;
};

/// A halogen and its carbon, or a halogen bond's acceptor and the first atom that it is bonded to.
struct HalogenEnd {
    std::uint32_t atom = 0, base = 0;
    std::size_t bases = 1;
};

struct Features {
    std::vector<Donor> donors;
    std::vector<std::uint32_t> acceptors;
    std::vector<std::uint32_t> hydrophobic;
    std::vector<ChargedGroup> charged;
    std::vector<std::uint32_t> rings;  ///< indices into Chemistry::rings
    std::vector<HalogenEnd> halogens, halogenAcceptors;
    std::vector<std::uint32_t> metals, metalBinders;
    std::vector<std::uint32_t> waters;      ///< oxygens
    std::vector<std::uint8_t> waterOxygen;  ///< by atom
    std::vector<std::uint32_t> unit;        ///< by residue: the first residue of the same ligand; PLIP's definition
    std::vector<std::uint8_t> receptor;     ///< by residue: an amino acid that is not HETATM
};

Features molstarFeatures(const Molecule& molecule, const Chemistry& chemistry);
Features plipFeatures(const Molecule& molecule, const Chemistry& chemistry);

/// Shared features: waters, kinds of residues, metals, hydrophobic carbons, ends of halogen bonds.
Features sharedFeatures(const Molecule& molecule, const Chemistry& chemistry);

/// A box along the axes, Å.
struct AtomBox {
    glm::vec3 low{1e30f}, high{-1e30f};

    void add(const glm::vec3& p);
    /// Keeps the intersection of both boxes.
    void cut(const AtomBox& other);
    AtomBox grown(float by) const { return {low - by, high + by}; }
    bool holds(const glm::vec3& p) const {
        return p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y && p.z <= high.z;
    }
};
AtomBox boundingBox(const Molecule& molecule, const std::vector<bool>& atoms);

/// The features in a box, with groups by their first atoms: all that a search there needs.
Features featuresAround(const Features& features, const Molecule& molecule, const Chemistry& chemistry,
                        const AtomBox& box);

/// Heavy neighbours of an atom.
std::vector<std::uint32_t> heavyNeighbours(const Molecule& molecule, const Chemistry& chemistry, std::uint32_t atom);

/// Whether an atom belongs to a side chain: of an amino acid, but not N, CA, C, O, OXT or their hydrogens.
bool isSideChain(const Molecule& molecule, std::uint32_t atom);

/// Metals that nitrogen coordinates, in Mol*'s list: groups 4 to 12 without mercury, and yttrium.
bool isTransitionMetal(Element element);

/// Atoms of an element in a residue that is no larger than an amino acid.
std::vector<std::uint32_t> sideChainAtoms(const Molecule& molecule, const Chemistry& chemistry, std::uint32_t residue,
                                          Element element);

}  // namespace nacre
