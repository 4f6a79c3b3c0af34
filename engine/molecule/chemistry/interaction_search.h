#pragma once
// Shared by the searches for each kind of interaction. Internal to this folder.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/molecule/chemistry/features.h"
#include "engine/molecule/chemistry/interactions.h"

namespace nacre {

inline double angleBetween(const glm::dvec3& u, const glm::dvec3& v) {
    const double length = std::sqrt(glm::dot(u, u) * glm::dot(v, v));
    return length < 1e-9 ? 0 : std::acos(std::clamp(glm::dot(u, v) / length, -1.0, 1.0)) * 57.29577951308232;
}

/// Input and output of a search.
struct InteractionSearch {
    const Molecule& molecule;
    const Chemistry& chemistry;
    const Features& features;
    InteractionRules rules;
    const InteractionQuery& query;
    const std::vector<bool>& b;  ///< of the query, filled in
    bool plipReceptors = false;  ///< ligands interact only with receptors
    bool modelsApart = false;    ///< several models of one molecule are superposed: they do not interact
    std::vector<Interaction>& found;
    std::uint32_t imageFrom = 0;  ///< atoms from here on are an image's, and meet only earlier ones; 0: no image

    glm::dvec3 at(std::uint32_t atom) const { return molecule.atoms[atom].position; }
    std::uint32_t residue(std::uint32_t atom) const { return molecule.atoms[atom].residue; }
    bool wants(InteractionKind kind) const { return query.kinds[static_cast<std::size_t>(kind)]; }

    /// Whether an interaction may join two atoms.
    bool mayMeet(std::uint32_t first, std::uint32_t second) const {
        return together(first, second) && (imageFrom == 0 || (first < imageFrom) != (second < imageFrom));
    }
    /// Whether two atoms are ever drawn together.
    bool together(std::uint32_t first, std::uint32_t second) const {
        return !modelsApart || findModel(first) == findModel(second);
    }
    int findModel(std::uint32_t atom) const { return molecule.chains[molecule.residues[residue(atom)].chain].model; }

    /// Whether a pair belongs to the query, and in which order: 0 no, 1 the first is a, 2 the second is a.
    int sides(const std::vector<std::uint32_t>& first, const std::vector<std::uint32_t>& second) const;
    int sides(std::uint32_t first, std::uint32_t second) const;

    /// Adds an interaction in the right order. @param donor of `first`: a, of `second`: b
    Interaction& add(InteractionKind kind, InteractionEnd first, InteractionEnd second, DonorSide donor, int sides);

    /// Whether atoms can be partners: not in one residue, and not bonded.
    bool apart(std::uint32_t first, std::uint32_t second) const;
    /// PLIP's rules allow a ligand's contacts with receptors only.
    bool allowed(std::uint32_t first, std::uint32_t second) const;

    /// Centre of atoms; normal of a ring.
    glm::dvec3 middle(const std::vector<std::uint32_t>& atoms) const;
    glm::dvec3 normal(const std::vector<std::uint32_t>& ring) const;
};

void findHydrogenBonds(InteractionSearch& search);
void findHydrogenBondsByHydrogens(InteractionSearch& search);
void findSaltBridges(InteractionSearch& search);
void findRingContacts(InteractionSearch& search);
void findHalogenBonds(InteractionSearch& search);
void findHydrophobic(InteractionSearch& search);
void findMetals(InteractionSearch& search);
void findWaterBridges(InteractionSearch& search);

/// A donor's hydrogens: those of the file, then computed ones. Empty under rules that need none.
struct PlacedHydrogen {
    glm::dvec3 place;
    std::uint32_t atom;  ///< kNoHydrogen: computed
};
constexpr std::uint32_t kNoHydrogen = 0xffffffffu;
std::vector<PlacedHydrogen> placeHydrogens(const InteractionSearch& search, const Donor& donor);

/// Mol*'s limits for a hydrogen bond, degrees: deviation from ideal angles, and from planes of atoms.
struct MolstarLimits {
    double donor = 45, acceptor = 45, donorPlane = 45, acceptorPlane = 90;
    bool hydrogens = true;  ///< a donor's hydrogen, if present, must point at the acceptor
};
/// Whether the angles allow a hydrogen bond by Mol*'s rules; the caller checks the distance.
bool molstarGeometry(const InteractionSearch& search, std::uint32_t donor, std::uint32_t acceptor,
                     const MolstarLimits& limits = {});

/// By partner of a metal: whether PLIP drops it because the best-fitting geometry (linear to octahedral) has no place
/// for it.
std::vector<std::uint8_t> superfluousPartners(const glm::dvec3& metal, const std::vector<glm::dvec3>& partners);

/// Drops interactions that an atom blocks, as Mol* does: an atom whose van der Waals radius reaches their middle.
/// Hydrogens, atoms of both ends, and atoms within 1 Å of an end block nothing.
void dropBlocked(InteractionSearch& search);

/// Keeps one interaction of a kind per pair of atoms (two hydroxyl groups could both donate): the one with the larger
/// angle at the hydrogen.
void keepOnePerPair(std::vector<Interaction>& found);

/// Drops interactions that stronger ones of the same groups include.
void refineMolstar(const InteractionSearch& search);
void refinePlip(const InteractionSearch& search);

}  // namespace nacre
