// Names of parts that fit into a row, and selections that were meant.

#include <gtest/gtest.h>

#include "app/input/read_input.h"
#include "app/viewer/parts.h"
#include "tests/molecule/build_molecule.h"

namespace nacre::app {
namespace {

/// Chains of one glycine each, by the names that a file gives them.
Molecule makeChains(const std::vector<std::pair<std::string, std::string>>& names) {
    Molecule m;
    for (std::size_t i = 0; i < names.size(); ++i) {
        m.chains.push_back({names[i].first});
        if (!names[i].second.empty()) m.file.chainNames[names[i].first] = names[i].second;
        Residue residue;
        residue.name = std::string_view("GLY");
        residue.number = 25;
        residue.chain = static_cast<std::uint32_t>(i);
        residue.firstAtom = static_cast<std::uint32_t>(m.atoms.size());
        for (const char* name : {"N", "CA", "C", "O"}) {
            Atom atom;
            atom.name = std::string_view(name);
            atom.element = elementFromSymbol(std::string_view(name).substr(0, 1));
            atom.residue = static_cast<std::uint32_t>(m.residues.size());
            m.atoms.push_back(atom);
            ++residue.atomCount;
        }
        m.residues.push_back(residue);
    }
    return m;
}

std::vector<std::string> listLabels(const Molecule& m) {
    std::vector<std::string> labels;
    for (const Part& part : listParts(m)) labels.push_back(part.label);
    return labels;
}

TEST(PartNames, SayWhatTellsChainsApart) {
    EXPECT_EQ(listLabels(makeChains({{"A", "HEMOGLOBIN (DEOXY) (ALPHA CHAIN)"},
                                     {"B", "HEMOGLOBIN (DEOXY) (BETA CHAIN)"},
                                     {"C", "HEMOGLOBIN (DEOXY) (ALPHA CHAIN)"}})),
              (std::vector<std::string>{"A  ALPHA", "B  BETA", "C  ALPHA"}));
    EXPECT_EQ(listLabels(makeChains({{"A", "HIV-1 protease"}, {"B", "HIV-1 protease"}})),
              (std::vector<std::string>{"A  HIV-1 protease", "B  HIV-1 protease"}));
    EXPECT_EQ(listLabels(makeChains({{"A", "Actin"}, {"B", "Actin binding protein"}})),
              (std::vector<std::string>{"A  Actin", "B  Actin binding protein"}))
        << "no name is left without a word";
    EXPECT_EQ(listLabels(makeChains({{"A", ""}, {"B", ""}})), (std::vector<std::string>{"A", "B"}));
}

TEST(PartNames, AreThoseOfEachInputsOwnFile) {
    InputOptions input;
    input.path = "one.pdb";
    input.further = {{"", "two.pdb", ""}};
    const Molecule both = joinInputs(input, {makeChains({{"A", "Actin"}}), makeChains({{"A", "Myosin"}})}, {});
    std::vector<std::string> labels;
    for (const Part& part : listParts(both, both.inputs)) labels.push_back(part.input + ": " + part.label);
    EXPECT_EQ(labels, (std::vector<std::string>{"one: A  Actin", "two: A  Myosin"}));
}

TEST(MeantSelection, IsFoundByNamesNumbersAndLetters) {
    Molecule m = nacre::test::MoleculeText()
                     .residue("ASP", 25)
                     .atom("CA", "C", {})
                     .residue("HEM", 142)
                     .atom("FE", "Fe", {5, 0, 0})
                     .molecule;
    m.file.componentNames["HEM"] = "heme";
    EXPECT_EQ(meantSelection("heme", m), "resn HEM");
    EXPECT_EQ(meantSelection("hem", m), "resn HEM");
    EXPECT_EQ(meantSelection(" Asp25 ", m), "resn ASP and resi 25");
    EXPECT_EQ(meantSelection("asp-25", m), "resn ASP and resi 25");
    EXPECT_EQ(meantSelection("D25", m), "resn ASP and resi 25");
    EXPECT_EQ(meantSelection("25", m), "resi 25");
    EXPECT_EQ(meantSelection("A", m), "chain A");
    for (const char* nothing : {"", "Asp26", "Gly25", "99", "xyz", "Z"})
        EXPECT_EQ(meantSelection(nothing, m), "") << nothing;
}

}  // namespace
}  // namespace nacre::app
