#include "engine/scene/build/atom_groups.h"

namespace nacre {

std::vector<std::uint32_t> atomGroups(const ResidueFacts& facts) {
    const Molecule& molecule = facts.molecule();
    constexpr std::uint32_t kResidues = 1u << kResidueBits, kApart = 8 * kGroupResidues;
    std::vector<std::uint32_t> groups(molecule.atoms.size());
    std::uint32_t chain = 0, inChain = 0, alone = 0;
    for (std::uint32_t i = 0; i < molecule.residues.size(); ++i) {
        const Residue& residue = molecule.residues[i];
        if (residue.chain != chain) {
            chain = residue.chain;
            inChain = alone = 0;
        }
        const std::uint32_t place = facts.isPolymer(i) ? inChain++ : kResidues / 2 + kApart * alone++;
        for (std::uint32_t a = 0; a < residue.atomCount; ++a)
            groups[residue.firstAtom + a] = chain << kResidueBits | place % kResidues;
    }
    return groups;
}

}  // namespace nacre
