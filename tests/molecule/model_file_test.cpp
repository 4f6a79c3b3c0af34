// Models of a file that are read as they are needed: what they are when the whole file is read.

#include "engine/molecule/model_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>

#include "engine/error.h"
#include "engine/molecule/other_models.h"
#include "tests/support/error_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"
#include "tests/support/written_files.h"

namespace nacre {
namespace {

using test::TemporaryFolder;

/// @param held  bytes of text that are held whole
ReadOptions of(int model, std::size_t held, bool others = false) {
    ReadOptions options{.model = model, .heldText = held, .others = others};
    return options;
}

void expectSame(const Molecule& a, const Molecule& b) {
    ASSERT_EQ(a.atoms.size(), b.atoms.size());
    for (std::size_t i = 0; i < a.atoms.size(); ++i) {
        const Atom &x = a.atoms[i], &y = b.atoms[i];
        ASSERT_EQ(x.position, y.position) << i;
        ASSERT_TRUE(x.element == y.element && x.name == y.name && x.residue == y.residue && x.charge == y.charge) << i;
    }
    ASSERT_EQ(a.residues.size(), b.residues.size());
    for (std::size_t i = 0; i < a.residues.size(); ++i) {
        ASSERT_TRUE(a.residues[i].name == b.residues[i].name && a.residues[i].number == b.residues[i].number) << i;
        ASSERT_TRUE(a.residues[i].secondary == b.residues[i].secondary) << i;
    }
    ASSERT_EQ(a.chains.size(), b.chains.size());
    for (std::size_t i = 0; i < a.chains.size(); ++i) ASSERT_EQ(a.chains[i].model, b.chains[i].model);
    ASSERT_EQ(a.bonds.size(), b.bonds.size());
    for (std::size_t i = 0; i < a.bonds.size(); ++i)
        ASSERT_TRUE(a.bonds[i].a == b.bonds[i].a && a.bonds[i].b == b.bonds[i].b &&
                    a.bonds[i].order == b.bonds[i].order)
            << i;
    EXPECT_EQ(a.file.format, b.file.format);
    EXPECT_EQ(a.file.title, b.file.title);
    EXPECT_EQ(a.file.models, b.file.models);
    EXPECT_EQ(a.file.records, b.file.records);
    EXPECT_EQ(a.file.totalAtomsAllModels, b.file.totalAtomsAllModels);
    EXPECT_EQ(a.file.totalAtomsAllRecords, b.file.totalAtomsAllRecords);
    EXPECT_EQ(a.file.totalBondsAllRecords, b.file.totalBondsAllRecords);
    EXPECT_EQ(a.warnings, b.warnings);
    EXPECT_EQ(a.othersMissing, b.othersMissing);
    ASSERT_EQ(a.others.size(), b.others.size());
    for (std::size_t i = 0; i < a.others.size(); ++i) {
        const OtherModel x = a.others[i], y = b.others[i];
        ASSERT_EQ(x.positions, y.positions) << i;
        ASSERT_EQ(x.whole != nullptr, y.whole != nullptr) << i;
    }
}

class ModelFiles : public testing::TestWithParam<std::string> {};

TEST_P(ModelFiles, AreReadAloneAsFromTheWhole) {
    const bool written = GetParam().rfind("several/", 0) == 0;
    if (written) {
        NACRE_NEEDS_WRITTEN_FILES();
    } else {
        NACRE_NEEDS_DATA();
    }
    const std::string path = written ? test::writtenFile(GetParam()) : test::dataFile(GetParam());
    const std::size_t whole = std::size_t{1} << 31;
    const Molecule first = readMoleculeFile(path, of(1, whole, true));
    const int count = static_cast<int>(std::max(first.file.models.value_or(1), first.file.records.value_or(1)));
    for (const std::size_t held : {std::size_t{0}, whole}) {
        ModelFile file(path, of(1, held));
        ASSERT_EQ(file.count(), count);
        expectSame(file.first(), first);
        for (const int model : {count, 1, count / 2 + 1}) {
            const Molecule expected = readMoleculeFile(path, of(model, whole)), alone = file.read(model);
            ASSERT_EQ(alone.atoms.size(), expected.atoms.size());
            for (std::size_t i = 0; i < alone.atoms.size(); ++i)
                ASSERT_EQ(alone.atoms[i].position, expected.atoms[i].position);
            ASSERT_EQ(alone.bonds.size(), expected.bonds.size());
            EXPECT_EQ(alone.chains.front().model, model);
        }
    }
    expectSame(readMoleculeFile(path, of(count, 0, true)), readMoleculeFile(path, of(count, whole, true)));
}

INSTANTIATE_TEST_SUITE_P(Files, ModelFiles,
                         testing::Values("1l2y.pdb", "1l2y.cif.gz", "1l2y.bcif", "1msh-nmr30.mmtf",
                                         "2koc-rna-nmr.cif.gz", "small/dxc.pdbqt", "small/ligs3d-multi.mol2",
                                         "1en2.cif", "several/samples.pdb", "several/samples.sdf",
                                         "several/samples.mol2", "several/samples.xyz"));

/// A BinaryCIF file is not written here: an mmJSON one has its models in the same tables.
TEST(ModelFile, HoldsSomeOfTheModelsOfCommonTables) {
    constexpr int kModels = 400, kAtoms = 300;
    std::string columns[6];
    for (int model = 1; model <= kModels; ++model)
        for (int atom = 0; atom < kAtoms; ++atom) {
            const char* comma = columns[0].empty() ? "" : ",";
            const std::string cells[] = {std::to_string(model),
                                         std::to_string(atom % 20 * 4 + model * 0.001),
                                         std::to_string(atom / 20 * 4),
                                         "0",
                                         "\"C\"",
                                         "\"CA\""};
            for (std::size_t i = 0; i < 6; ++i) columns[i] += comma + cells[i];
        }
    const char* const names[] = {"pdbx_PDB_model_num", "Cartn_x", "Cartn_y", "Cartn_z", "type_symbol", "label_atom_id"};
    std::string text = R"({"data_M": {"atom_site": {)";
    for (std::size_t i = 0; i < 6; ++i)
        text += std::string(i == 0 ? "\"" : ", \"") + names[i] + "\": [" + columns[i] + "]";
    const TemporaryFolder folder;
    std::ofstream(folder / "m.json") << text << "}}}";
    for (const std::size_t held : {std::size_t{0}, std::size_t{1} << 31}) {
        ModelFile file(folder / "m.json", of(1, held));
        ASSERT_EQ(file.count(), kModels);
        EXPECT_TRUE(file.first().others.allMove(kAtoms));
        for (const int model : {1, 7, 400, 399, 8, 5}) {
            const Molecule read = file.read(model);
            ASSERT_EQ(read.atoms.size(), std::size_t{kAtoms});
            EXPECT_NEAR(read.atoms[0].position.x, model * 0.001, 1e-5) << held;
            EXPECT_EQ(read.chains.front().model, model);
        }
    }
}

std::string makeModels(int count) {
    std::string text = "TITLE     MODELS\r\n";
    for (int i = 1; i <= count; ++i) {
        std::string atom = "ATOM      1  CA  GLY A   1       1.000   2.000   3.000  1.00  0.00           C\r\n";
        atom.replace(33, 1, std::to_string(i % 10));
        text += "MODEL        " + std::to_string(i) + "\r\n" + atom + "ENDMDL\r\n";
    }
    return text + "END\r\n";
}

TEST(ModelFile, ReadsNothingButTheModelThatIsWanted) {
    const TemporaryFolder folder;
    const std::string path = folder / "m.pdb", text = makeModels(4);
    std::ofstream(path, std::ios::binary) << text;
    ModelFile file(path, of(1, 0));
    ASSERT_EQ(file.count(), 4);
    // What stands elsewhere in the file is looked at no more.
    std::fstream damage(path, std::ios::binary | std::ios::in | std::ios::out);
    for (const char* model : {"MODEL        1", "MODEL        2", "MODEL        4"}) {
        damage.seekp(static_cast<std::streamoff>(text.find(model)));
        damage << std::string(60, 'x');
    }
    damage.close();
    EXPECT_EQ(file.read(3).atoms.at(0).position, glm::vec3(3, 2, 3));
    EXPECT_THROW(file.read(2), Error);
}

TEST(ModelFile, OfACompressedFileStandsInATemporaryOne) {
    const TemporaryFolder folder;
    const std::string path = folder / "m.pdb.gz", text = makeModels(200);
    const gzFile out = gzopen(path.c_str(), "wb");
    gzwrite(out, text.data(), static_cast<unsigned>(text.size()));
    gzclose(out);
    ModelFile file(path, of(1, 300));
    ASSERT_EQ(file.count(), 200);
    std::filesystem::remove(path);
    EXPECT_EQ(file.read(137).atoms.at(0).position, glm::vec3(7, 2, 3));
    EXPECT_EQ(file.read(4).atoms.at(0).position, glm::vec3(4, 2, 3));
    EXPECT_EQ(folder.count(), 0u);
}

TEST(ModelFile, SaysWhatIsWrongWithAModelAndWhere) {
    const TemporaryFolder folder;
    std::string text = makeModels(3);
    const std::size_t second = text.find("ATOM", text.find("MODEL        2"));
    text.replace(second + 30, 8, "   far  ");
    std::ofstream(folder / "m.pdb", std::ios::binary) << text;
    ModelFile file(folder / "m.pdb", of(1, 0));
    EXPECT_EQ(file.read(3).atoms.size(), 1u);
    test::expectThrows([&] { file.read(2); }, "m.pdb (line 6)");
}

TEST(StoredModels, BeyondABoundStandInAFile) {
    OtherModels places;
    const auto at = [](float x) { return OtherModel{{glm::vec3(x), glm::vec3(-x)}, nullptr}; };
    EXPECT_EQ(places.add(at(1), 24), 24u);
    EXPECT_EQ(places.add(at(2), 24), 0u) << "held, too";
    EXPECT_EQ(places.add(at(3), 24), 0u);
    const OtherModels copy = places;
    places.clear();
    EXPECT_TRUE(places.empty());
    ASSERT_EQ(copy.size(), 3u);
    for (std::size_t i = 3; i-- > 0;) {
        const OtherModel other = copy[i];
        ASSERT_EQ(other.positions.size(), 2u);
        EXPECT_EQ(other.positions[1], glm::vec3(-static_cast<float>(i + 1)));
    }
    EXPECT_TRUE(copy.allMove(2));
    EXPECT_FALSE(copy.allMove(3));
}

}  // namespace
}  // namespace nacre
