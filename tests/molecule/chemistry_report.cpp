// What a file's chemistry is taken to be, as JSON, for the judges beside_rdkit.py:
//   chemistry_report FILE [--model N] [--forget-orders] [--add-hydrogens]
// atoms [{element, residue, number, chain, name, position, hydrogens, charge, hybrid, ring}] and bonds [[a, b, order,
// aromatic, delocalised]] (0-based). --forget-orders leaves nothing but which atoms are bonded, so that orders come
// from geometry.

#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/molecule/chemistry/chemistry.h"
#include "engine/molecule/chemistry/hydrogens.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"
#include "engine/molecule/read.h"
#include "engine/molecule/residue_kind.h"

namespace nacre {
namespace {

nlohmann::json report(const Molecule& molecule, const Chemistry& chemistry) {
    const std::vector<ResidueKind> kinds = residueKinds(molecule);
    nlohmann::json atoms = nlohmann::json::array(), bonds = nlohmann::json::array();
    for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i) {
        const Atom& atom = molecule.atoms[i];
        const Residue& residue = molecule.residues[atom.residue];
        atoms.push_back({{"element", elementSymbol(atom.element)},
                         {"residue", residue.name.view()},
                         {"number", residue.number},
                         {"chain", molecule.chains[residue.chain].name},
                         {"name", atom.name.view()},
                         {"kind", static_cast<int>(kinds[atom.residue])},
                         {"present", chemistry.present[i] != 0},
                         {"position", {atom.position.x, atom.position.y, atom.position.z}},
                         {"hydrogens", chemistry.hydrogens[i]},
                         {"charge", chemistry.charge[i]},
                         {"hybrid", chemistry.hybrid[i]}});
    }
    for (std::uint32_t b = 0; b < molecule.bonds.size(); ++b)
        bonds.push_back({molecule.bonds[b].a, molecule.bonds[b].b, chemistry.order[b], chemistry.aromatic[b],
                         chemistry.delocalised[b]});
    return {{"atoms", atoms}, {"bonds", bonds}};
}

int run(int argc, char** argv) {
    ReadOptions options;
    bool forget = false, add = false;
    for (int i = 2; i < argc; ++i) {
        if (std::strcmp(argv[i], "--model") == 0 && i + 1 < argc) options.model = std::stoi(argv[++i]);
        forget = forget || std::strcmp(argv[i], "--forget-orders") == 0;
        add = add || std::strcmp(argv[i], "--add-hydrogens") == 0;
    }
    Molecule molecule = readMoleculeFile(argv[1], options);
    if (forget) {
        molecule.file.format = "xyz";
        for (Bond& bond : molecule.bonds) {
            bond.order = 1;
            bond.source = BondSource::distance;
        }
        for (Atom& atom : molecule.atoms) atom.charge = 0;
    }
    const auto makeChemistry = [](const Molecule& of) {
        return perceiveChemistry(of, drawnAtoms(of, {.water = true, .hydrogens = true}));
    };
    Chemistry chemistry = makeChemistry(molecule);
    if (add) {
        molecule = withHydrogens(molecule, chemistry);
        chemistry = makeChemistry(molecule);
    }
    std::puts(report(molecule, chemistry).dump().c_str());
    return 0;
}

}  // namespace
}  // namespace nacre

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    try {
        return nacre::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
