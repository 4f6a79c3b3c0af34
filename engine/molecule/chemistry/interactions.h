#pragma once
// Non-covalent interactions: hydrogen bonds, salt bridges, stacked rings and the like, by three published sets of
// rules. docs/interactions.md states each definition with its source.

#include <array>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

enum class InteractionKind : std::uint8_t {
    hydrogenBond,
    saltBridge,
    piStacking,
    cationPi,
    halogenBond,
    hydrophobic,
    metal,
    waterBridge
};
constexpr std::size_t kInteractionKinds = 8;
/// "hydrogen-bond", "salt-bridge", "pi-stacking", "cation-pi", "halogen-bond", "hydrophobic", "metal", "water-bridge".
std::string_view interactionKindName(InteractionKind kind);
std::optional<InteractionKind> interactionKindFromName(std::string_view name);

enum class InteractionRules : std::uint8_t {
    molstar,       ///< Mol*: no hydrogens needed
    plip,          ///< Protein-Ligand Interaction Profiler 2.4
    bakerHubbard,  ///< hydrogen bonds of Baker and Hubbard (1984) by the hydrogens of the file; the rest as molstar
    wernetNilsson  ///< hydrogen bonds of Wernet, Nilsson et al. (2004), the rest likewise
};
/// "molstar", "plip", "baker-hubbard", "wernet-nilsson".
std::string_view interactionRulesName(InteractionRules rules);
std::optional<InteractionRules> interactionRulesFromName(std::string_view name);

/// One side of an interaction. The first atom names its residue.
struct InteractionEnd {
    std::vector<std::uint32_t> atoms;  ///< indices into Molecule::atoms: an atom and its hydrogen if the file has it,
                                       ///< the atoms of a charged group, or those of a ring
    glm::vec3 place{};                 ///< where a dash ends, Å: the atom, or the middle of the group
    bool ring = false;                 ///< atoms of an aromatic ring, in its order
    bool image = false;                ///< it belongs to the image of findBetween()
};

/// An angle that a rule tests, in degrees.
struct InteractionAngle {
    const char* name;  ///< "donor", "acceptor", "planes", "water"
    double degrees;
};

enum class DonorSide : std::uint8_t { none, a, b };

struct Interaction {
    InteractionKind kind = InteractionKind::hydrogenBond;
    InteractionEnd a, b;                ///< a in the selection, b its partner
    double distance = 0;                ///< Å, between the places; for a water bridge the longer of the two
    DonorSide donor = DonorSide::none;  ///< for hydrogen bonds, halogen bonds and water bridges
    std::vector<InteractionAngle> angles;
    double offset = -1;                 ///< Å, between ring centres; -1 where not applicable
    std::vector<std::uint32_t> waters;  ///< oxygens of a water bridge
    bool waterImage = false;            ///< they belong to the image of findBetween()
};

/// The atoms between which to search. Values by atom.
struct InteractionQuery {
    std::vector<bool> a;
    std::vector<bool> b;  ///< empty: all atoms outside a, or all if a is all
    std::array<bool, kInteractionKinds> kinds{true, true, true, true, true, true, true, true};
};

/// More are an error: the atoms are not a real molecule.
constexpr std::size_t kMostInteractions = 5'000'000;

/// Finds the interactions of a molecule. Computes everything independent of positions once: chemistry, donors,
/// acceptors, charges and rings. Call it per frame of a trajectory.
class InteractionFinder {
public:
    InteractionFinder(const Molecule& molecule, InteractionRules rules);
    ~InteractionFinder();
    InteractionFinder(InteractionFinder&&) noexcept;
    InteractionFinder& operator=(InteractionFinder&&) noexcept;

    /// Interactions by kind, then by the atoms of a and b. Linear time by a grid of cells.
    /// @param molecule  the same molecule with any positions
    /// @throws Error if there are more than kMostInteractions
    std::vector<Interaction> find(const Molecule& molecule, const InteractionQuery& query) const;

    /// Interactions between a molecule and an image of it, such as the next copy of an assembly; none within either.
    /// The selected side may be in either.
    /// @param image  p -> image * vec4(p, 1), rigid
    std::vector<Interaction> findBetween(const Molecule& molecule, const glm::dmat4x3& image,
                                         const InteractionQuery& query) const;

private:
    struct Kept;
    std::unique_ptr<Kept> kept_;
};

}  // namespace nacre
