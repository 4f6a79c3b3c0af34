#include <algorithm>

#include "engine/molecule/chemistry/chemistry.h"
#include "engine/molecule/drawn_atoms.h"

namespace nacre {

std::vector<std::uint8_t> perceivedOrders(const ResidueFacts& facts) {
    const Molecule& molecule = facts.molecule();
    const auto wanted = [&](std::uint32_t atom) { return !facts.isPolymer(molecule.atoms[atom].residue); };
    std::vector<std::uint8_t> orders;
    // Atoms bonded to a ligand count for its valences.
    std::vector<bool> looked(molecule.residues.size());
    for (const Bond& bond : molecule.bonds) {
        orders.push_back(bond.order);
        if (!wanted(bond.a) && !wanted(bond.b)) continue;
        looked[molecule.atoms[bond.a].residue] = looked[molecule.atoms[bond.b].residue] = true;
    }
    if (std::find(looked.begin(), looked.end(), true) == looked.end()) return orders;
    std::vector<bool> known(molecule.bonds.size());
    for (std::vector<std::uint32_t>& atoms : conformers(molecule, {.water = false, .hydrogens = true})) {
        std::erase_if(atoms, [&](std::uint32_t atom) { return !looked[molecule.atoms[atom].residue]; });
        const Chemistry chemistry = perceiveChemistry(molecule, atoms);
        for (std::size_t i = 0; i < orders.size(); ++i) {
            const Bond& bond = molecule.bonds[i];
            if (known[i] || !chemistry.present[bond.a] || !chemistry.present[bond.b]) continue;
            if (!wanted(bond.a) && !wanted(bond.b)) continue;
            known[i] = true;
            orders[i] = chemistry.aromatic[i] ? std::uint8_t{4} : chemistry.order[i];
        }
    }
    return orders;
}

}  // namespace nacre
