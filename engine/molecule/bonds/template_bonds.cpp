// Bonds by residue template, and the links of polymers.

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "engine/molecule/bonds/bond_steps.h"
#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

float distance(const Atom& a, const Atom& b) { return glm::distance(a.position, b.position); }

/// The atoms of one position that have a template's names; several per name if conformers alternate.
class NamedAtoms {
public:
    /// False if a name occurs twice among atoms that exist together: names are then ambiguous.
    bool fill(const Molecule& molecule, const PositionGroup& group, const Name& residueName,
              const ResidueTemplate& residue) {
        for (auto& slot : slots_) slot.clear();
        for (std::uint32_t r = group.firstResidue; r < group.firstResidue + group.residueCount; ++r) {
            const Residue& part = molecule.residues[r];
            if (part.name != residueName) continue;
            for (std::uint32_t i = part.firstAtom; i < part.firstAtom + part.atomCount; ++i) {
                const Name name = currentAtomName(molecule.atoms[i].name);
                const auto found = std::find(residue.atoms.begin(), residue.atoms.end(), name);
                if (found == residue.atoms.end()) continue;
                auto& slot = slots_[static_cast<std::size_t>(found - residue.atoms.begin())];
                for (const std::uint32_t other : slot)
                    if (coexist(molecule.atoms[other].alternate, molecule.atoms[i].alternate)) return false;
                slot.push_back(i);
            }
        }
        return true;
    }

    const std::vector<std::uint32_t>& operator[](std::size_t index) const { return slots_[index]; }

private:
    std::array<std::vector<std::uint32_t>, kMaxTemplateAtoms> slots_;
};

void addInside(BondWork& work, const NamedAtoms& named, const ResidueTemplate& residue) {
    Molecule& molecule = work.molecule;
    for (std::size_t i = 0; i < residue.atoms.size(); ++i)
        for (const std::uint32_t atom : named[i]) work.templated[atom] = 1;
    for (const ResidueTemplate::Bond& bond : residue.bonds) {
        for (const std::uint32_t a : named[bond.a]) {
            for (const std::uint32_t b : named[bond.b]) {
                if (!coexist(molecule.atoms[a].alternate, molecule.atoms[b].alternate)) continue;
                const float length = distance(molecule.atoms[a], molecule.atoms[b]);
                if (length <= kShortestBond || length >= kLongestTemplateBond) continue;
                molecule.bonds.push_back({a, b, bond.order, BondSource::residueTemplate});
            }
        }
    }
}

/// Joins one named atom of a position with one of the next, for every pair of compatible conformers.
void addLink(Molecule& molecule, const PositionGroup& first, const Name& nameA, const PositionGroup& second,
             const Name& nameB) {
    for (std::uint32_t a = first.firstAtom; a < first.firstAtom + first.atomCount; ++a) {
        const Atom& atomA = molecule.atoms[a];
        if (currentAtomName(atomA.name) != nameA) continue;
        for (std::uint32_t b = second.firstAtom; b < second.firstAtom + second.atomCount; ++b) {
            const Atom& atomB = molecule.atoms[b];
            if (atomB.name != nameB || !coexist(atomA.alternate, atomB.alternate)) continue;
            const float longest = covalentRadius(atomA.element) + covalentRadius(atomB.element) + kBondTolerance;
            const float length = distance(atomA, atomB);
            if (length > kShortestBond && length < longest)
                molecule.bonds.push_back({a, b, 1, BondSource::residueTemplate});
        }
    }
}

/// Positions with more atoms than any residue (all of a file in one "residue") are no residues; their many repeated
/// names would make the search for links quadratic.
constexpr std::uint32_t kLargestResidue = 400;

}  // namespace

void addTemplateBonds(BondWork& work) {
    Molecule& molecule = work.molecule;
    NamedAtoms named;
    for (std::size_t g = 0; g < work.groups.size(); ++g) {
        const PositionGroup& group = work.groups[g];
        if (group.atomCount > kLargestResidue) continue;
        for (std::uint32_t r = group.firstResidue; r < group.firstResidue + group.residueCount; ++r) {
            const Name& name = molecule.residues[r].name;
            const auto sameName = [&](const Residue& earlier) { return earlier.name == name; };
            const auto begin = molecule.residues.begin() + group.firstResidue;
            if (std::any_of(begin, molecule.residues.begin() + r, sameName)) continue;  // done with its first part
            const ResidueTemplate* residue = bondTemplate(name);
            if (residue && named.fill(molecule, group, name, *residue)) addInside(work, named, *residue);
        }
        if (g + 1 == work.groups.size()) continue;
        const PositionGroup& next = work.groups[g + 1];
        if (next.atomCount > kLargestResidue) continue;
        if (molecule.residues[group.firstResidue].chain != molecule.residues[next.firstResidue].chain) continue;
        addLink(molecule, group, Name("C"), next, Name("N"));
        addLink(molecule, group, Name("O3'"), next, Name("P"));
    }
}

}  // namespace nacre
