// The PDB files of the data folder against the counts that independent tools made of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
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

void expectCounts(const std::string& file, const nlohmann::json& expected) {
    SCOPED_TRACE(file);
    const Molecule m = readFile(file);
    const auto count = [&](const auto& predicate) { return std::count_if(m.atoms.begin(), m.atoms.end(), predicate); };
    EXPECT_EQ(m.atoms.size(), expected.at("atoms"));
    EXPECT_EQ(m.file.models, expected.at("models").get<std::int64_t>());
    EXPECT_EQ(m.file.totalAtomsAllModels, expected.at("total_atoms_all_models").get<std::int64_t>());
    EXPECT_EQ(count([](const Atom& a) { return a.hetero; }), expected.at("hetatm"));
    EXPECT_EQ(m.file.chains, expected.at("chains").get<std::int64_t>());
    EXPECT_EQ(count([](const Atom& a) { return a.alternate != '\0'; }), expected.at("altloc_atoms"));
    EXPECT_EQ(count([&](const Atom& a) { return m.residues[a.residue].insertionCode != '\0'; }),
              expected.at("insertion_code_atoms"));
    EXPECT_EQ(count([&](const Atom& a) { return m.residues[a.residue].number < 0; }),
              expected.at("negative_resnum_atoms"));
    EXPECT_EQ(m.file.conectUniquePairs, expected.at("conect_unique_pairs").get<std::int64_t>());
    EXPECT_EQ(m.file.biomtOperators.value_or(0), expected.value("biomt_operators", 0));
    for (int axis = 0; axis < 3; ++axis) {
        const auto byAxis = [&](const Atom& l, const Atom& r) { return l.position[axis] < r.position[axis]; };
        const auto [low, high] = std::minmax_element(m.atoms.begin(), m.atoms.end(), byAxis);
        EXPECT_NEAR(low->position[axis], expected.at("bbox")[0][static_cast<unsigned>(axis)].get<double>(), 1e-3);
        EXPECT_NEAR(high->position[axis], expected.at("bbox")[1][static_cast<unsigned>(axis)].get<double>(), 1e-3);
    }
    EXPECT_EQ(count([](const Atom& a) { return a.element == 0; }), 0) << "atoms of unknown element";
    EXPECT_LE(m.warnings.size(), 8u);
    for (const std::string& warning : m.warnings) EXPECT_LT(warning.size(), 200u);
}

TEST(PdbFiles, HaveTheCountsOfIndependentTools) {
    NACRE_NEEDS_DATA();
    const auto expected = nlohmann::json::parse(std::ifstream(test::dataFile("expected.json")));
    int files = 0;
    for (const auto& [file, entry] : expected.at("files").items()) {
        if (entry.value("format", "") != "pdb") continue;
        expectCounts(file, entry);
        ++files;
    }
    EXPECT_GE(files, 20);
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

    const auto expected = nlohmann::json::parse(std::ifstream(test::dataFile("expected.json"))).at("files");
    for (const char* file :
         {"bad/crlf.pdb", "bad/ensemble_error_1.pdb", "bad/ensemble_error_3.pdb", "bad/odd-start.pdb",
          "bad/short-cryst1.pdb", "bad/non-utf8.pdb", "bad/hetatm_bad.pdb", "bad/conect-dangling.pdb"}) {
        expectCounts(file, expected.at(file).at("lenient_independent_count"));
    }
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
