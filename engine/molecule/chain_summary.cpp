#include "engine/molecule/chain_summary.h"

namespace nacre {

std::vector<ChainSummary> summariseChains(const ResidueFacts& facts) {
    const Molecule& molecule = facts.molecule();
    std::vector<ChainSummary> chains(molecule.chains.size());
    for (std::size_t i = 0; i < chains.size(); ++i) chains[i].name = molecule.chains[i].name;
    for (std::uint32_t i = 0; i < molecule.residues.size(); ++i) {
        const Residue& residue = molecule.residues[i];
        ChainSummary& chain = chains[residue.chain];
        const std::string name(residue.name.view());
        switch (facts.kinds()[i]) {
            case ResidueKind::protein:
            case ResidueKind::nucleic: {
                if (facts.positions()[i] != i) break;
                const bool protein = facts.kinds()[i] == ResidueKind::protein;
                const char letter = protein ? aminoAcidLetter(residue.name) : nucleotideLetter(residue.name);
                chain.sequence += letter ? letter : 'X';
                ++(protein ? chain.aminoAcids : chain.nucleotides);
                break;
            }
            case ResidueKind::water:
                ++chain.waters;
                break;
            case ResidueKind::ion:
                ++chain.ions[name];
                break;
            case ResidueKind::ligand:
                ++chain.ligands[name];
                break;
        }
    }
    return chains;
}

}  // namespace nacre
