// Orders of ligands' bonds by geometry beside those of the chemical component dictionary.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "engine/molecule/chemistry/chemistry.h"
#include "engine/molecule/read.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

struct Component {
    std::string file, name, chain;
    int number = 0;
    std::vector<std::string> bonds;
};

std::vector<Component> components() {
    std::ifstream in(NACRE_SOURCE_DIR "/tests/molecule/component_orders.txt");
    std::vector<Component> list;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        Component& component = list.emplace_back();
        words >> component.file >> component.name >> component.chain >> component.number;
        for (std::string bond; words >> bond;) component.bonds.push_back(bond);
    }
    return list;
}

/// "C1=O2" of a residue's bonds.
std::string orderOf(const Molecule& molecule, const std::vector<std::uint8_t>& orders, const Component& component,
                    const std::string& first, const std::string& second) {
    for (std::size_t i = 0; i < orders.size(); ++i) {
        const Atom &a = molecule.atoms[molecule.bonds[i].a], &b = molecule.atoms[molecule.bonds[i].b];
        const Residue& residue = molecule.residues[a.residue];
        const std::string& chain = molecule.chains[residue.chain].name;
        if (a.residue != b.residue || residue.name != Name(component.name) || residue.number != component.number ||
            (chain.empty() ? "_" : chain) != component.chain)
            continue;
        const std::string_view one = a.name.view(), two = b.name.view();
        if ((one == first && two == second) || (one == second && two == first))
            return first + "-=#:"[orders[i] - 1] + second;
    }
    return "no bond";
}

TEST(BondOrders, OfCrystalsLigandsAreThoseOfTheComponentDictionary) {
    NACRE_NEEDS_DATA();
    std::size_t count = 0, right = 0;
    std::string file;
    Molecule molecule;
    std::vector<std::uint8_t> orders;
    for (const Component& component : components()) {
        if (component.file != file) {
            file = component.file;
            molecule = readMoleculeFile(test::dataFile(file));
            orders = perceivedOrders(molecule);
        }
        for (const std::string& bond : component.bonds) {
            const std::size_t mark = bond.find_first_of("-=#:");
            const std::string found = orderOf(molecule, orders, component, bond.substr(0, mark), bond.substr(mark + 1));
            ++count;
            right += found == bond;
            if (found != bond)
                std::printf("%s %s: %s, not %s\n", file.c_str(), component.name.c_str(), found.c_str(), bond.c_str());
        }
    }
    EXPECT_EQ(count, 458u);
    // The junction of a flavin's rings is aromatic by this rule alone.
    EXPECT_LE(count - right, 1u);
}

}  // namespace
}  // namespace nacre
