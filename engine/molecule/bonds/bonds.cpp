#include "engine/molecule/bonds/bonds.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "engine/molecule/bonds/bond_steps.h"
#include "engine/molecule/bonds/coarse_grains.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

std::vector<PositionGroup> findGroups(const Molecule& molecule) {
    std::vector<PositionGroup> groups;
    const Residue* before = nullptr;
    for (std::uint32_t r = 0; r < molecule.residues.size(); ++r) {
        const Residue& residue = molecule.residues[r];
        if (!before || !residue.sharesPosition(*before)) groups.push_back({r, 0, residue.firstAtom, 0});
        ++groups.back().residueCount;
        groups.back().atomCount += residue.atomCount;
        before = &residue;
    }
    return groups;
}

/// A residue is settled if the file bonds nine in ten of its atoms with each other: then the file probably states all
/// bonds, and distances would only add contacts. Links alone (SSBOND, struct_conn) settle nothing. All atoms with a
/// bond are settled if nine in ten of the file's atoms, except waters and ions, have one, and some of these bonds join
/// residues.
void markSettled(BondWork& work) {
    const Molecule& molecule = work.molecule;
    std::vector<std::uint8_t> stated(molecule.atoms.size()), linked(molecule.atoms.size());
    bool links = false;
    for (const Bond& bond : molecule.bonds) {
        linked[bond.a] = linked[bond.b] = 1;
        links = links || work.atomGroup[bond.a] != work.atomGroup[bond.b];
        if (work.atomGroup[bond.a] == work.atomGroup[bond.b]) stated[bond.a] = stated[bond.b] = 1;
    }
    std::size_t joinable = 0, joined = 0;
    for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
        const Atom& atom = molecule.atoms[i];
        const bool alone = work.groups[work.atomGroup[i]].atomCount == 1 && !linked[i];
        if (alone || isHydrogen(atom.element) || isWater(molecule.residues[atom.residue].name)) continue;
        ++joinable;
        joined += linked[i];
    }
    if (links && joined * 10 >= joinable * 9) {
        work.settled = std::move(linked);
        return;
    }
    for (const PositionGroup& group : work.groups) {
        std::size_t heavy = 0;
        std::size_t bonded = 0;
        for (std::uint32_t i = group.firstAtom; i < group.firstAtom + group.atomCount; ++i) {
            if (isHydrogen(molecule.atoms[i].element)) continue;
            ++heavy;
            bonded += stated[i];
        }
        if (bonded == 0 || bonded * 10 < heavy * 9) continue;
        for (std::uint32_t i = group.firstAtom; i < group.firstAtom + group.atomCount; ++i) work.settled[i] = stated[i];
    }
}

}  // namespace

void mergeBonds(std::vector<Bond>& bonds, std::size_t atoms) {
    for (Bond& bond : bonds)
        if (bond.a > bond.b) std::swap(bond.a, bond.b);
    std::erase_if(bonds, [&](const Bond& bond) { return bond.a == bond.b || bond.b >= atoms; });
    const auto inOrder = [](const Bond& l, const Bond& r) { return std::tie(l.a, l.b) < std::tie(r.a, r.b); };
    const auto fault =
        std::adjacent_find(bonds.begin(), bonds.end(), [&](const Bond& l, const Bond& r) { return !inOrder(l, r); });
    if (fault == bonds.end()) return;  // as most readers have them
    // Counting sort by first atom, then short sorts: faster than one sort of all.
    std::vector<std::uint32_t> ends(atoms + 1, 0);
    for (const Bond& bond : bonds) ++ends[bond.a + 1];
    for (std::size_t i = 1; i <= atoms; ++i) ends[i] += ends[i - 1];
    std::vector<Bond> sorted(bonds.size());
    for (const Bond& bond : bonds) sorted[ends[bond.a]++] = bond;  // now the end of each atom's bonds
    const auto key = [](const Bond& bond) { return std::tie(bond.b, bond.source, bond.order); };
    bonds.clear();
    for (std::size_t i = 0, first = 0; i < atoms; first = ends[i++]) {
        const auto begin = sorted.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(ends[i]);
        std::sort(begin, end, [&](const Bond& l, const Bond& r) { return key(l) < key(r); });
        for (auto bond = begin; bond != end; ++bond) {
            if (bond != begin && bonds.back().b == bond->b)
                bonds.back().order = std::max(bonds.back().order, bond->order);
            else
                bonds.push_back(*bond);
        }
    }
}

void perceiveBonds(Molecule& molecule) {
    mergeBonds(molecule.bonds, molecule.atoms.size());
    findCoarseGrains(molecule);
    // A bond table (SDF, chemical component) is complete; its coordinates may even be a flat drawing.
    if (molecule.file.bonds.value_or(0) > 0 || molecule.lacksPositions) return;

    BondWork work{molecule, findGroups(molecule), {}, {}, {}};
    work.atomGroup.resize(molecule.atoms.size());
    work.templated.resize(molecule.atoms.size());
    work.settled.resize(molecule.atoms.size());
    for (std::uint32_t g = 0; g < work.groups.size(); ++g) {
        const PositionGroup& group = work.groups[g];
        std::fill_n(work.atomGroup.begin() + group.firstAtom, group.atomCount, g);
    }
    markSettled(work);
    addTemplateBonds(work);
    mergeBonds(molecule.bonds, molecule.atoms.size());
    addDistanceBonds(work);
    mergeBonds(molecule.bonds, molecule.atoms.size());
}

}  // namespace nacre
