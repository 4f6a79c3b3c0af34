#include "engine/molecule/bonds/bonds.h"

#include <algorithm>
#include <tuple>

#include "engine/molecule/bonds/bond_steps.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

/// Sorts, drops what is no pair of two different atoms, and joins repeated pairs: what the file stated comes first
/// and keeps its source, while a higher order than 1 is taken from whoever knows it (CONECT mostly knows none).
void sortAndMerge(Molecule& molecule) {
    std::vector<Bond>& bonds = molecule.bonds;
    const auto count = static_cast<std::uint32_t>(molecule.atoms.size());
    for (Bond& bond : bonds)
        if (bond.a > bond.b) std::swap(bond.a, bond.b);
    bonds.erase(std::remove_if(bonds.begin(), bonds.end(),
                               [&](const Bond& bond) { return bond.a == bond.b || bond.b >= count; }),
                bonds.end());
    const auto key = [](const Bond& bond) { return std::tie(bond.a, bond.b, bond.source, bond.order); };
    const auto less = [&](const Bond& l, const Bond& r) { return key(l) < key(r); };
    if (!std::is_sorted(bonds.begin(), bonds.end(), less)) std::sort(bonds.begin(), bonds.end(), less);
    std::size_t kept = 0;
    for (const Bond& bond : bonds) {
        if (kept > 0 && bonds[kept - 1].a == bond.a && bonds[kept - 1].b == bond.b) {
            bonds[kept - 1].order = std::max(bonds[kept - 1].order, bond.order);
        } else {
            bonds[kept++] = bond;
        }
    }
    bonds.resize(kept);
}

std::vector<PositionGroup> findGroups(const Molecule& molecule) {
    std::vector<PositionGroup> groups;
    const Residue* before = nullptr;
    for (std::uint32_t r = 0; r < molecule.residues.size(); ++r) {
        const Residue& residue = molecule.residues[r];
        const bool same = before && before->chain == residue.chain && before->number == residue.number &&
                          before->insertionCode == residue.insertionCode;
        if (!same) groups.push_back({r, 0, residue.firstAtom, 0});
        ++groups.back().residueCount;
        groups.back().atomCount += residue.atomCount;
        before = &residue;
    }
    return groups;
}

/// A residue counts as settled if the file bonds nine in ten of its atoms with each other: then the file means to
/// state them all, and distances would only add contacts. Links alone (SSBOND, struct_conn) settle nothing.
void markSettled(BondWork& work) {
    const Molecule& molecule = work.molecule;
    std::vector<std::uint8_t> stated(molecule.atoms.size());
    for (const Bond& bond : molecule.bonds)
        if (work.groupOf[bond.a] == work.groupOf[bond.b]) stated[bond.a] = stated[bond.b] = 1;
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

void perceiveBonds(Molecule& molecule) {
    sortAndMerge(molecule);
    // A bond table (SDF, chemical component) is the whole truth; its coordinates may even be a flat drawing.
    if (molecule.file.bonds.value_or(0) > 0) return;

    BondWork work{molecule, findGroups(molecule), {}, {}, {}};
    work.groupOf.resize(molecule.atoms.size());
    work.templated.resize(molecule.atoms.size());
    work.settled.resize(molecule.atoms.size());
    for (std::uint32_t g = 0; g < work.groups.size(); ++g) {
        const PositionGroup& group = work.groups[g];
        std::fill_n(work.groupOf.begin() + group.firstAtom, group.atomCount, g);
    }
    markSettled(work);
    addTemplateBonds(work);
    sortAndMerge(molecule);
    addDistanceBonds(work);
    sortAndMerge(molecule);
}

}  // namespace nacre
