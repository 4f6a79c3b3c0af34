// Topologies, simulation boxes and further formats of coordinates, by hand-counted numbers.
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "engine/molecule/element.h"
#include "engine/molecule/trajectory/trajectory.h"
#include "tests/molecule/expect_error.h"
#include "tests/molecule/text_file.h"

namespace nacre {
namespace {

std::string seedOf(const char* file) { return std::string(NACRE_SOURCE_DIR "/tests/fuzz/seeds/") + file; }

Molecule seed(const char* file, int model = 1) {
    ReadOptions options;
    options.model = model;
    return readMoleculeFile(seedOf(file), options);
}

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
    const auto frames = openTrajectory(seedOf("water.inpcrd"));
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
    const auto frames = openTrajectory(seedOf("beads.lammpstrj"));
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
    ReadOptions second;
    second.model = 2;
    const Molecule moved = readMolecule("XDATCAR", twice, second);
    EXPECT_EQ(moved.file.models, 2);
    EXPECT_FLOAT_EQ(moved.atoms[0].position.x, 2);
}

TEST(Topologies, Xsf) {
    const Molecule water = seed("water.xsf");
    expectWater(water, "xsf");
    EXPECT_TRUE(water.file.box.has_value());
    const Molecule second = [] {
        ReadOptions options;
        options.model = 2;
        return readMolecule("a.axsf", "ANIMSTEPS 2\nATOMS 1\nC 0 0 0\nATOMS 2\nC 1 0 0 0.1 0.1 0.1\n", options);
    }();
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

/// As the format's page describes it: version 1 has names of 64 bytes each, version 2 one after the other.
std::string gsdBytes(bool packed) {
    std::string body, index, names;
    std::uint16_t count = 0;
    const auto number = [](auto value) { return std::string(reinterpret_cast<const char*>(&value), sizeof value); };
    const auto chunk = [&](std::uint64_t frame, std::uint16_t id, std::uint64_t rows, std::uint32_t columns,
                           std::uint8_t type, const std::string& bytes) {
        index += number(frame) + number(rows) + number(std::int64_t{256} + static_cast<std::int64_t>(body.size())) +
                 number(columns) + number(id) + number(type) + number(std::uint8_t{0});
        body += bytes;
    };
    const auto named = [&](const std::string& name) {
        names += name + (packed ? std::string(1, '\0') : std::string(64 - name.size(), '\0'));
        return count++;
    };
    const auto floats = [&](std::initializer_list<float> values) {
        std::string bytes;
        for (const float value : values) bytes += number(value);
        return bytes;
    };
    const auto wholes = [&](std::initializer_list<std::uint32_t> values) {
        std::string bytes;
        for (const std::uint32_t value : values) bytes += number(value);
        return bytes;
    };
    const std::uint16_t positions = named("particles/position");
    chunk(0, positions, 3, 3, 9, floats({0, 0, 0, 1, 0, 0, 2, 0, 0}));
    chunk(0, named("particles/types"), 2, 2, 5, std::string("B\0C\0", 4));
    chunk(0, named("particles/typeid"), 3, 1, 3, wholes({0, 1, 0}));
    chunk(0, named("particles/diameter"), 3, 1, 9, floats({1, 2, 1}));
    chunk(0, named("bonds/group"), 2, 2, 3, wholes({0, 1, 1, 2}));
    chunk(0, named("configuration/box"), 6, 1, 9, floats({10, 10, 10, 0.1f, 0, 0}));
    chunk(1, positions, 3, 3, 9, floats({0, 0, 1, 1, 0, 1, 2, 0, 1}));
    const std::uint64_t entries = index.size() / 32;
    names += std::string((64 - names.size() % 64) % 64, '\0');
    std::string header = number(std::uint64_t{0x65DF65DF65DF65DF}) + number(std::uint64_t{256 + body.size()}) +
                         number(entries) + number(std::uint64_t{256 + body.size() + index.size()}) +
                         number(std::uint64_t{names.size() / 64}) + number(std::uint32_t{0x10004}) +
                         number(std::uint32_t{packed ? 0x20000u : 0x10000u});
    header.resize(256);
    return header + body + index + names;
}

TEST(Topologies, Gsd) {
    for (const bool packed : {false, true}) {
        const std::string bytes = gsdBytes(packed);
        const Molecule chain = readMolecule("a.gsd", bytes);
        EXPECT_EQ(chain.file.format, "gsd");
        EXPECT_EQ(chain.file.models, 2);
        ASSERT_EQ(chain.atoms.size(), 3u);
        EXPECT_EQ(chain.atoms[0].element, 0) << "no boron, no carbon";
        EXPECT_EQ(chain.atoms[1].name.view(), "C");
        EXPECT_FLOAT_EQ(chain.atoms[1].radius, 1);
        EXPECT_EQ(chain.bonds.size(), 2u);
        EXPECT_FLOAT_EQ((*chain.file.box)[1].x, 1);
        ReadOptions second;
        second.model = 2;
        EXPECT_FLOAT_EQ(readMolecule("a.gsd", bytes, second).atoms[2].position.z, 1);
        for (std::size_t cut = 0; cut < bytes.size(); cut += 7) {
            try {
                readMolecule("a.gsd", bytes.substr(0, cut), {.format = Format::gsd});
            } catch (const Error& error) {
                test::expectCleanMessage(error.what());
            }
        }
    }
}

TEST(Topologies, HeadersThatAnnounceMoreThanTheFileHolds) {
    test::expectError("a.psf", "PSF\n\n 999999999 !NATOM\n", {"it ends after 0 of 999999999 atoms"});
    test::expectError("a.inpcrd",
                      "a\n999999\n   0.0000000   0.0000000   0.0000000   0.0000000   0.0000000   0.0000000\n",
                      {"expected a number of atoms"});
    test::expectError("POSCAR", "a\n1\n4 0 0\n0 4 0\n0 0 4\nC\n999999999\nDirect\n0 0 0\n",
                      {"expected numbers of atoms"});
    std::string bytes = gsdBytes(false);
    const std::uint64_t many = ~std::uint64_t{0} / 2;
    std::memcpy(bytes.data() + 16, &many, sizeof many);
    test::expectError("a.gsd", bytes, {"it lists more than it holds"});
}

TEST(Topologies, GsdWithChunksOfNoRows) {
    std::string bytes = gsdBytes(false);
    std::uint64_t index = 0;
    std::memcpy(&index, bytes.data() + 8, sizeof index);
    constexpr std::size_t kEntry = 32, kBonds = 4, kRows = 8;
    std::memset(bytes.data() + index + kBonds * kEntry + kRows, 0, sizeof(std::uint64_t));
    const Molecule chain = readMolecule("a.gsd", bytes);
    EXPECT_EQ(chain.atoms.size(), 3u);
    EXPECT_TRUE(chain.bonds.empty());
}

TEST(Topologies, AreTrajectoriesOnlyWithPositions) {
    EXPECT_THROW(openTrajectory(seedOf("water.psf")), Error);
    EXPECT_EQ(openTrajectory(seedOf("salt.poscar"))->atoms(), 2u);
}

}  // namespace
}  // namespace nacre
