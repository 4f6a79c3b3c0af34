#include "engine/molecule/chain_summary.h"

#include <glm/common.hpp>

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

MoleculeCounts countMolecule(const Molecule& molecule) {
    MoleculeCounts counts;
    counts.atoms = molecule.atoms.size();
    for (const Atom& atom : molecule.atoms) {
        counts.hetatm += atom.hetero;
        counts.altlocAtoms += atom.alternate != '\0';
        if (!counts.bbox) counts.bbox = {atom.position, atom.position};
        auto& [low, high] = *counts.bbox;
        low = glm::min(low, atom.position);
        high = glm::max(high, atom.position);
    }
    for (const Residue& residue : molecule.residues) {
        if (residue.insertionCode != '\0') counts.insertionCodeAtoms += residue.atomCount;
        if (residue.number < 0) counts.negativeResnumAtoms += residue.atomCount;
    }
    for (const Bond& bond : molecule.bonds) {
        counts.bondsFromFile += bond.source == BondSource::file;
        counts.bondsFromTemplates += bond.source == BondSource::residueTemplate;
        counts.bondsByDistance += bond.source == BondSource::distance;
    }
    return counts;
}

}  // namespace nacre
