// The samples in every format, written by other programs wherever there is one, are the samples.
#include "tests/support/written_files.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "engine/molecule/read.h"

namespace nacre {
namespace {

using test::WrittenFile;

enum Keeps : unsigned {
    kNames = 1,    ///< atoms and residues have names, residues numbers
    kChains = 2,   ///< residues are in chains
    kHetero = 4,   ///< atoms are told from those of polymers
    kOrders = 8,   ///< bonds have the sample's orders: Open Babel guesses those of what it read from PDB
    kNumbers = 16  ///< a residue's name may end in its number
};

/// What files of a kind say besides elements, coordinates and, by stating or by distance, bonds.
struct Says {
    const char* format;
    unsigned words;
    float error;  ///< largest of one coordinate, Å: halves of the last digits of all that wrote it, and some rounding
};

/// By the end of the file's name.
const std::map<std::string, Says> kKinds = {
    {".pdb", {"pdb", kNames | kChains | kHetero, 0.0006f}},
    {".cif", {"mmcif", kNames, 0.0006f}},
    {".cif.gz", {"mmcif", kNames | kChains, 0.0006f}},
    {".json", {"mmjson", kNames | kChains, 0.0006f}},
    {".bcif", {"bcif", kNames | kChains | kHetero, 0.0006f}},
    {".mmtf", {"mmtf", kNames | kChains | kHetero | kOrders, 0}},
    {".pqr", {"pqr", kNames | kChains | kHetero, 0.0006f}},
    {".pdbqt", {"pdbqt", kNames | kChains, 0.0006f}},
    {".mol2", {"mol2", kNames | kNumbers, 0.0006f}},
    {".gro", {"gro", kNames, 0.0056f}},
    {".cml", {"cml", 0, 0.0006f}},
    {".sdf", {"sdf-v2000", kOrders, 0.00006f}},
    {"_v3000.sdf", {"sdf-v3000", kOrders, 0.00006f}},
    {".xyz", {"xyz", 0, 0.00006f}},
    {"_core.cif", {"cif-core", 0, 0.0012f}},
    {".txyz", {"tinker", 0, 0.00006f}},
    {".mae", {"mae", 0, 0.00006f}},
    {".lmp", {"lammps", 0, 0.00006f}},
};

void expectWords(const Molecule& sample, const Molecule& read, std::size_t atom, unsigned words) {
    const Atom &a = read.atoms[atom], &b = sample.atoms[atom];
    const Residue &in = read.residues[a.residue], &was = sample.residues[b.residue];
    if (words & kNames) {
        ASSERT_EQ(a.name.view(), b.name.view());
        ASSERT_EQ(in.number, was.number);
        const std::string name(was.name.view());
        if (!(words & kNumbers) || in.name.view() != name + std::to_string(was.number)) {
            ASSERT_EQ(in.name.view(), name);
        }
    }
    if (words & kChains) {
        ASSERT_EQ(read.chains[in.chain].name, sample.chains[was.chain].name);
    }
    if (words & kHetero) {
        ASSERT_EQ(a.hetero, b.hetero);
    }
}

void expectAtoms(const Molecule& sample, const Molecule& read, const Says& says, glm::vec3 shift) {
    ASSERT_EQ(read.atoms.size(), sample.atoms.size());
    for (std::size_t i = 0; i < read.atoms.size(); ++i) {
        SCOPED_TRACE(i);
        const Atom &a = read.atoms[i], &b = sample.atoms[i];
        ASSERT_EQ(a.element, b.element);
        for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(a.position[axis] - shift[axis], b.position[axis], says.error);
        ASSERT_NO_FATAL_FAILURE(expectWords(sample, read, i, says.words));
    }
    if (says.words & kNames) {
        EXPECT_EQ(read.residues.size(), sample.residues.size());
    }
}

std::set<std::vector<std::uint32_t>> collectBonds(const Molecule& molecule, bool orders) {
    std::set<std::vector<std::uint32_t>> bonds;
    for (const Bond& bond : molecule.bonds) bonds.insert({bond.a, bond.b, orders ? bond.order : 0u});
    return bonds;
}

TEST(WrittenFiles, AreTheSamples) {
    NACRE_NEEDS_WRITTEN_FILES();
    std::map<std::string, int> seen;
    for (const WrittenFile& file : test::writtenFiles()) {
        SCOPED_TRACE(file.name);
        ASSERT_TRUE(kKinds.count(file.kind)) << file.kind;
        const Says& says = kKinds.at(file.kind);
        const Molecule sample = sampleMolecule(file.sample);
        const Molecule read = readMoleculeFile(file.path);
        EXPECT_EQ(read.file.format, says.format);
        EXPECT_EQ(read.warnings, std::vector<std::string>());
        expectAtoms(sample, read, says, file.kind == "_core.cif" ? test::kMiddleOfCell : glm::vec3(0));
        EXPECT_EQ(collectBonds(read, says.words & kOrders), collectBonds(sample, says.words & kOrders));
        ++seen[file.kind];
    }
    for (const auto& [kind, says] : kKinds) EXPECT_GE(seen[kind], kind == ".pdbqt" ? 2 : 3) << kind;
}

/// The bonds that a file states are the sample's, without any that distances would add.
TEST(WrittenFiles, StateTheBondsThatTheirFormatHas) {
    NACRE_NEEDS_WRITTEN_FILES();
    int stating = 0;
    for (const WrittenFile& file : test::writtenFiles()) {
        SCOPED_TRACE(file.name);
        const bool states = std::set<std::string>{".sdf", "_v3000.sdf", ".mol2", ".cml", ".mmtf"}.count(file.kind);
        if (!states) continue;
        const Molecule read = readMoleculeFile(file.path);
        for (const Bond& bond : read.bonds) ASSERT_EQ(bond.source, BondSource::file);
        EXPECT_EQ(read.file.bonds, std::int64_t(read.bonds.size()));
        ++stating;
    }
    EXPECT_GE(stating, 15);
}

}  // namespace
}  // namespace nacre
