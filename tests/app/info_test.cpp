#include <gtest/gtest.h>

#include <fstream>

#include "app/headless/info_command.h"
#include "engine/molecule/read.h"
#include "tests/support/test_data.h"

namespace nacre::app {
namespace {

Molecule twoAtoms() {
    Molecule molecule;
    molecule.chains = {{"A"}};
    molecule.residues.resize(2);
    molecule.residues[0].number = -3;
    molecule.residues[1].insertionCode = 'B';
    molecule.atoms.resize(2);
    molecule.atoms[0].position = {7.075f, -1, 2};
    molecule.atoms[1].position = {1, 4, 2.5f};
    molecule.atoms[1].residue = 1;
    molecule.atoms[1].hetero = true;
    molecule.bonds = {{0, 1, 2, BondSource::distance}};
    molecule.file.format = "pdb";
    molecule.file.models = 3;
    molecule.file.title = "A title \x1b[31m\xff";
    molecule.warnings = {"something was odd"};
    return molecule;
}

TEST(Info, CountsWhatTheMoleculeHolds) {
    const auto json = infoJson(twoAtoms());
    EXPECT_EQ(json["format"], "pdb");
    EXPECT_EQ(json["atoms"], 2);
    EXPECT_EQ(json["models"], 3);
    EXPECT_EQ(json["hetatm"], 1);
    EXPECT_EQ(json["altloc_atoms"], 0);
    EXPECT_EQ(json["insertion_code_atoms"], 1);
    EXPECT_EQ(json["negative_resnum_atoms"], 1);
    EXPECT_EQ(json["bonds_known"]["distance"], 1);
    EXPECT_EQ(json["bonds_known"]["double"], 1);
    EXPECT_FALSE(json.contains("chains_auth"));
    EXPECT_EQ(json["bbox"].dump(), "[[1.0,-1.0,2.0],[7.075,4.0,2.5]]");  // as written, not as a float widens
}

TEST(Info, TextIsSafeForATerminal) {
    const std::string text = infoText("file.pdb", infoJson(twoAtoms()));
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_NE(text.find("A title"), std::string::npos);
    EXPECT_NE(text.find("something was odd"), std::string::npos);
    EXPECT_NE(text.find("double 1"), std::string::npos);
}

TEST(Info, AMoleculeWithoutAtomsHasNoBox) {
    const auto json = infoJson(Molecule{});
    EXPECT_EQ(json["atoms"], 0);
    EXPECT_FALSE(json.contains("bbox"));
}

// Every key that the independent counts know, for every file of a format that Nacre reads.
TEST(Info, AgreesWithIndependentCounts) {
    NACRE_NEEDS_DATA();
    const auto expected = nlohmann::json::parse(std::ifstream(test::dataFile("expected.json")));
    int compared = 0;
    for (const auto& [name, entry] : expected["files"].items()) {
        if (entry.value("bad", false) || entry["bytes"] > 2000000) continue;
        const std::string format = entry["format"];
        if (format != "pdb" && format != "mmcif" && format != "mmjson" && format != "xyz" && format != "sdf-v2000" &&
            format != "sdf-v3000" && format != "mol2" && format != "pqr" && format != "gro" && format != "pdbqt" &&
            format != "cml")
            continue;
        SCOPED_TRACE(name);
        const nlohmann::json json = infoJson(readMoleculeFile(test::dataFile(name)));
        for (const auto& [key, value] : entry.items()) {
            if (key == "bytes" || key == "sha256" || key == "note" || key == "openbabel" || key.starts_with("gemmi_"))
                continue;
            ASSERT_TRUE(json.contains(key)) << key;
            if (key != "bbox") {
                EXPECT_EQ(json[key], value) << key;
                continue;
            }
            for (std::size_t corner = 0; corner < 2; ++corner)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    EXPECT_NEAR(json[key][corner][axis].get<double>(), value[corner][axis].get<double>(), 6e-4) << key;
        }
        ++compared;
    }
    EXPECT_GT(compared, 50);
}

}  // namespace
}  // namespace nacre::app
