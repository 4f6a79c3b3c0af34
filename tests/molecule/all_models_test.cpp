// --model all: every model of a file, one over the other.

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/formats/mmcif_model_texts.h"
#include "engine/molecule/read.h"
#include "engine/molecule/selection/selection.h"
#include "tests/molecule/expect_error.h"
#include "tests/support/test_data.h"
#include "tests/support/written_files.h"

namespace nacre {
namespace {

ReadOptions model(int number) {
    ReadOptions options;
    options.model = number;
    return options;
}

std::ptrdiff_t count(const Molecule& molecule, const char* selection) {
    const std::vector<bool> selected = selectAtoms(molecule, parseSelection(selection));
    return std::count(selected.begin(), selected.end(), true);
}

struct Overlay {
    const char* file;
    int models;
};
void PrintTo(const Overlay& c, std::ostream* out) { *out << c.file; }
class AllModels : public testing::TestWithParam<Overlay> {};

TEST_P(AllModels, AreTheModelsOneAfterTheOther) {
    const bool written = std::string(GetParam().file).rfind("several/", 0) == 0;
    if (written) {
        NACRE_NEEDS_WRITTEN_FILES();
    } else {
        NACRE_NEEDS_DATA();
    }
    const std::string path = written ? test::writtenFile(GetParam().file) : test::dataFile(GetParam().file);
    const Molecule all = readMoleculeFile(path, model(kAllModels));
    std::size_t atom = 0, bond = 0, residue = 0;
    for (int i = 1; i <= GetParam().models; ++i) {
        const Molecule one = readMoleculeFile(path, model(i));
        ASSERT_LE(atom + one.atoms.size(), all.atoms.size());
        EXPECT_EQ(count(all, ("model " + std::to_string(i)).c_str()), std::ptrdiff_t(one.atoms.size()));
        for (std::size_t k = 0; k < one.atoms.size(); ++k) {
            const Atom &a = all.atoms[atom + k], &b = one.atoms[k];
            ASSERT_EQ(a.position, b.position);
            ASSERT_EQ(a.element, b.element);
            ASSERT_EQ(a.residue, b.residue + residue);
            const Residue &r = all.residues[a.residue], &s = one.residues[b.residue];
            ASSERT_EQ(r.firstAtom, s.firstAtom + atom);
            ASSERT_EQ(all.chains[r.chain].name, one.chains[s.chain].name);
            ASSERT_EQ(all.chains[r.chain].model, i);
            if (!one.subchains.empty()) {
                ASSERT_EQ(all.subchains[r.subchain], one.subchains[s.subchain]);
            }
            ASSERT_EQ(r.entity ? all.entities[r.entity - 1] : "", s.entity ? one.entities[s.entity - 1] : "");
        }
        for (const Bond& b : one.bonds) {
            ASSERT_LT(bond, all.bonds.size());
            ASSERT_EQ(all.bonds[bond].a, b.a + atom);
            ASSERT_EQ(all.bonds[bond].b, b.b + atom);
            ASSERT_EQ(all.bonds[bond].order, b.order);
            ++bond;
        }
        if (!one.partialCharges.empty()) {
            ASSERT_EQ(all.partialCharges.at(atom), one.partialCharges[0]);
        }
        // Conformers are chosen within each model.
        const std::vector<std::uint32_t> drawn = drawnAtoms(one), drawnOfAll = drawnAtoms(all);
        for (const std::uint32_t d : drawn)
            ASSERT_TRUE(std::binary_search(drawnOfAll.begin(), drawnOfAll.end(), d + atom));
        atom += one.atoms.size();
        residue += one.residues.size();
    }
    EXPECT_EQ(atom, all.atoms.size());
    EXPECT_EQ(bond, all.bonds.size());
    const auto total = all.file.totalAtomsAllModels ? all.file.totalAtomsAllModels : all.file.totalAtomsAllRecords;
    EXPECT_EQ(total, std::int64_t(all.atoms.size()));
}

INSTANTIATE_TEST_SUITE_P(Files, AllModels,
                         testing::Values(Overlay{"1l2y.pdb", 38}, Overlay{"1l2y.cif.gz", 38}, Overlay{"1l2y.bcif", 38},
                                         Overlay{"1msh-nmr30.mmtf", 30}, Overlay{"2koc-rna-nmr.cif.gz", 20},
                                         Overlay{"md-lysozyme-solvated.gro", 3}, Overlay{"small/dxc.pdbqt", 9},
                                         Overlay{"small/ligs3d-multi.mol2", 10}, Overlay{"1crn.pdb", 1},
                                         Overlay{"1en2.cif", 1}, Overlay{"several/samples.pdb", 3},
                                         Overlay{"several/samples.sdf", 3}, Overlay{"several/samples.mol2", 3},
                                         Overlay{"several/samples.xyz", 3}));

TEST(AllModels, OfTheSamplesAreTheSamples) {
    NACRE_NEEDS_WRITTEN_FILES();
    for (const char* file : {"several/samples.pdb", "several/samples.sdf", "several/samples.mol2"}) {
        int number = 0;
        for (const char* name : {"dna", "glucose", "buckyball"}) {
            const Molecule one = readMoleculeFile(test::writtenFile(file), model(++number));
            const Molecule sample = sampleMolecule(name);
            EXPECT_EQ(one.atoms.size(), sample.atoms.size()) << file << ' ' << name;
            EXPECT_EQ(one.bonds.size(), sample.bonds.size()) << file << ' ' << name;
        }
    }
}

TEST(AllModels, OfTwoFramesThatLieOnEachOtherAreNotBonded) {
    const std::string frame = "2\nframe\nC 0 0 0\nO 1.2 0 0\n";
    const Molecule all = readMolecule("two.xyz", frame + frame, model(kAllModels));
    ASSERT_EQ(all.atoms.size(), 4u);
    ASSERT_EQ(all.bonds.size(), 2u);
    EXPECT_EQ(all.bonds[1].a, 2u);
    EXPECT_EQ(all.bonds[1].b, 3u);
}

TEST(AllModels, ChooseConformersWithinEachModel) {
    const auto atom = [](char location, const char* occupancy) {
        std::string line = "ATOM      1  CA xGLY A   1       0.000   0.000   0.000  0.00  0.00           C\n";
        line[16] = location;
        return line.replace(56, 4, occupancy);
    };
    const std::string text = "MODEL        1\n" + atom('A', "0.70") + atom('B', "0.30") + "ENDMDL\nMODEL        2\n" +
                             atom('A', "0.20") + atom('B', "0.80") + "ENDMDL\n";
    const Molecule all = readMolecule("two.pdb", text, model(kAllModels));
    EXPECT_EQ(drawnAtoms(all), (std::vector<std::uint32_t>{0, 3}));
}

constexpr const char* kHead =
    "data_x\n#\n_struct.title 'two words'\n#\nloop_\n_atom_site.group_PDB\n_atom_site.label_atom_id\n"
    "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.pdbx_PDB_model_num\n";
constexpr const char* kTail = "#\n_cell.length_a 1\n#\n";

std::string rowsOf(const std::string& model, const std::string& x) {
    return "ATOM \"O5'\" " + x + " 0 0 " + model + " \nATOM 'C 5'  " + x + " 1.2 0 " + model + "\n";
}

/// What the models of a text are cut into, joined by '|'.
std::string cutOf(const std::string& text) {
    const MmcifModelTexts texts = mmcifModelTexts(text);
    std::string models;
    for (const std::string_view rows : texts.models) models += std::string(rows) + "|";
    return models;
}

TEST(ModelsOfMmcif, AreCutWhereTheirNumberChanges) {
    const std::string first = rowsOf("3", "1"), second = rowsOf("8", "2");
    const std::string text = kHead + first + second + kTail;
    EXPECT_EQ(cutOf(text), first + "|" + second + "|");
    const MmcifModelTexts texts = mmcifModelTexts(text);
    EXPECT_EQ(texts.before, kHead);
    EXPECT_EQ(texts.after, kTail);
    EXPECT_EQ(cutOf(kHead + first + "ATOM C 1 2 3\n8\n"), "");  // a row of two lines
    EXPECT_EQ(cutOf(kHead + first + ";C\n; 1 2 3 4 5\n"), "");
    EXPECT_EQ(cutOf("data_x\n_atom_site.Cartn_x 1\n"), "");
    EXPECT_EQ(cutOf("data_x\nloop_\n_atom_site.Cartn_x\n1\n"), "");
    EXPECT_EQ(cutOf(""), "");
}

TEST(ModelsOfMmcif, AreTheSameHoweverTheFileIsWritten) {
    const std::string first = rowsOf("3", "1"), second = rowsOf("8", "2"), third = rowsOf("9", "3");
    const std::string usual = kHead + first + second + third + kTail;
    // Models that take turns, rows over two lines, and what looks like the table in a text of several lines.
    const std::string turns = kHead + first + second + third + first + kTail;
    std::string broken = usual, quoted = usual;
    broken.insert(broken.find("1.2 0 9"), "\n");
    quoted.insert(7, "_x.y\n;\nloop_\n_atom_site.pdbx_PDB_model_num\n1\n2\n3\n;\n#\n");
    for (const std::string& text : {usual, turns, broken, quoted}) {
        const Molecule all = readMolecule("three.cif", text, model(kAllModels));
        std::size_t atom = 0;
        for (int number = 1; number <= 3; ++number) {
            const Molecule one = readMolecule("three.cif", text, model(number));
            ASSERT_LE(atom + one.atoms.size(), all.atoms.size());
            for (const Atom& a : one.atoms) {
                const Atom& b = all.atoms[atom++];
                EXPECT_EQ(b.position, a.position);
                EXPECT_EQ(b.name, a.name);
                EXPECT_EQ(all.chains[all.residues[b.residue].chain].model, number);
            }
        }
        EXPECT_EQ(atom, all.atoms.size()) << text;
        EXPECT_EQ(all.file.models, 3);
    }
}

TEST(AllModels, AreToldAsTheyAreRead) {
    const std::string mmcif = kHead + rowsOf("1", "1") + rowsOf("2", "2") + rowsOf("3", "3") + rowsOf("4", "4") + kTail;
    const std::string frame = "1\n\nHe 0 0 0\n";
    for (const auto& [name, text] :
         {std::pair("four.cif", mmcif), std::pair("four.xyz", frame + frame + frame + frame)}) {
        std::vector<double> shares;
        ReadOptions options = model(kAllModels);
        options.onModel = [&](double share) { shares.push_back(share); };
        readMolecule(name, text, options);
        EXPECT_EQ(shares, (std::vector{0.25, 0.5, 0.75, 1.0})) << name;
    }
}

TEST(ModelsOfMmcif, KeepTheirLinesInErrors) {
    const std::string text = kHead + rowsOf("1", "1") + rowsOf("2", "far") + kTail;
    test::expectError("two.cif", text, {"line 14", "Cartn_x of row 3", "'far'"}, model(kAllModels));
}

TEST(AllModels, ThatWouldTakeForeverAreRefused) {
    std::string frames;
    for (int i = 0; i < 100'000; ++i) frames += "1\n\nHe 0 0 0\n";
    test::expectError("many.xyz", frames, {"too many models for --model all"}, model(kAllModels));
}

}  // namespace
}  // namespace nacre
