// Every structure file of a supported format (expected.json) becomes a molecule whose parts fit together.
// Info.AgreesWithIndependentCounts compares their counts.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/molecule/read.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

const nlohmann::json& expectedFiles() {
    static const nlohmann::json files = [] {
        std::ifstream file(*test::dataFolder() / "expected.json");
        return nlohmann::json::parse(file).at("files");
    }();
    return files;
}

/// Bonds and residues refer to atoms that are there, in order.
void expectConsistent(const Molecule& molecule) {
    std::size_t next = 0;
    for (const Residue& residue : molecule.residues) {
        ASSERT_EQ(residue.firstAtom, next);
        ASSERT_GT(residue.atomCount, 0u);
        ASSERT_LT(residue.chain, molecule.chains.size());
        next += residue.atomCount;
    }
    ASSERT_EQ(next, molecule.atoms.size());
    for (const Atom& atom : molecule.atoms) ASSERT_LT(atom.residue, molecule.residues.size());
    for (std::size_t i = 0; i < molecule.bonds.size(); ++i) {
        ASSERT_LT(molecule.bonds[i].a, molecule.bonds[i].b);
        ASSERT_LT(molecule.bonds[i].b, molecule.atoms.size());
    }
}

TEST(ExpectedFiles, AreConsistent) {
    NACRE_NEEDS_DATA();
    int read = 0;
    for (const auto& [name, expected] : expectedFiles().items()) {
        if (expected.value("bad", false)) continue;
        SCOPED_TRACE(name);
        const Molecule molecule = readMoleculeFile(test::dataFile(name));
        expectConsistent(molecule);
        if (molecule.file.format == "pdb") {
            for (const Atom& atom : molecule.atoms) ASSERT_NE(atom.element, 0) << "of unknown element";
            EXPECT_LE(molecule.warnings.size(), 8u);
            for (const std::string& warning : molecule.warnings) EXPECT_LT(warning.size(), 200u);
        }
        ++read;
    }
    EXPECT_GE(read, 82);
}

TEST(ExpectedFiles, SameWithoutAUsefulName) {
    NACRE_NEEDS_DATA();
    for (const auto& [name, expected] : expectedFiles().items()) {
        if (expected.value("bad", false) || expected.value("bytes", 0) > 1'000'000) continue;
        SCOPED_TRACE(name);
        std::ifstream file(test::dataFile(name), std::ios::binary);
        std::stringstream bytes;
        bytes << file.rdbuf();
        const Molecule molecule = readMolecule("structure", bytes.str());
        EXPECT_EQ(molecule.file.format, expected["format"].get<std::string>());
        EXPECT_EQ(molecule.atoms.size(), expected["atoms"].get<std::size_t>());
    }
}

}  // namespace
}  // namespace nacre
