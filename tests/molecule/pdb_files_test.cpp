// PDB files of the data folder that are damaged, have several models, or no columns of elements.

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/molecule/formats/format_table.h"
#include "tests/molecule/text_file.h"
#include "tests/support/error_text.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

Molecule readFile(const std::string& file, int model = 1) {
    return formatRow(Format::pdb).read(file, test::readText(test::dataFile(file)), {.model = model});
}

std::string catchError(const std::string& file) {
    return test::errorText([&] { readFile(file); });
}

TEST(PdbFiles, BadOnesGiveOneClearErrorOrLoad) {
    NACRE_NEEDS_DATA();
    const std::string cannot = "cannot read molecule: ";
    EXPECT_EQ(catchError("bad/empty.pdb"), cannot + "bad/empty.pdb: the file is empty");
    EXPECT_EQ(catchError("bad/no-atoms.pdb"), cannot + "bad/no-atoms.pdb: it has no ATOM or HETATM records");
    EXPECT_EQ(catchError("bad/png-named.pdb"), cannot + "bad/png-named.pdb: it is not text, so not a PDB file");
    EXPECT_EQ(catchError("bad/truncated-mid-line.pdb"),
              cannot + "bad/truncated-mid-line.pdb: it has no ATOM or HETATM records");
    EXPECT_EQ(catchError("bad/huge-line.pdb"), cannot + "bad/huge-line.pdb: it has no ATOM or HETATM records");
    for (const char* file : {"bad/nan-coord.pdb", "bad/stars-coord.pdb"}) {
        const Molecule molecule = readFile(file);
        EXPECT_EQ(molecule.atoms.size(), 324u);
        ASSERT_FALSE(molecule.notes.empty());
        EXPECT_EQ(describeNote(molecule.notes.back()).find("left out 3 atoms, the first on line "), 0u);
    }
    // The sign stands in column 30, which readers by columns alone lose.
    EXPECT_EQ(readFile("bad/far-apart.pdb").atoms.at(0).position, glm::vec3(-9999, -999, 9999.999f));
    EXPECT_FALSE(readFile("bad/conect-dangling.pdb").notes.empty());
}

TEST(PdbFiles, EveryModelCanBeRead) {
    NACRE_NEEDS_DATA();
    std::int64_t atoms = 0;
    for (int model = 1; model <= 10; ++model)
        atoms += static_cast<std::int64_t>(readFile("small/ligs3d-multi.pdb", model).atoms.size());
    EXPECT_EQ(atoms, 337);
    EXPECT_EQ(test::errorText([&] { readFile("small/ligs3d-multi.pdb", 11); }),
              "cannot read molecule: small/ligs3d-multi.pdb: no model 11: there are 10 models");
}

TEST(PdbFiles, ElementsComeFromNamesWhereColumnsAreMissing) {
    NACRE_NEEDS_DATA();
    std::map<std::string, int> neon;
    for (const Atom& atom : readFile("neon-pump.pdb").atoms) ++neon[std::string(elementSymbol(atom.element))];
    EXPECT_EQ(neon.at("Si"), 1645);  // names " SI " and "SI  "
    EXPECT_EQ(neon.at("H"), 1806);
    EXPECT_EQ(neon.at("N"), 224);
    std::map<std::string, int> old;
    for (const Atom& atom : readFile("1hpv.pdb").atoms) ++old[std::string(elementSymbol(atom.element))];
    EXPECT_EQ(old.count("Ca"), 0u);
    EXPECT_EQ(old.count("H"), 0u);
}

}  // namespace
}  // namespace nacre
