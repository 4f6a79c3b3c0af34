#include "engine/scene/atom_groups.h"

#include "engine/molecule/residue_kind.h"

namespace nacre {

std::vector<std::uint32_t> atomGroups(const Molecule& molecule) {
    constexpr std::uint32_t kResidues = 1u << kResidueBits, kApart = 8 * kGroupResidues;
    const std::vector<ResidueKind> kinds = residueKinds(molecule);
    std::vector<std::uint32_t> groups(molecule.atoms.size());
    std::uint32_t chain = 0, inChain = 0, alone = 0;
    for (std::size_t i = 0; i < molecule.residues.size(); ++i) {
        const Residue& residue = molecule.residues[i];
        if (residue.chain != chain) {
            chain = residue.chain;
            inChain = alone = 0;
        }
        const bool polymer = kinds[i] == ResidueKind::protein || kinds[i] == ResidueKind::nucleic;
        const std::uint32_t place = polymer ? inChain++ : kResidues / 2 + kApart * alone++;
        for (std::uint32_t a = 0; a < residue.atomCount; ++a)
            groups[residue.firstAtom + a] = chain << kResidueBits | place % kResidues;
    }
    return groups;
}

}  // namespace nacre
