#include "engine/scene/build/bond_orders.h"

#include <algorithm>

#include "engine/molecule/drawn_atoms.h"

namespace nacre {
namespace {

/// For each residue, whether its orders are perceived: non-polymers drawn as sticks, or any if requested.
std::vector<bool> wantedResidues(const ResidueFacts& facts, const Appearance& appearance, BondOrders mode) {
    const Molecule& molecule = facts.molecule();
    std::vector<bool> wanted(molecule.residues.size());
    for (std::size_t i = 0; i < appearance.atoms.size(); ++i) {
        if (appearance.styles[i] != Style::ballAndStick && appearance.styles[i] != Style::licorice) continue;
        const std::uint32_t residue = molecule.atoms[appearance.atoms[i]].residue;
        if (mode == BondOrders::on || !facts.isPolymer(residue)) wanted[residue] = true;
    }
    return wanted;
}

}  // namespace

DrawnOrders::DrawnOrders(const ResidueFacts& facts, const Appearance& appearance, const RepresentationOptions& options)
    : mode_(options.bondOrders), form_(options.aromatic) {
    const Molecule& molecule = facts.molecule();
    orders_.reserve(molecule.bonds.size());
    for (const Bond& bond : molecule.bonds) orders_.push_back(mode_ == BondOrders::off ? 1 : bond.order);
    perceived_.resize(orders_.size());
    if (mode_ == BondOrders::off) return;
    const std::vector<bool> wanted = wantedResidues(facts, appearance, mode_);
    if (std::find(wanted.begin(), wanted.end(), true) != wanted.end()) perceive(facts, wanted);
}

void DrawnOrders::perceive(const ResidueFacts& facts, const std::vector<bool>& wanted) {
    const Molecule& molecule = facts.molecule();
    // Atoms bonded to a ligand contribute to its valences.
    std::vector<bool> looked = wanted;
    for (const Bond& bond : molecule.bonds) {
        const std::uint32_t a = molecule.atoms[bond.a].residue, b = molecule.atoms[bond.b].residue;
        if (wanted[a]) looked[b] = true;
        if (wanted[b]) looked[a] = true;
    }
    for (std::vector<std::uint32_t>& atoms : conformers(molecule, {.water = false, .hydrogens = true})) {
        std::erase_if(atoms, [&](std::uint32_t atom) { return !looked[molecule.atoms[atom].residue]; });
        take(molecule, perceiveChemistry(molecule, atoms), wanted);
    }
}

void DrawnOrders::take(const Molecule& molecule, const Chemistry& chemistry, const std::vector<bool>& wanted) {
    std::vector<bool> inner(molecule.bonds.size());  // in a ring that is drawn as aromatic
    for (const Ring& ring : chemistry.rings)
        for (std::size_t i = 0; ring.drawnAromatic && i < ring.atoms.size(); ++i)
            for (const Neighbour& n : chemistry.of(ring.atoms[i]))
                if (n.atom == ring.atoms[(i + 1) % ring.atoms.size()]) inner[n.bond] = true;
    for (std::size_t i = 0; i < orders_.size(); ++i) {
        const Bond& bond = molecule.bonds[i];
        if (perceived_[i] || !chemistry.present[bond.a] || !chemistry.present[bond.b]) continue;
        if (!wanted[molecule.atoms[bond.a].residue] && !wanted[molecule.atoms[bond.b].residue]) continue;
        perceived_[i] = true;
        orders_[i] = inner[i] ? 4 : chemistry.delocalised[i] ? kDelocalised : chemistry.order[i];
    }
    for (const Ring& ring : chemistry.rings) {
        const auto better = [&](const DrawnRing& known) {
            return ring.drawnAromatic != known.aromatic ? ring.drawnAromatic : ring.atoms.size() < known.atoms.size();
        };
        for (std::size_t i = 0; i < ring.atoms.size(); ++i) {
            const std::pair<std::uint32_t, std::uint32_t> bond =
                std::minmax(ring.atoms[i], ring.atoms[(i + 1) % ring.atoms.size()]);
            const auto [place, added] = ringOfBond_.emplace(bond, rings_.size());
            if (!added && better(rings_[place->second])) place->second = rings_.size();
        }
        rings_.push_back({ring.atoms, ring.drawnAromatic});
    }
}

std::uint8_t DrawnOrders::drawnOrder(std::size_t bond, Style style) const {
    return style == Style::ballAndStick || perceived_[bond] ? orders_[bond] : 1;
}

std::span<const std::uint32_t> DrawnOrders::findRing(std::uint32_t a, std::uint32_t b) const {
    const auto found = ringOfBond_.find(std::pair(std::min(a, b), std::max(a, b)));
    return found == ringOfBond_.end() ? std::span<const std::uint32_t>() : rings_[found->second].atoms;
}

}  // namespace nacre
