// Topologies, simulation boxes and further formats of coordinates, by hand-counted numbers.
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "engine/molecule/trajectory/trajectory.h"
#include "tests/molecule/expect_error.h"
#include "tests/molecule/gsd_writer.h"
#include "tests/support/temporary_folder.h"

namespace nacre {
namespace {

std::string seedPath(const char* file) { return std::string(NACRE_SOURCE_DIR "/tests/fuzz/seeds/") + file; }

Molecule seed(const char* file, int model = 1) { return readMoleculeFile(seedPath(file), {.model = model}); }

/// Oxygen bonded to two hydrogens, 0.96 Å apart.
void expectWater(const Molecule& water, const char* format) {
    SCOPED_TRACE(format);
    EXPECT_EQ(water.file.format, format);
    ASSERT_EQ(water.atoms.size(), 3u);
    std::size_t oxygen = 0;
    while (oxygen < 2 && water.atoms[oxygen].element != 8) ++oxygen;
    ASSERT_EQ(water.bonds.size(), 2u);
    for (const Bond& bond : water.bonds) {
        EXPECT_TRUE(bond.a == oxygen || bond.b == oxygen);
        EXPECT_EQ(water.atoms[bond.a == oxygen ? bond.b : bond.a].element, 1);
        if (!water.lacksPositions) {
            EXPECT_NEAR(glm::distance(water.atoms[bond.a].position, water.atoms[bond.b].position), 0.96, 1e-2);
        }
    }
}

TEST(Topologies, Psf) {
    const Molecule water = seed("water.psf");
    expectWater(water, "psf");
    EXPECT_TRUE(water.lacksPositions);
    EXPECT_EQ(water.partialCharges, (std::vector<float>{-0.834f, 0.417f, 0.417f}));
    EXPECT_EQ(water.masses, (std::vector<float>{15.9994f, 1.008f, 1.008f}));
    EXPECT_EQ(water.types[1].view(), "HT");
    EXPECT_EQ(water.residues[0].name.view(), "TIP3");
    EXPECT_EQ(water.residues[0].segment.view(), "WAT");
    EXPECT_EQ(water.file.title, "* WATER");
}

TEST(Topologies, PsfByColumnsWithoutSegment) {
    const Molecule one =
        readMolecule("a.psf",
                     "PSF\n\n       1 !NATOM\n       1      1    ALA  CA   CT1    0.070000       12.0110"
                     "           0\n");
    EXPECT_EQ(one.atoms[0].name.view(), "CA");
    EXPECT_EQ(one.residues[0].name.view(), "ALA");
    EXPECT_EQ(one.atoms[0].element, 6);
}

TEST(Topologies, Prmtop) {
    const Molecule water = seed("water.prmtop");
    expectWater(water, "prmtop");
    EXPECT_NEAR(water.partialCharges[0], -0.834, 1e-5);
    EXPECT_EQ(water.types[0].view(), "OW");
    EXPECT_EQ(water.residues[0].name.view(), "WAT");
    ASSERT_TRUE(water.file.box.has_value());
    EXPECT_NEAR((*water.file.box)[2].z, 20, 1e-4);
}

TEST(Topologies, CoordinatesOfAmberAreATrajectory) {
    const auto frames = openTrajectory(seedPath("water.inpcrd"));
    EXPECT_EQ(frames->atoms(), 3u);
    EXPECT_EQ(frames->frames(), 1u);
    const TrajectoryFrame frame = frames->read(0);
    EXPECT_FLOAT_EQ(frame.positions[2].y, 0.93f);
    ASSERT_TRUE(frame.box.has_value());
    EXPECT_NEAR((*frame.box)[1].y, 19, 1e-4);
}

TEST(Topologies, VelocitiesAreNoBox) {
    // Two atoms and velocities: the third line is not a box.
    const std::string text =
        "two\n    2\n   0.0000000   0.0000000   0.0000000   1.0000000   0.0000000   0.0000000\n"
        "   0.1000000   0.1000000   0.1000000   0.1000000   0.1000000   0.1000000\n"
        "  18.0000000  19.0000000  20.0000000  90.0000000  90.0000000  90.0000000\n";
    const Molecule two = readMolecule("a.rst7", text);
    ASSERT_TRUE(two.file.box.has_value());
    EXPECT_NEAR((*two.file.box)[0].x, 18, 1e-4);
}

TEST(Topologies, LammpsData) {
    const Molecule water = seed("water.data");
    expectWater(water, "lammps");
    EXPECT_EQ(water.types[1].view(), "2");
    EXPECT_EQ(water.atoms[0].name.view(), "OW") << "sorted by number";
    EXPECT_FLOAT_EQ(water.partialCharges[0], -0.834f);
    EXPECT_EQ(water.file.box, (std::array{glm::vec3(10, 0, 0), glm::vec3(1, 11, 0), glm::vec3(0, 0, 12)}));
    EXPECT_EQ(water.file.boxOrigin, glm::vec3(0));
    std::string text = test::readContents(seedPath("water.data"));
    const std::size_t low = text.find("0.0 10.0 xlo");
    ASSERT_NE(low, std::string::npos);
    const Molecule shifted = readMolecule("a.data", text.replace(low, 12, "-5.0 5.0 xlo"));
    EXPECT_EQ(shifted.file.box, water.file.box);
    EXPECT_EQ(shifted.file.boxOrigin, glm::vec3(-5, 0, 0));
}

/// One frame of two atoms.
Molecule dump(const std::string& box, const std::string& columns, const std::string& rows) {
    return readMolecule("a.lammpstrj", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS " + box +
                                           "ITEM: ATOMS " + columns + "\n" + rows);
}

// LAMMPS' manual of dump: xlo_bound = xlo + min(0, xy, xz, xy + xz), and so on; xs are shares of the edges.
TEST(Topologies, LammpsPositionsInEveryForm) {
    const char* tilted = "xy xz yz pp pp ff\n-3 10 -3\n-1 20 0\n0 30 -1\n";
    const Molecule scaled = dump(tilted, "id type xs ys zs", "2 1 0.5 0.5 0.5\n1 2 0.1 0.2 0.3\n");
    EXPECT_LT(glm::distance(scaled.atoms[1].position, glm::vec3(3.5f, 9.5f, 15)), 1e-5f);
    EXPECT_EQ((*scaled.file.box)[1], glm::vec3(-3, 20, 0));
    EXPECT_EQ(scaled.file.boxRepeats, (std::array<bool, 3>{true, true, false}));
    const char* upright = "pp pp pp\n0 10\n0 20\n0 30\n";
    EXPECT_LT(glm::distance(dump(upright, "id type xsu ysu zsu", "1 1 1.5 0.5 0.5\n2 1 0 0 0\n").atoms[0].position,
                            glm::vec3(15, 10, 15)),
              1e-5f);
    EXPECT_EQ(dump(upright, "id type xu yu zu", "1 1 15 -5 5\n2 1 0 0 0\n").atoms[0].position, glm::vec3(15, -5, 5));
    const Molecule general =
        dump("abc origin pp pp pp\n10 0 0 -1\n2 20 1 -2\n1 1 30 -3\n", "id type x y z", "1 1 1 2 3\n2 1 4 5 6\n");
    EXPECT_EQ((*general.file.box)[1], glm::vec3(2, 20, 1));
    EXPECT_EQ(general.file.boxOrigin, glm::vec3(-1, -2, -3));
}

// LAMMPS' read_data: "type labels can be used in place of numeric types".
TEST(Topologies, LammpsTypesByLabels) {
    const std::string head =
        "LAMMPS\n\n2 atoms\n1 bonds\n2 atom types\n1 bond types\n\n0 10 xlo xhi\n0 10 ylo yhi\n0 10 zlo zhi\n\n"
        "Atom Type Labels\n\n1 CT\n2 OH\n\nBond Type Labels\n\n1 CT-OH\n\nMasses\n\n";
    for (const char* rest : {"1 12.011\n2 15.999\n\nAtoms # full\n\n1 1 CT -0.5 1 2 3\n2 1 OH 0.5 2.4 2 3\n",
                             "CT 12.011\nOH 15.999\n\nAtoms # full\n\n1 1 1 -0.5 1 2 3\n2 1 2 0.5 2.4 2 3\n"}) {
        const Molecule read = readMolecule("a.data", head + rest + "\nBonds\n\n1 CT-OH 1 2\n");
        ASSERT_EQ(read.atoms.size(), 2u);
        EXPECT_EQ(read.atoms[0].element, 6);
        EXPECT_EQ(read.atoms[1].element, 8);
        EXPECT_EQ(read.atoms[1].name.view(), "OH");
        EXPECT_EQ(read.types[1].view(), "OH");
        EXPECT_EQ(read.masses, (std::vector<float>{12.011f, 15.999f}));
        EXPECT_EQ(read.bonds.size(), 1u);
    }
}

TEST(Topologies, LammpsBeadsAreNoHydrogens) {
    const Molecule beads =
        readMolecule("a.data",
                     "LAMMPS\n\n3 atoms\n2 bonds\n1 atom types\n\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\n"
                     "Masses\n\n1 1.0\n\nAtoms\n\n1 1 1 0 0 0\n2 1 1 1 0 0\n3 1 1 2 0 0\n\nBonds\n\n"
                     "1 1 1 2\n2 1 2 3\n");
    EXPECT_EQ(beads.atoms[0].element, 0);
    EXPECT_FLOAT_EQ(beads.atoms[0].radius, 0.5f);
    EXPECT_EQ(beads.bonds.size(), 2u);
}

TEST(Topologies, LammpsDumpIsSortedById) {
    for (int model = 1; model <= 2; ++model) {
        const Molecule beads = seed("beads.lammpstrj", model);
        EXPECT_EQ(beads.file.models, 2);
        ASSERT_EQ(beads.atoms.size(), 3u);
        const float first = model == 1 ? 1.0f : 1.5f;
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(beads.atoms[i].position.x, first + static_cast<float>(i), 1e-5);
        EXPECT_EQ(beads.types[0].view(), "2");
        EXPECT_GT(beads.atoms[0].radius, 0);
    }
    const auto frames = openTrajectory(seedPath("beads.lammpstrj"));
    ASSERT_EQ(frames->frames(), 2u);
    EXPECT_NEAR(frames->read(1).positions[2].x, 3.5, 1e-5);
}

TEST(Topologies, Poscar) {
    const Molecule salt = seed("salt.poscar");
    EXPECT_EQ(salt.file.format, "poscar");
    EXPECT_EQ(salt.atoms[1].element, 17);
    EXPECT_LT(glm::distance(salt.atoms[1].position, glm::vec3(2.82f)), 1e-5f);
    const std::string cartesian = "Fe O\n2.0\n1 0 0\n0 1 0\n0 0 1\n1 1\nCartesian\n0 0 0\n.5 .5 .5\n";
    const Molecule old = readMolecule("POSCAR", cartesian);
    EXPECT_EQ(old.atoms[0].element, 26) << "symbols in the title";
    EXPECT_EQ(old.atoms[1].position, glm::vec3(1)) << "scaled";
    const Molecule volume = readMolecule("POSCAR", "a\n-27\n1 0 0\n0 1 0\n0 0 1\nC\n1\nDirect\n1 0 0\n");
    EXPECT_NEAR(volume.atoms[0].position.x, 3, 1e-5);
    const std::string twice =
        "a\n1\n4 0 0\n0 4 0\n0 0 4\nC\n1\nDirect configuration= 1\n0 0 0\nDirect configuration= 2\n.5 0 0\n";
    const Molecule moved = readMolecule("XDATCAR", twice, {.model = 2});
    EXPECT_EQ(moved.file.models, 2);
    EXPECT_FLOAT_EQ(moved.atoms[0].position.x, 2);
}

TEST(Topologies, Xsf) {
    const Molecule water = seed("water.xsf");
    expectWater(water, "xsf");
    EXPECT_TRUE(water.file.box.has_value());
    const Molecule second =
        readMolecule("a.axsf", "ANIMSTEPS 2\nATOMS 1\nC 0 0 0\nATOMS 2\nC 1 0 0 0.1 0.1 0.1\n", {.model = 2});
    EXPECT_EQ(second.file.models, 2);
    EXPECT_FLOAT_EQ(second.atoms[0].position.x, 1);
}

TEST(Topologies, TinkerXyz) {
    expectWater(seed("water.txyz"), "tinker");
    const std::string boxed = "1 a\n10.0 11.0 12.0 90.0 90.0 90.0\n1 Na+ 1 2 3 7\n";
    const Molecule ion = readMolecule("a.arc", boxed + boxed);
    EXPECT_EQ(ion.file.models, 2);
    EXPECT_EQ(ion.atoms[0].element, 11);
    EXPECT_TRUE(ion.file.box.has_value());
}

TEST(Topologies, Maestro) {
    const Molecule water = seed("water.mae");
    expectWater(water, "mae");
    EXPECT_EQ(water.file.title, "water");
    EXPECT_EQ(water.residues[0].number, 7);
    EXPECT_EQ(water.atoms[1].name.view(), "H1");
}

TEST(Topologies, Gsd) {
    for (const bool packed : {false, true}) {
        const std::string bytes = test::gsdBytes(packed);
        const Molecule chain = readMolecule("a.gsd", bytes);
        EXPECT_EQ(chain.file.format, "gsd");
        EXPECT_EQ(chain.file.models, 2);
        ASSERT_EQ(chain.atoms.size(), 3u);
        EXPECT_EQ(chain.atoms[0].element, 0) << "no boron, no carbon";
        EXPECT_EQ(chain.atoms[1].name.view(), "C");
        EXPECT_FLOAT_EQ(chain.atoms[1].radius, 1);
        EXPECT_EQ(chain.bonds.size(), 2u);
        EXPECT_FLOAT_EQ((*chain.file.box)[1].x, 1);
        EXPECT_EQ(chain.file.boxOrigin, glm::vec3(-5.5f, -5, -5)) << "about the origin";
        EXPECT_FLOAT_EQ(readMolecule("a.gsd", bytes, {.model = 2}).atoms[2].position.z, 1);
        for (std::size_t cut = 0; cut < bytes.size(); cut += 7) {
            try {
                readMolecule("a.gsd", bytes.substr(0, cut), {.format = Format::gsd});
            } catch (const Error& error) {
                test::expectCleanMessage(error.what());
            }
        }
    }
}

TEST(Topologies, BytesOfGsdAreNotLineEnds) {
    // 13 and 10 are '\r' and '\n': a bond of atom 13 once became one of atom 10.
    std::string bytes = test::gsdBytes(false);
    const std::string zeros(4, '\0'), carriage = std::string("\r\r\r?");
    const std::size_t first = 256;  // behind the header: x of the first particle
    ASSERT_EQ(bytes.substr(first, 4), zeros);
    bytes.replace(first, 4, carriage);
    float expected = 0;
    std::memcpy(&expected, carriage.data(), sizeof expected);
    EXPECT_EQ(readMolecule("a.gsd", bytes).atoms[0].position.x, expected);
}

TEST(Topologies, HeadersThatAnnounceMoreThanTheFileHolds) {
    test::expectError("a.psf", "PSF\n\n 999999999 !NATOM\n", {"it ends after 0 of 999999999 atoms"});
    test::expectError("a.inpcrd",
                      "a\n999999\n   0.0000000   0.0000000   0.0000000   0.0000000   0.0000000   0.0000000\n",
                      {"expected a number of atoms"});
    test::expectError("POSCAR", "a\n1\n4 0 0\n0 4 0\n0 0 4\nC\n999999999\nDirect\n0 0 0\n",
                      {"expected numbers of atoms"});
    test::expectError("a.prmtop",
                      "%VERSION\n%FLAG POINTERS\n%FORMAT(10I8)\n999999999\n%FLAG ATOM_NAME\n%FORMAT(20a4)\nC\n",
                      {"more than 50000000 atoms"});
    test::expectError("a.prmtop",
                      "%VERSION\n%FLAG POINTERS\n%FORMAT(10I8)\n 9999999\n%FLAG ATOM_NAME\n%FORMAT(20a4)\nC\n",
                      {"its sections do not describe 9999999 atoms"});
    test::expectError("a.lammpstrj",
                      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n999999999\nITEM: ATOMS id x y z\n1 0 0 0\n",
                      {"(line 4)", "it states 999999999 atoms"});
    test::expectError("a.data", "LAMMPS\n\n999999999 atoms\n\nAtoms # atomic\n\n", {"it has no atoms"});
    test::expectError("a.txyz", "999999999 a\n1 C 0 0 0 1\n", {"it states 999999999 atoms"});
    test::expectError("a.xsf", "PRIMVEC\n9 0 0\n0 9 0\n0 0 9\nPRIMCOORD\n999999999 1\nC 0 0 0\n",
                      {"it states 999999999 atoms and has 1"});
    test::expectError("a.mae", "f_m_ct {\n s_m_title\n :::\n a\n m_atom[999999999] {\n  r_m_x_coord\n  :::\n",
                      {"it ends within a block"});
    std::string bytes = test::gsdBytes(false);
    const std::uint64_t many = ~std::uint64_t{0} / 2;
    std::memcpy(bytes.data() + 16, &many, sizeof many);
    test::expectError("a.gsd", bytes, {"it lists more than it holds"});
}

TEST(Topologies, GsdWithChunksOfNoRows) {
    std::string bytes = test::gsdBytes(false);
    std::uint64_t index = 0;
    std::memcpy(&index, bytes.data() + 8, sizeof index);
    constexpr std::size_t kEntry = 32, kBondChunk = 4, kRows = 8;
    std::memset(bytes.data() + index + kBondChunk * kEntry + kRows, 0, sizeof(std::uint64_t));
    const Molecule chain = readMolecule("a.gsd", bytes);
    EXPECT_EQ(chain.atoms.size(), 3u);
    EXPECT_TRUE(chain.bonds.empty());
}

/// Two frames in a format's own way; the second has its atom at x = 2.
const std::pair<const char*, const char*> kTwoFrames[] = {
    {"a.arc", "1 a\n1 C 1 0 0 1\n1 a\n1 C 2 0 0 1\n"},
    {"boxed.arc", "1 a\n9 9 9 90 90 90\n1 C 1 0 0 1\n1 a\n8 8 8 90 90 90\n1 C 2 0 0 1\n"},
    {"a.axsf",
     "ANIMSTEPS 2\nCRYSTAL\nPRIMVEC\n9 0 0\n0 9 0\n0 0 9\nPRIMCOORD 1\n1 1\nC 1 0 0\nPRIMCOORD 2\n1 1\nC 2 0 0\n"},
    {"boxed.axsf",
     "ANIMSTEPS 2\nCRYSTAL\nPRIMVEC 1\n9 0 0\n0 9 0\n0 0 9\nPRIMCOORD 1\n1 1\nC 1 0 0\n"
     "PRIMVEC 2\n8 0 0\n0 8 0\n0 0 8\nPRIMCOORD 2\n1 1\nC 2 0 0\n"},
    {"molecule.axsf", "ANIMSTEPS 2\nATOMS 1\nC 1 0 0\nATOMS 2\nC 2 0 0\n"},
    {"XDATCAR",
     "a\n1\n9 0 0\n0 9 0\n0 0 9\nC\n1\nDirect configuration= 1\n.11111111 0 0\n"
     "Direct configuration= 2\n.22222222 0 0\n"},
    {"boxed.XDATCAR",
     "a\n1\n9 0 0\n0 9 0\n0 0 9\nC\n1\nDirect configuration= 1\n.11111111 0 0\n"
     "a\n1\n8 0 0\n0 8 0\n0 0 8\nC\n1\nDirect configuration= 2\n.25 0 0\n"},
    {"a.mae",
     "f_m_ct {\n s_m_title\n :::\n a\n m_atom[1] {\n  i_m_atomic_number\n  r_m_x_coord\n  r_m_y_coord\n"
     "  r_m_z_coord\n  :::\n  1 6 1 0 0\n  :::\n }\n}\nf_m_ct {\n s_m_title\n :::\n a\n m_atom[1] {\n"
     "  i_m_atomic_number\n  r_m_x_coord\n  r_m_y_coord\n  r_m_z_coord\n  :::\n  1 6 2 0 0\n  :::\n }\n}\n"},
    {"a.lammpstrj",
     "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n"
     "ITEM: ATOMS id type x y z\n1 1 1 0 0\nITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n1\n"
     "ITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\nITEM: ATOMS id type x y z\n1 1 2 0 0\n"},
    {"a.extxyz", "1\nLattice=\"9 0 0 0 9 0 0 0 9\"\nC 1 0 0\n1\nLattice=\"9 0 0 0 9 0 0 0 9\"\nC 2 0 0\n"},
};

TEST(Topologies, FramesAreTrajectories) {
    for (const auto& [name, text] : kTwoFrames) {
        SCOPED_TRACE(name);
        const test::TemporaryFolder folder;
        const std::string path = folder / name;
        std::ofstream(path) << text;
        const auto frames = openTrajectory(path);
        ASSERT_EQ(frames->frames(), 2u);
        EXPECT_NEAR(frames->read(0).positions[0].x, 1, 1e-5);
        EXPECT_NEAR(frames->read(1).positions[0].x, 2, 1e-5);
        ReadOptions second{.model = 2};
        const Molecule own = readMoleculeFile(path, second);
        if (std::string_view(name).starts_with("boxed")) {
            ASSERT_TRUE(own.file.box.has_value());
            EXPECT_FLOAT_EQ((*own.file.box)[0].x, 8) << "the frame's own box";
        }
        second.heldText = 50;  // read by pieces of the file
        EXPECT_EQ(readMoleculeFile(path, second).atoms[0].position, own.atoms[0].position);
    }
}

TEST(Topologies, LongTrajectoriesAreReadFrameByFrame) {
    // Whole passes over such a file for each of its frames would be refused.
    std::string text = "a\n1\n9 0 0\n0 9 0\n0 0 9\nC\n1\n";
    constexpr std::size_t kFrames = 20'000;
    for (std::size_t i = 0; i < kFrames; ++i) text += "Direct configuration= 1\n.5 .5 .5\n";
    const test::TemporaryFolder folder;
    std::ofstream(folder / "XDATCAR") << text;
    EXPECT_EQ(openTrajectory(folder / "XDATCAR")->frames(), kFrames);
}

TEST(Topologies, RunInputsOfGromacsNameTheProgramThatReadsThem) {
    const std::string head("\0\0\0\x0d\0\0\0\x0cVERSION 4.0\0\0\0\0\4", 25);
    test::expectError("topol.tpr", head + std::string(100, '\0'), {"it is a GROMACS run input", "gmx editconf"});
    for (const std::string& magic : {std::string("CDF\1"), std::string("\x54\0\0\0CORD", 8),
                                     std::string("\0\0\x07\xc9", 4), std::string("\0\0\x07\xcb", 4)})
        test::expectError("a.rst7", magic + std::string(100, '\0'), {"it is a trajectory", "--trajectory"});
}

TEST(Topologies, AreTrajectoriesOnlyWithPositions) {
    EXPECT_THROW(openTrajectory(seedPath("water.psf")), Error);
    EXPECT_EQ(openTrajectory(seedPath("salt.poscar"))->atoms(), 2u);
}

}  // namespace
}  // namespace nacre
