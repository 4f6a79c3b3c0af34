// Every structure file of a supported format against the counts that independent tools took (expected.json).
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/molecule/chain_summary.h"
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

/// One key of expected.json against the value that we have; absent keys are not compared.
template <typename Value>
void expectKey(const nlohmann::json& expected, const char* key, const Value& value) {
    if (!expected.contains(key)) return;
    if constexpr (std::is_same_v<Value, std::optional<std::int64_t>>) {
        ASSERT_TRUE(value.has_value()) << key;
        EXPECT_EQ(*value, expected.at(key).get<std::int64_t>()) << key;
    } else {
        EXPECT_EQ(value, expected.at(key).get<Value>()) << key;
    }
}

void expectSummary(const nlohmann::json& expected, const FileSummary& file) {
    expectKey(expected, "format", file.format);
    expectKey(expected, "models", file.models);
    expectKey(expected, "records", file.records);
    expectKey(expected, "total_atoms_all_models", file.totalAtomsAllModels);
    expectKey(expected, "total_atoms_all_records", file.totalAtomsAllRecords);
    expectKey(expected, "total_bonds_all_records", file.totalBondsAllRecords);
    expectKey(expected, "bonds", file.bonds);
    expectKey(expected, "bonds_all_models", file.bondsAllModels);
    expectKey(expected, "conect_unique_pairs", file.conectUniquePairs);
    expectKey(expected, "chains", file.chains);
    expectKey(expected, "chains_auth", file.chainsAuth);
    expectKey(expected, "chains_label", file.chainsLabel);
    expectKey(expected, "biomt_operators", file.biomtOperators);
    expectKey(expected, "assemblies", file.assemblies);
    expectKey(expected, "oper_list", file.operators);
}

void expectCounts(const nlohmann::json& expected, const MoleculeCounts& counts) {
    expectKey(expected, "atoms", counts.atoms);
    expectKey(expected, "hetatm", counts.hetatm);
    expectKey(expected, "altloc_atoms", counts.altlocAtoms);
    expectKey(expected, "insertion_code_atoms", counts.insertionCodeAtoms);
    expectKey(expected, "negative_resnum_atoms", counts.negativeResnumAtoms);
    ASSERT_TRUE(counts.bbox.has_value());
    if (!expected.contains("bbox")) return;
    for (int end = 0; end < 2; ++end)
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR((*counts.bbox)[end][axis], expected["bbox"][end][axis].get<double>(), 6e-4)
                << "bbox " << end << ' ' << "xyz"[axis];
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

/// Damaged files of which the tools counted what is left.
constexpr std::string_view kReadLeniently[] = {
    "bad/crlf.pdb",         "bad/ensemble_error_1.pdb", "bad/ensemble_error_3.pdb", "bad/odd-start.pdb",
    "bad/short-cryst1.pdb", "bad/non-utf8.pdb",         "bad/hetatm_bad.pdb",       "bad/conect-dangling.pdb"};

TEST(ExpectedFiles, CountsAgreeWithIndependentTools) {
    NACRE_NEEDS_DATA();
    int read = 0;
    for (const auto& [name, entry] : expectedFiles().items()) {
        const bool bad = entry.value("bad", false);
        if (bad && std::ranges::find(kReadLeniently, name) == std::end(kReadLeniently)) continue;
        const nlohmann::json& expected = bad ? entry.at("lenient_independent_count") : entry;
        SCOPED_TRACE(name);
        const Molecule molecule = readMoleculeFile(test::dataFile(name));
        expectSummary(expected, molecule.file);
        expectCounts(expected, countMolecule(molecule));
        expectConsistent(molecule);
        if (molecule.file.format == "pdb") {
            for (const Atom& atom : molecule.atoms) ASSERT_NE(atom.element, 0) << "of unknown element";
            EXPECT_LE(molecule.warnings.size(), 8u);
            for (const std::string& warning : molecule.warnings) EXPECT_LT(warning.size(), 200u);
        }
        ++read;
    }
    EXPECT_GE(read, 90);
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
