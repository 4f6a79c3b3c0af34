#include "engine/molecule/kabsch_sander.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <tuple>

#include "engine/molecule/read.h"
#include "tests/molecule/build_molecule.h"
#include "tests/molecule/build_peptide.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using test::chainOf;

std::string fold(const std::vector<SecondaryStructure>& kinds) {
    std::string text;
    for (const SecondaryStructure kind : kinds) text += "-HE"[static_cast<int>(kind)];
    return text;
}

TEST(KabschSander, HelicesByTheirTorsions) {
    // Alpha, 3-10 and pi; a straight chain has no bonds.
    EXPECT_EQ(fold(kabschSander(chainOf(12, -57, -47))), "-HHHHHHHHHH-");
    EXPECT_EQ(fold(kabschSander(chainOf(12, -49, -26))), "-HHHHHHHHHH-");
    EXPECT_EQ(fold(kabschSander(chainOf(12, -57, -70))), "-HHHHHHHHHH-");
    EXPECT_EQ(fold(kabschSander(chainOf(12, -135, 135))), "------------");
}

TEST(KabschSander, WhatTheFileStatesGoesFirst) {
    Molecule molecule = chainOf(12, -57, -47);
    EXPECT_EQ(fold(secondaryStructure(molecule)), "-HHHHHHHHHH-");
    molecule.statesSecondaryStructure = true;
    molecule.residues[0].secondary = SecondaryStructure::strand;
    EXPECT_EQ(fold(secondaryStructure(molecule)), "E-----------");
}

TEST(KabschSander, BreaksProlineAndWhatIsMissing) {
    Molecule broken = chainOf(12, -57, -47);
    for (std::size_t i = 6 * 4; i < broken.atoms.size(); ++i) broken.atoms[i].position.x += 30;
    EXPECT_EQ(fold(kabschSander(broken)), "-HHHH--HHHH-");
    Molecule proline = chainOf(12, -57, -47);
    proline.residues[5].name = Name("PRO");  // gives no bond to the second residue, so that no turn begins there
    EXPECT_EQ(fold(kabschSander(proline)), "---HHHHHHHH-");
    Molecule onlyCa = chainOf(12, -57, -47);
    for (Atom& atom : onlyCa.atoms)
        if (atom.name != Name("CA")) atom.name = Name("X");
    EXPECT_EQ(fold(kabschSander(onlyCa)), "------------");
    EXPECT_TRUE(kabschSander(Molecule()).empty());
}

TEST(KabschSander, ModelsUponOneAnotherStandForThemselves) {
    Molecule both = chainOf(12, -57, -47);
    const Molecule one = both;
    both.chains.push_back({"A", 2});
    for (Atom atom : one.atoms) {
        atom.residue += 12;
        both.atoms.push_back(atom);
    }
    for (Residue residue : one.residues) {
        residue.chain = 1;
        residue.firstAtom += 48;
        both.residues.push_back(residue);
    }
    EXPECT_EQ(fold(kabschSander(both)), "-HHHHHHHHHH--HHHHHHHHHH-");
}

TEST(KabschSander, AtomsAtOnePlaceEndSoon) {
    test::MoleculeText text;
    for (int i = 1; i <= 20'000; ++i)
        text.residue("ALA", i).atom("N", "N", {}).atom("CA", "C", {}).atom("C", "C", {}).atom("O", "O", {});
    EXPECT_EQ(fold(kabschSander(text.molecule)), std::string(20'000, '-'));
}

using Place = std::tuple<std::string, int, std::string>;

/// What Debian's mkdssp says of a file: helix for H, G and I, strand for E and B.
std::map<Place, char> judged(const std::string& file) {
    const test::TemporaryFolder folder;
    const std::string out = folder / "out.dssp";
    if (std::system(("mkdssp --output-format dssp '" + file + "' '" + out + "' >/dev/null 2>&1").c_str()) != 0)
        return {};
    std::map<Place, char> kinds;
    std::ifstream lines(out);
    bool body = false;
    for (std::string line; std::getline(lines, line);) {
        if (!body || line[13] == '!') {
            body = body || line.rfind("  #  RESIDUE", 0) == 0;
            continue;
        }
        const char letter = line[16], kind = std::string("HGI").find(letter) != std::string::npos  ? 'H'
                                             : std::string("EB").find(letter) != std::string::npos ? 'E'
                                                                                                   : '-';
        kinds[{line.substr(11, 1), std::stoi(line.substr(5, 5)), line[10] == ' ' ? "" : line.substr(10, 1)}] = kind;
    }
    return kinds;
}

TEST(KabschSander, AgreesWithDssp) {
    NACRE_NEEDS_DATA();
    // Each residue the same but where residues alternate (1BCU's ends of chain I).
    for (const auto& [name, fewest, different] : {std::tuple{"1crn.pdb", 46u, 0u},
                                                  {"4hhb.pdb", 574u, 0u},
                                                  {"1stp-v5.cif", 121u, 0u},
                                                  {"1f2n-virus.cif.gz", 590u, 0u},
                                                  {"gfp-1ema.cif", 225u, 0u},
                                                  {"1bcu-icode.pdb", 284u, 2u}}) {
        SCOPED_TRACE(name);
        const std::map<Place, char> wanted = judged(test::dataFile(name));
        ASSERT_GE(wanted.size(), fewest) << "does mkdssp run?";
        const Molecule molecule = readMoleculeFile(test::dataFile(name));
        const std::string kinds = fold(kabschSander(molecule));
        std::map<Place, char> ours;
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const Residue& residue = molecule.residues[i];
            ours.insert({{molecule.chains[residue.chain].name, residue.number,
                          residue.insertionCode ? std::string(1, residue.insertionCode) : ""},
                         kinds[i]});
        }
        std::size_t wrong = 0;
        for (const auto& [place, kind] : wanted) wrong += !ours.count(place) || ours[place] != kind;
        EXPECT_LE(wrong, different);
    }
}

}  // namespace
}  // namespace nacre
