#include "engine/molecule/chemistry/chemistry.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "engine/molecule/chemistry/steps.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

/// Formats that state bond orders. PDB files do only if they repeat CONECT records.
bool statesOrders(const std::string& format) {
    constexpr std::array<std::string_view, 6> kFormats = {"sdf-v2000", "sdf-v3000", "mol2", "cml", "mmtf", "sample"};
    const std::string_view component = "-chem_comp";
    return std::find(kFormats.begin(), kFormats.end(), format) != kFormats.end() ||
           (format.size() > component.size() && format.ends_with(component));
}

/// mmCIF in its three syntaxes: bonds inside a residue are in _chem_comp_bond, those between residues in _struct_conn.
bool statesInsideResidues(const std::string& format) {
    return format == "mmcif" || format == "bcif" || format == "mmjson";
}

std::vector<OrderSource> orderSources(const Molecule& molecule) {
    const bool all = statesOrders(molecule.file.format), inside = statesInsideResidues(molecule.file.format);
    std::vector<std::uint8_t> repeats(molecule.residues.size());
    for (const Bond& bond : molecule.bonds)
        if (bond.source == BondSource::file && bond.order > 1) repeats[molecule.atoms[bond.a].residue] = 1;
    std::vector<OrderSource> sources;
    sources.reserve(molecule.bonds.size());
    for (const Bond& bond : molecule.bonds) {
        const std::uint32_t a = molecule.atoms[bond.a].residue, b = molecule.atoms[bond.b].residue;
        OrderSource source = OrderSource::unknown;
        if (bond.source == BondSource::residueTemplate) source = OrderSource::residueTemplate;
        if (bond.source == BondSource::file && (all || (a == b && (inside || repeats[a]))))
            source = OrderSource::stated;
        sources.push_back(source);
    }
    return sources;
}

/// Neighbours of present atoms. Excludes coordination to metals, and bonds of atoms with impossibly many neighbours in
/// the file.
void linkNeighbours(const Molecule& molecule, Chemistry& chemistry) {
    constexpr std::uint32_t kMostNeighbours = 24;
    std::vector<std::uint32_t> degree(molecule.atoms.size());
    for (const Bond& bond : molecule.bonds) {
        if (!chemistry.present[bond.a] || !chemistry.present[bond.b]) continue;
        ++degree[bond.a];
        ++degree[bond.b];
    }
    const auto able = [&](std::uint32_t atom) {
        return chemistry.present[atom] && degree[atom] <= kMostNeighbours && !isMetal(molecule.atoms[atom].element);
    };
    const auto counts = [&](const Bond& bond) { return able(bond.a) && able(bond.b); };
    chemistry.first.assign(molecule.atoms.size() + 1, 0);
    for (const Bond& bond : molecule.bonds) {
        if (!counts(bond)) continue;
        ++chemistry.first[bond.a + 1];
        ++chemistry.first[bond.b + 1];
    }
    for (std::size_t i = 1; i < chemistry.first.size(); ++i) chemistry.first[i] += chemistry.first[i - 1];
    chemistry.neighbours.resize(chemistry.first.back());
    std::vector<std::uint32_t> next(chemistry.first.begin(), chemistry.first.end() - 1);
    for (std::uint32_t b = 0; b < molecule.bonds.size(); ++b) {
        const Bond& bond = molecule.bonds[b];
        if (!counts(bond)) continue;
        chemistry.neighbours[next[bond.a]++] = {bond.b, b};
        chemistry.neighbours[next[bond.b]++] = {bond.a, b};
    }
}

}  // namespace

Chemistry perceiveChemistry(const Molecule& molecule, std::span<const std::uint32_t> atoms) {
    Chemistry chemistry;
    chemistry.present.assign(molecule.atoms.size(), 0);
    for (const std::uint32_t atom : atoms) chemistry.present[atom] = 1;
    linkNeighbours(molecule, chemistry);
    chemistry.order.reserve(molecule.bonds.size());
    for (const Bond& bond : molecule.bonds) chemistry.order.push_back(bond.order);
    chemistry.aromatic.assign(molecule.bonds.size(), 0);
    chemistry.delocalised.assign(molecule.bonds.size(), 0);
    chemistry.aromaticAtom.assign(molecule.atoms.size(), 0);
    ChemistryWork work{molecule, chemistry, orderSources(molecule), {}, {}, {}, {}};
    findRings(work);
    kekulise(work);
    perceiveOrders(work);
    findAromatic(work);
    findStates(work);
    chooseDrawnRings(work);
    return chemistry;
}

}  // namespace nacre
