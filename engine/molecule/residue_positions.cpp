#include "engine/molecule/residue_positions.h"

namespace nacre {

std::vector<std::uint32_t> residuePositions(const Molecule& molecule) {
    std::vector<std::uint32_t> first(molecule.residues.size());
    for (std::uint32_t i = 0; i < first.size(); ++i) {
        first[i] = i;
        if (i == 0) continue;
        const Residue &a = molecule.residues[i - 1], &b = molecule.residues[i];
        if (a.chain == b.chain && a.number == b.number && a.insertionCode == b.insertionCode) first[i] = first[i - 1];
    }
    return first;
}

}  // namespace nacre
