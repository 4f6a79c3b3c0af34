// --model all: every model of a file, one over the other.

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/formats/model_spans.h"
#include "engine/molecule/other_models.h"
#include "engine/molecule/read.h"
#include "engine/molecule/selection/selection.h"
#include "tests/molecule/expect_error.h"
#include "tests/support/test_data.h"
#include "tests/support/written_files.h"

namespace nacre {
namespace {

ReadOptions model(int number) {
    ReadOptions options{.model = number};
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

std::string makeRows(const std::string& model, const std::string& x) {
    return "ATOM \"O5'\" " + x + " 0 0 " + model + " \nATOM 'C 5'  " + x + " 1.2 0 " + model + "\n";
}

/// What a text is cut into, parts divided by '|': before, models, after.
std::string describeSpans(Format format, const std::string& text) {
    const TextSource source = textInMemory(text);
    const ModelSpans spans = modelSpans(format, source);
    std::string parts;
    appendText(parts, source, spans.before);
    for (const TextSpan& model : spans.models) appendText(parts += "|", source, model);
    appendText(parts += "|", source, spans.after);
    return parts;
}

constexpr const char* kAtom = "ATOM      1  CA  GLY A   1       1.000   2.000   3.000  1.00  0.00           C\n";

TEST(ModelSpans, OfPdbEndAtEndmdl) {
    const std::string atom = kAtom, one = "MODEL 1\n" + atom + "ENDMDL\n", two = "MODEL 2\n" + atom + "ENDMDL\n";
    for (const Format format : {Format::pdb, Format::pdbqt, Format::pqr}) {
        EXPECT_EQ(describeSpans(format, "TITLE x\n" + one + two + "CONECT    1    2\nEND\n"),
                  "TITLE x\n|" + one + "|" + two + "|CONECT    1    2\nEND\n");
        EXPECT_EQ(describeSpans(format, one + "MODEL 7\nENDMDL\n" + two),
                  "|" + one + "|" + two + "|");  // none has no atoms
        EXPECT_EQ(describeSpans(format, one + "\n" + two), "|" + one + "|" + two + "|");
        EXPECT_EQ(describeSpans(format, atom + one), "|");        // who is first
        EXPECT_EQ(describeSpans(format, one + atom + two), "|");  // and whose is this
        EXPECT_EQ(describeSpans(format, one + "TER\n" + two), "|");
        EXPECT_EQ(describeSpans(format, "MODEL 1\n" + atom + two), "|");  // never ended
        EXPECT_EQ(describeSpans(format, ""), "|");
    }
}

TEST(ModelSpans, OfPdbEndAtEnd) {
    const std::string frame = std::string(kAtom) + "END\n";
    EXPECT_EQ(describeSpans(Format::pdb, "CRYST1\n" + frame + frame), "CRYST1\n|" + frame + "|" + frame + "|");
    EXPECT_EQ(describeSpans(Format::pdb, frame + "HELIX 1\n" + frame), "|");
    EXPECT_EQ(describeSpans(Format::pdb, frame + "CONECT    1    2\n" + frame), "|");
}

TEST(ModelSpans, OfFramesGoByTheirCounts) {
    const std::string xyz = "1\nno atom\nHe 0 0 0\n", gro = "title\n1\n    1GLY     CA    1   0.1   0.2   0.3\n1 1 1\n";
    EXPECT_EQ(describeSpans(Format::xyz, xyz + "\n" + xyz), "|" + xyz + "|\n" + xyz + "|");
    EXPECT_EQ(describeSpans(Format::xyz, xyz + "2\n\nHe 0 0 0\n"), "|" + xyz + "|");
    EXPECT_EQ(describeSpans(Format::xyz, xyz + "99999999999999999999\n\n"), "|" + xyz + "|");
    EXPECT_EQ(describeSpans(Format::gro, gro + gro), "|" + gro + "|" + gro + "|");
    EXPECT_EQ(describeSpans(Format::gro, gro + "title\nmany\n"), "|" + gro + "|");
}

TEST(ModelSpans, OfMmcifGoByTheNumbersOfModels) {
    const std::string one = makeRows("1", "1.0"), two = makeRows("2", "2.0"), head = kHead;
    EXPECT_EQ(describeSpans(Format::mmcif, head + one + two + kTail), head + "|" + one + "|" + two + "|" + kTail);
    EXPECT_EQ(describeSpans(Format::mmcif, head + one + two + "loop_\n_x.y\n1\n"),
              head + "|" + one + "|" + two + "|loop_\n_x.y\n1\n");
    EXPECT_EQ(describeSpans(Format::mmcif, head + one + two + one), "|");                  // models that come again
    EXPECT_EQ(describeSpans(Format::mmcif, head + one + "ATOM C1\n 1 0 0 2\n"), "|");      // a row on two lines
    EXPECT_EQ(describeSpans(Format::mmcif, head + one + "ATOM 'C 1 0 0 0 2\n"), "|");      // a quote that does not end
    EXPECT_EQ(describeSpans(Format::mmcif, head + one + two + kTail + head + one), "|");   // two blocks
    EXPECT_EQ(describeSpans(Format::mmcif, "data_x\nloop_\n_atom_site.id\n1\n2\n"), "|");  // no numbers
}

TEST(ModelSpans, OfRecordsGoByTheirMarks) {
    EXPECT_EQ(describeSpans(Format::sdf, "a\n$$$$\nb\n$$$$\n\n"), "|a\n$$$$\n|b\n$$$$\n|");
    const std::string record = "@<TRIPOS>MOLECULE\nx\n";
    EXPECT_EQ(describeSpans(Format::mol2, "# made by\n" + record + record), "|" + record + "|" + record + "|");
}

TEST(AllModels, OfTheLineFormatsAreTheSameHoweverTheyAreRead) {
    // Each model from its own text, or from the whole where that cannot be cut: a line that breaks the cut.
    const auto pdb = [](const std::string& between) {
        std::string text = "HELIX    1   1 GLY A    1  GLY A    1  1                                   1\n";
        for (int i = 1; i <= 3; ++i) {
            std::string atom = kAtom;
            atom.replace(35, 1, std::to_string(i));
            text += "MODEL        " + std::to_string(i) + "\n" + atom + "ENDMDL\n" + between;
        }
        return text + "END\n";
    };
    const Molecule cut = readMolecule("three.pdb", pdb(""), model(kAllModels));
    const Molecule whole = readMolecule("three.pdb", pdb("TER\n"), model(kAllModels));
    ASSERT_EQ(cut.atoms.size(), 3u);
    ASSERT_EQ(whole.atoms.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(cut.atoms[i].position, whole.atoms[i].position);
        EXPECT_EQ(cut.residues[i].secondary, SecondaryStructure::helix);
        EXPECT_EQ(whole.residues[i].secondary, SecondaryStructure::helix);
        EXPECT_EQ(cut.chains[i].model, static_cast<int>(i) + 1);
    }
}

TEST(AllModels, ThatAreToBeWarnedOfAreReadAllTheSame) {
    // Each has an element that nobody knows: the second is looked up in the whole for its line, not all hundred.
    std::string text;
    for (int i = 0; i < 100; ++i) text += "1\n\nXx 0 0 " + std::to_string(i) + "\n";
    const Molecule all = readMolecule("hundred.xyz", text, model(kAllModels));
    EXPECT_EQ(all.atoms.size(), 100u);
    ASSERT_EQ(all.warnings.size(), 2u);
    EXPECT_NE(all.warnings[1].find("line 6"), std::string::npos) << all.warnings[1];
}

TEST(ModelsOfMmcif, AreTheSameHoweverTheFileIsWritten) {
    const std::string first = makeRows("3", "1"), second = makeRows("8", "2"), third = makeRows("9", "3");
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
    const std::string mmcif =
        kHead + makeRows("1", "1") + makeRows("2", "2") + makeRows("3", "3") + makeRows("4", "4") + kTail;
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
    const std::string text = kHead + makeRows("1", "1") + makeRows("2", "far") + kTail;
    test::expectError("two.cif", text, {"line 14", "Cartn_x of row 3", "'far'"}, model(kAllModels));
}

TEST(AllModels, AreReadInOnePass) {
    std::string frames, models, records;
    for (int i = 0; i < 20'000; ++i) {
        frames += "1\n\nHe 0 0 0\n";
        models += "MODEL     " + std::to_string(i) + "\n" + kAtom + "ENDMDL\n";
    }
    EXPECT_EQ(readMolecule("many.xyz", frames, model(kAllModels)).atoms.size(), 20'000u);
    EXPECT_EQ(readMolecule("many.pdb", models, model(kAllModels)).atoms.size(), 20'000u);
}

TEST(AllModels, ThatWouldTakeForeverAreRefused) {
    std::string text;  // what cannot be cut takes a pass each
    for (int i = 0; i < 20'000; ++i) text += "MODEL     " + std::to_string(i) + "\n" + kAtom + "ENDMDL\nTER\n";
    test::expectError("many.pdb", text, {"too many models to read them all"}, model(kAllModels));
}

ReadOptions withOthers(int number) {
    ReadOptions options = model(number);
    options.others = true;
    return options;
}

TEST(OtherModels, AreWhereTheyAre) {
    std::string text;
    for (int i = 0; i < 4; ++i) text += "2\n\nHe 0 0 " + std::to_string(i) + "\nNe 5 0 " + std::to_string(i) + "\n";
    const Molecule molecule = readMolecule("four.xyz", text, withOthers(2));
    ASSERT_EQ(molecule.others.size(), 3u);
    for (const std::size_t i : {0u, 1u, 2u}) {
        ASSERT_EQ(molecule.others[i].positions.size(), 2u);
        EXPECT_EQ(molecule.others[i].positions[1], glm::vec3(5, 0, i < 1 ? i : i + 1));
    }
    EXPECT_TRUE(readMolecule("four.xyz", text, model(2)).others.empty());
    EXPECT_TRUE(readMolecule("one.xyz", "1\n\nHe 0 0 0\n", withOthers(1)).others.empty());
}

TEST(OtherModels, OfOtherAtomsAreKeptWhole) {
    const std::string text = "1\n\nHe 0 0 0\n2\n\nHe 0 0 1\nNe 0 0 2\n";
    const Molecule molecule = readMolecule("two.xyz", text, withOthers(1));
    ASSERT_EQ(molecule.others.size(), 1u);
    ASSERT_TRUE(molecule.others[0].whole);
    Molecule placed;
    place(molecule, molecule.others[0], placed);
    ASSERT_EQ(placed.atoms.size(), 2u);
    EXPECT_EQ(placed.atoms[1].element, 10);
}

std::string makeSdf(const char* element, const char* x) {
    return std::string("m\n\n\n  1  0  0  0  0  0            999 V2000\n    ") + x + "    0.0000    0.0000 " + element +
           "   0  0\nM  END\n$$$$\n";
}

TEST(OtherModels, ArePosesOfOneMoleculeAndNotOtherMolecules) {
    const std::string poses = makeSdf("C", "1.0000") + makeSdf("C", "4.0000");
    EXPECT_EQ(readMolecule("poses.sdf", poses, withOthers(1)).others.size(), 1u);
    EXPECT_TRUE(readMolecule("two.sdf", poses + makeSdf("N", "9.0000"), withOthers(1)).others.empty());
}

TEST(OtherModels, ThatCannotBeReadAreMissedAndTheModelIsRead) {
    const std::string text = "1\n\nHe 0 0 0\n1\n\nHe 0 0 far\n";
    const Molecule molecule = readMolecule("two.xyz", text, withOthers(1));
    EXPECT_EQ(molecule.atoms.size(), 1u);
    EXPECT_TRUE(molecule.others.empty());
    EXPECT_NE(molecule.othersMissing.find("far"), std::string::npos) << molecule.othersMissing;
}

TEST(OtherModels, AreNotKeptBeyondTheMemoryBound) {
    std::string text;
    for (int i = 0; i < 100; ++i) text += "2\n\nHe 0 0 0\nHe 0 0 1\n";
    ReadOptions options = withOthers(1);
    options.maxAtoms = 2;
    const Molecule molecule = readMolecule("many.xyz", text, options);  // a file has most of them
    EXPECT_EQ(molecule.atoms.size(), 2u);
    EXPECT_EQ(molecule.others.size(), 99u);
    EXPECT_EQ(molecule.others[98].positions[1], glm::vec3(0, 0, 1));
    for (int i = 0; i < 100; ++i) text += "2\n\nNe 0 0 0\nHe 0 0 1\n";  // other atoms are held
    const Molecule unlike = readMolecule("many.xyz", text, options);
    EXPECT_EQ(unlike.atoms.size(), 2u);
    EXPECT_TRUE(unlike.others.empty());
    EXPECT_NE(unlike.othersMissing, "");
}

}  // namespace
}  // namespace nacre
