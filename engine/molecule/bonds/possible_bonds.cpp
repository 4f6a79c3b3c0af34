#include "engine/molecule/bonds/possible_bonds.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "engine/molecule/bonds/bond_steps.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

constexpr float kLongest = 1.5f;       // Å beyond the sum of the covalent radii; more than for any coordination
constexpr float kFarthestGrain = 12;   // Å
constexpr std::uint32_t kInFile = 40;  // an atom's neighbours are within this many lines of it

float apart(const Molecule& molecule, std::uint32_t a, std::uint32_t b) {
    return glm::distance(molecule.atoms[a].position, molecule.atoms[b].position);
}

float sumOfRadii(const Molecule& molecule, std::uint32_t a, std::uint32_t b) {
    return covalentRadius(molecule.atoms[a].element) + covalentRadius(molecule.atoms[b].element);
}

/// Whether another atom is as near as in molecules; alternatives of the atom may be nearer.
bool hasNeighbour(const Molecule& molecule, std::uint32_t atom) {
    const auto count = static_cast<std::uint32_t>(molecule.atoms.size());
    const std::uint32_t begin = atom - std::min(atom, kInFile), end = std::min(count - atom, kInFile) + atom;
    for (std::uint32_t i = begin; i < end; ++i) {
        const float length = apart(molecule, i, atom);
        const bool both = coexist(molecule.atoms[i].alternate, molecule.atoms[atom].alternate);
        if (both && length > kShortestBond && length < sumOfRadii(molecule, i, atom) + kBondTolerance) return true;
    }
    return false;
}

}  // namespace

bool mayBeBonded(const Molecule& molecule, std::uint32_t a, std::uint32_t b, float farthest) {
    const float length = apart(molecule, a, b);
    if (length <= sumOfRadii(molecule, a, b) + kLongest) return true;
    const auto isGrain = [&](std::uint32_t atom) {
        return !isWater(molecule.residues[molecule.atoms[atom].residue].name) && !hasNeighbour(molecule, atom);
    };
    return length <= std::max(kFarthestGrain, farthest) && isGrain(a) && isGrain(b);
}

}  // namespace nacre
