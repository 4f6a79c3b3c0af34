// Bonds of _chem_comp_bond in a structure file, inside residues without a template.

#include <algorithm>
#include <map>
#include <tuple>

#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/formats/mmcif_model.h"

namespace nacre {

namespace {

struct ComponentBond {
    Name a, b;
    int order = 1;
};
using Components = std::map<std::string, std::vector<ComponentBond>>;  // no hash that a file could aim at

Components readComponents(const MmcifTable& bonds) {
    Components components;
    for (std::size_t row = 0; row < bonds.rows(); ++row) {
        const auto component = bonds.get(row, {"comp_id"}), a = bonds.get(row, {"atom_id_1"}),
                   b = bonds.get(row, {"atom_id_2"});
        if (!component || !a || !b || residueTemplate(Name(*component))) continue;
        components[std::string(*component)].push_back(
            {*a, *b, mmcifBondOrder(bonds.get(row, {"value_order", "type"}))});
    }
    return components;
}

// A hostile file may have many residues and equally many component bonds; real ones are far below this.
constexpr std::size_t kMostComponentSteps = 200'000'000;

/// Atom indices of a residue, sorted by name.
std::vector<std::uint32_t> byName(const Molecule& molecule, const Residue& residue) {
    std::vector<std::uint32_t> atoms(residue.atomCount);
    for (std::uint32_t i = 0; i < residue.atomCount; ++i) atoms[i] = residue.firstAtom + i;
    std::sort(atoms.begin(), atoms.end(), [&](std::uint32_t l, std::uint32_t r) {
        const auto key = [&](std::uint32_t i) { return std::tuple(molecule.atoms[i].name.bytes, i); };
        return key(l) < key(r);
    });
    return atoms;
}

}  // namespace

void addComponentBonds(MoleculeBuilder& builder, const MmcifTable& bonds) {
    const Components components = readComponents(bonds);
    if (components.empty()) return;
    const Molecule& molecule = builder.molecule();
    std::size_t steps = 0;
    for (const Residue& residue : molecule.residues) {
        const auto component = components.find(std::string(residue.name.view()));
        if (component == components.end()) continue;
        const std::vector<std::uint32_t> atoms = byName(molecule, residue);
        const auto named = [&](const Name& name) {
            const auto before = [&](std::uint32_t i, const Name& n) { return molecule.atoms[i].name.bytes < n.bytes; };
            const auto after = [&](const Name& n, std::uint32_t i) { return n.bytes < molecule.atoms[i].name.bytes; };
            return std::pair(std::lower_bound(atoms.begin(), atoms.end(), name, before),
                             std::upper_bound(atoms.begin(), atoms.end(), name, after));
        };
        for (const ComponentBond& bond : component->second) {
            const auto [firstA, lastA] = named(bond.a);
            const auto [firstB, lastB] = named(bond.b);
            for (auto a = firstA; a != lastA; ++a) {
                for (auto b = firstB; b != lastB; ++b) {
                    if (++steps > kMostComponentSteps) break;
                    const char p = molecule.atoms[*a].alternate, q = molecule.atoms[*b].alternate;
                    if (*a != *b && (p == q || p == '\0' || q == '\0')) builder.addBond(*a, *b, bond.order, 0);
                }
            }
            if (++steps > kMostComponentSteps) {
                builder.warn("too many bonds of _chem_comp_bond; the rest is passed over");
                return;
            }
        }
    }
}

}  // namespace nacre
