#include "engine/molecule/counts.h"

#include <glm/common.hpp>

namespace nacre {

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
