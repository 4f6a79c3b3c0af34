// Every malformed or hostile file ends in a molecule or in one clear line. The table says which, and why.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/molecule/expect_error.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

struct Expectation {
    const char* file;
    std::size_t atoms;     ///< 0: it must be refused
    const char* why = "";  ///< part of the message
};

constexpr Expectation kFiles[] = {
    {"0red.bcif", 0, "it has no _atom_site rows"},
    {"1en2_err.cif", 9},
    {"bad-atom-line.sdf", 0, "(line 5): expected atom 1 of 1"},
    {"bad-crc.pdb.gz", 0, "wrong checksum"},
    {"bcif-bitflips.bcif", 0, "not valid MessagePack"},
    {"bcif-truncated.bcif", 0, "cut short"},
    {"conect-dangling.pdb", 327},
    {"count-line-too-short.sdf", 0, "no atoms"},
    {"crlf.pdb", 327},
    {"difficult-quoting.cif", 4},
    {"empty-all0.mmtf", 0, "it has no atoms"},
    {"empty-numModels1.mmtf", 0, "it has no atoms"},
    {"empty.pdb", 0, "it is empty"},
    {"ensemble_error_1.pdb", 2},
    {"ensemble_error_3.pdb", 2},
    {"extended-bad-properties.xyz", 0, "(line 3): invalid x coordinate"},
    {"far-apart.pdb", 2},
    {"garbage.cif", 0, "not valid CIF"},
    {"helium-bad.xyz", 0, "it ends after 4 of 8 atoms"},
    {"hetatm_bad.pdb", 2},
    {"huge-line.pdb", 0, "no ATOM or HETATM"},  // the header of 1CRN; it ends before the atoms
    {"missing-coords.cif", 0, "_atom_site.Cartn_y is missing"},
    {"mmtf-bitflips.mmtf", 0, "not valid MessagePack"},
    {"mmtf-huge-array.mmtf", 0, "MMTF version '' is not supported"},
    {"mmtf-truncated.mmtf", 0, "cut short"},
    {"mol2-no-atoms.mol2", 0, "(line 3): it states 5 atoms and has 0"},
    {"nan-coord.pdb", 324},
    {"no-atoms.pdb", 0, "no ATOM or HETATM"},
    {"non-utf8.pdb", 327},
    {"not-gzip.pdb.gz", 0, "no ATOM or HETATM"},  // text of a header, read as what it is
    {"ob-ant-2026-00770.sdf", 8},
    {"ob-cve-2022-41793.xyz", 1},
    {"ob-cve-2022-43607.mol2", 0, "it has no atoms"},
    {"ob-cve-2022-46280.xyz", 1},
    {"ob-cve-2026-2704.cif", 26},
    {"odd-start.pdb", 20},
    {"png-named.pdb", 0, "PNG picture"},
    {"sdf-bond-out-of-range.sdf", 24},
    {"sdf-counts-999.sdf", 0, "(line 29): expected atom 25 of 999"},
    {"sdf-counts-negative.sdf", 0, "(line 4): negative counts"},
    {"short-cryst1.pdb", 9},
    {"stars-coord.pdb", 324},
    {"truncated-gzip.pdb.gz", 0, "truncated"},
    {"truncated-in-loop.cif", 0, "(line 624): the last row of _atom_site has 14 values instead of 26"},
    {"truncated-mid-line.pdb", 0, "no ATOM or HETATM"},
    {"truncated.gro", 0, "(line 2): it states 1405 atoms, but does not have as many"},
    {"unterminated-text.cif", 0, "(line 1004): not valid CIF"},
    {"xyz-count-2billion.xyz", 0, "(line 1): it states 2147483647 atoms"},
    {"xyz-count-huge.xyz", 0, "(line 1): it states 99999999999999999999 atoms"},
    {"xyz-nan.xyz", 0, "(line 4): invalid x coordinate 'nan'"},
    {"xyz-unknown-elements.xyz", 4},
};

TEST(BadFiles, EndAsTheTableSays) {
    NACRE_NEEDS_DATA();
    for (const Expectation& expected : kFiles) {
        SCOPED_TRACE(expected.file);
        try {
            const Molecule molecule = readMoleculeFile(test::dataFile(std::string("bad/") + expected.file));
            EXPECT_EQ(molecule.atoms.size(), expected.atoms);
        } catch (const Error& error) {
            test::expectCleanMessage(error.what());
            EXPECT_EQ(expected.atoms, 0u) << error.what();
            EXPECT_NE(std::string(error.what()).find(expected.why), std::string::npos) << error.what();
        }
    }
}

TEST(BadFiles, NoneThrowsAnythingElse) {
    NACRE_NEEDS_DATA();
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(*test::dataFolder() / "bad")) {
        SCOPED_TRACE(entry.path());
        try {
            EXPECT_GT(readMoleculeFile(entry.path()).atoms.size(), 0u);
        } catch (const Error& error) {
            test::expectCleanMessage(error.what());
            EXPECT_NE(std::string(error.what()).find(entry.path().filename()), std::string::npos) << error.what();
        }
        ++files;
    }
    EXPECT_EQ(files, static_cast<int>(std::size(kFiles)));
}

}  // namespace
}  // namespace nacre
