#include <algorithm>

#include "engine/molecule/chemistry/chemistry.h"
#include "engine/molecule/chemistry/drawn_orders.h"
#include "engine/molecule/drawn_atoms.h"

namespace nacre {

namespace {

/// By bond, whether it is in a ring that is drawn as aromatic.
std::vector<std::uint8_t> drawnAromaticBonds(const Molecule& molecule, const Chemistry& chemistry) {
    std::vector<std::uint8_t> bonds(molecule.bonds.size());
    for (const Ring& ring : chemistry.rings)
        for (std::size_t i = 0; ring.drawnAromatic && i < ring.atoms.size(); ++i)
            for (const Neighbour& n : chemistry.of(ring.atoms[i]))
                if (n.atom == ring.atoms[(i + 1) % ring.atoms.size()]) bonds[n.bond] = 1;
    return bonds;
}

/// @param listAromatic  by bond, of the chemistry of a conformer
template <typename ListAromatic>
std::vector<std::uint8_t> findOrders(const ResidueFacts& facts, const ListAromatic& listAromatic) {
    const Molecule& molecule = facts.molecule();
    const auto wanted = [&](std::uint32_t atom) { return !facts.isPolymer(molecule.atoms[atom].residue); };
    std::vector<std::uint8_t> orders;
    // Atoms bonded to a ligand contribute to its valences.
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
        const std::vector<std::uint8_t> aromatic = listAromatic(chemistry);
        for (std::size_t i = 0; i < orders.size(); ++i) {
            const Bond& bond = molecule.bonds[i];
            if (known[i] || !chemistry.present[bond.a] || !chemistry.present[bond.b]) continue;
            if (!wanted(bond.a) && !wanted(bond.b)) continue;
            known[i] = true;
            orders[i] = aromatic[i] ? std::uint8_t{4} : chemistry.order[i];
        }
    }
    return orders;
}

}  // namespace

std::vector<std::uint8_t> perceivedOrders(const ResidueFacts& facts) {
    return findOrders(facts, [](const Chemistry& chemistry) { return chemistry.aromatic; });
}

std::vector<std::uint8_t> drawnOrders(const ResidueFacts& facts) {
    return findOrders(facts,
                      [&](const Chemistry& chemistry) { return drawnAromaticBonds(facts.molecule(), chemistry); });
}

}  // namespace nacre
