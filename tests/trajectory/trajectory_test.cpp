// Trajectories as MDTraj writes them, and what MDTraj reads in them; files of our own for what it does not write; and
// what is damaged.

#include "engine/molecule/trajectory/trajectory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <glm/geometric.hpp>
#include <random>

#include "engine/error.h"
#include "engine/molecule/read.h"
#include "engine/molecule/superpose.h"
#include "tests/support/error_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/trajectory/written_trajectories.h"

namespace nacre {
namespace {

using test::readContents;
using test::readNumbers;
using test::TemporaryFolder;
using test::written;

void write(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

/// Compares a trajectory with numbers that MDTraj read; Å.
void expectSame(const std::string& file, const std::string& name, double tolerance) {
    const std::unique_ptr<Trajectory> t = openTrajectory(written() / file);
    const std::vector<float> expected = readNumbers(name);
    const std::size_t row = 9 + 3 * t->atoms();
    ASSERT_EQ(expected.size(), row * t->frames()) << file;
    EXPECT_FALSE(t->cutOff());
    for (std::size_t frame = t->frames(); frame-- > 0;) {  // in any order
        const TrajectoryFrame read = t->read(frame);
        const float* e = expected.data() + frame * row;
        ASSERT_EQ(read.box.has_value(), e[0] > 0) << file;
        for (std::size_t k = 0; read.box && k < 9; ++k)
            EXPECT_NEAR((*read.box)[k / 3][static_cast<int>(k % 3)], e[k], 1e-3) << file << frame << " " << k;
        for (std::size_t i = 0; i < 3 * t->atoms(); ++i)
            ASSERT_NEAR(read.positions[i / 3][static_cast<int>(i % 3)], e[9 + i],
                        tolerance * std::max(1.0f, std::abs(e[9 + i]) / 100))
                << file << ", frame " << frame << ", number " << i;
    }
}

TEST(Trajectory, ReadsTimes) {
    for (const char* name : {"t.xtc", "t.trr", "t.nc", "t.h5", "t.h5md"}) {
        const std::unique_ptr<Trajectory> t = openTrajectory(written() / name);
        for (std::size_t frame = 0; frame < 5; ++frame)
            EXPECT_NEAR(t->read(frame).time.value_or(-1), 10 + 2.5 * static_cast<double>(frame), 1e-5) << name;
    }
    EXPECT_FALSE(openTrajectory(written() / "t.dcd")->read(2).time) << "MDTraj leaves DCD's step at 1";
    // As CHARMM and NAMD have it: a first step, steps a frame, and a step of 2 fs in their unit of 48.888 fs.
    std::string dcd = readContents(written() / "t.dcd");
    const std::int32_t first = 1000, every = 500;
    const float step = 2 / 48.8882129f;
    std::memcpy(dcd.data() + 12, &first, 4);
    std::memcpy(dcd.data() + 16, &every, 4);
    std::memcpy(dcd.data() + 44, &step, 4);
    const TemporaryFolder folder;
    write(folder / "timed.dcd", dcd);
    EXPECT_NEAR(openTrajectory(folder / "timed.dcd")->read(3).time.value_or(-1), 5, 1e-5);
}

TEST(Trajectory, ReadsWhatMdtrajReads) {
    expectSame("t.xtc", "xtc", 1e-4);
    expectSame("t.trr", "trr", 1e-4);
    expectSame("t.dcd", "dcd", 1e-4);
    expectSame("t.nc", "nc", 1e-4);
    expectSame("t.h5", "h5", 1e-4);
    expectSame("t.h5md", "h5", 1e-4);
    expectSame("few.xtc", "few", 1e-4);
    expectSame("water.xtc", "water", 1e-3);
}

TEST(Trajectory, ARestartFileOfAmberIsOneFrame) {
    const std::unique_ptr<Trajectory> restart = openTrajectory(written() / "t.ncrst");
    EXPECT_EQ(restart->frames(), 1u);
    const TrajectoryFrame& one = restart->read(0);
    const std::unique_ptr<Trajectory> whole = openTrajectory(written() / "t.nc");
    const TrajectoryFrame& first = whole->read(0);
    ASSERT_EQ(one.positions.size(), first.positions.size());
    for (std::size_t i = 0; i < one.positions.size(); ++i)
        EXPECT_LT(glm::distance(one.positions[i], first.positions[i]), 1e-3f);
    ASSERT_TRUE(one.box.has_value());
    EXPECT_LT(glm::distance((*one.box)[1], (*first.box)[1]), 1e-3f);
    std::string bytes = readContents(written() / "t.ncrst");
    bytes.resize(bytes.size() / 2);
    const TemporaryFolder folder;
    write(folder / "cut.ncrst", bytes);
    EXPECT_THROW(openTrajectory(folder / "cut.ncrst")->read(0), Error);
}

TEST(Trajectory, SaysWhatItIs) {
    const char* const formats[][2] = {{"t.xtc", "xtc"}, {"t.trr", "trr"}, {"t.dcd", "dcd"}, {"t.nc", "netcdf"}};
    for (const auto& [file, format] : formats) {
        const std::unique_ptr<Trajectory> t = openTrajectory(written() / file);
        EXPECT_STREQ(t->format(), format);
        EXPECT_EQ(t->atoms(), 60u);
        EXPECT_EQ(t->frames(), 5u);
        EXPECT_THROW(t->read(5), Error);
    }
}

// --- files of our own

template <typename Number>
void put(std::string& bytes, Number value, bool big) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (big) std::reverse(raw, raw + sizeof value);
    bytes.append(raw, sizeof value);
}

void putRecord(std::string& bytes, const std::string& content, bool big) {
    put(bytes, static_cast<std::int32_t>(content.size()), big);
    bytes += content;
    put(bytes, static_cast<std::int32_t>(content.size()), big);
}

/// Four atoms, of which the second and the fourth are fixed; three frames; a cell of NAMD, by cosines.
std::string dcdWithFixedAtoms(bool big) {
    std::string bytes, header = "CORD";
    const std::int32_t control[20] = {0, 1, 1, 3, 0, 0, 0, 0, 2, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 24};
    for (const std::int32_t value : control) put(header, value, big);
    putRecord(bytes, header, big);
    std::string title;
    put(title, std::int32_t{1}, big);
    putRecord(bytes, title + std::string(80, ' '), big);
    std::string atoms, moving;
    put(atoms, std::int32_t{4}, big);
    putRecord(bytes, atoms, big);
    for (const std::int32_t atom : {1, 3}) put(moving, atom, big);
    putRecord(bytes, moving, big);
    for (int frame = 0; frame < 3; ++frame) {
        std::string cell;
        for (const double value : {10.0, 0.0, 20.0, 0.0, 0.0, 30.0}) put(cell, value, big);
        putRecord(bytes, cell, big);
        for (int axis = 0; axis < 3; ++axis) {
            std::string list;
            for (int atom = 0; atom < 4; ++atom)
                if (frame == 0 || atom % 2 == 0) put(list, static_cast<float>(100 * frame + 10 * atom + axis), big);
            putRecord(bytes, list, big);
        }
    }
    return bytes;
}

TEST(Trajectory, ReadsDcdOfEitherByteOrderWithFixedAtoms) {
    const TemporaryFolder folder;
    for (const bool big : {false, true}) {
        write(folder / "f.dcd", dcdWithFixedAtoms(big));
        const std::unique_ptr<Trajectory> t = openTrajectory(folder / "f.dcd");
        ASSERT_EQ(t->frames(), 3u);
        for (const std::size_t frame : {2u, 0u, 1u}) {
            const TrajectoryFrame read = t->read(frame);
            for (int atom = 0; atom < 4; ++atom) {
                const float base = static_cast<float>((atom % 2 ? 0 : 100 * static_cast<int>(frame)) + 10 * atom);
                EXPECT_EQ(read.positions[static_cast<std::size_t>(atom)], glm::vec3(base, base + 1, base + 2));
            }
            ASSERT_TRUE(read.box);
            EXPECT_LT(glm::distance((*read.box)[2], glm::vec3(0, 0, 30)), 1e-4);
        }
    }
}

TEST(Trajectory, LeavesOutAFrameThatIsCutOff) {
    const TemporaryFolder folder;
    for (const char* name : {"t.xtc", "t.trr", "t.dcd", "t.nc"}) {
        std::string bytes = readContents(written() / name);
        write(folder / name, bytes.substr(0, bytes.size() - 100));
        const std::unique_ptr<Trajectory> t = openTrajectory(folder / name);
        EXPECT_EQ(t->frames(), 4u) << name;
        EXPECT_TRUE(t->cutOff()) << name;
    }
}

/// Opens and reads everything there is. @returns whether it did
bool readsAll(const std::string& path) {
    try {
        const std::unique_ptr<Trajectory> t = openTrajectory(path);
        for (std::size_t frame = 0; frame < std::min<std::size_t>(t->frames(), 20); ++frame)
            for (const glm::vec3& p : t->read(frame).positions)
                EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        return true;
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return false;
    }
}

TEST(Trajectory, DamagedFilesAreErrorsAndNothingElse) {
    const TemporaryFolder folder;
    std::mt19937 random(5);
    for (const char* name : {"t.xtc", "t.trr", "t.dcd", "t.nc", "few.xtc"}) {
        const std::string whole = readContents(written() / name);
        for (std::size_t length = 0; length < 500; length += 7) {
            write(folder / name, whole.substr(0, length));
            readsAll(folder / name);
        }
        int refused = 0;
        for (int round = 0; round < 200; ++round) {
            std::string bytes = whole;
            for (int i = 0; i < 3; ++i) {
                const std::size_t range = round % 2 ? bytes.size() : std::min<std::size_t>(bytes.size(), 400);
                bytes[random() % range] = static_cast<char>(round % 3 ? random() : (random() % 2 ? 0xff : 0x7f));
            }
            write(folder / name, bytes);
            refused += readsAll(folder / name) ? 0 : 1;
        }
        EXPECT_GT(refused, 25) << name << ": mutations that change nothing test nothing";
    }
}

TEST(Trajectory, RefusesPositionsThatAreNone) {
    const TemporaryFolder folder;
    std::string bytes = readContents(written() / "t.dcd");
    const float nan = NAN;
    std::memcpy(bytes.data() + bytes.size() - 8, &nan, 4);  // the last of the last frame
    write(folder / "n.dcd", bytes);
    const std::unique_ptr<Trajectory> t = openTrajectory(folder / "n.dcd");
    t->read(3);
    EXPECT_THROW(t->read(4), Error);
}

TEST(Trajectory, IsToldFromOtherFiles) {
    const TemporaryFolder folder;
    write(folder / "a", "");
    write(folder / "b", "ATOM      1  N   MET A   1");
    for (const char* name : {"a", "b", "none", "."}) EXPECT_THROW(openTrajectory(folder / name), Error) << name;
}

// --- motions

// Which no quaternion is the one answer for.
TEST(Superpose, UndoesAMotionAndTakesNoMirrorImage) {
    std::vector<glm::dvec3> fixed, moving, mirrored;
    for (int i = 0; i < 9; ++i) fixed.emplace_back(i, i * i % 5, i * i * i % 7);
    const double c = std::cos(1.1), s = std::sin(1.1);
    for (const glm::dvec3& p : fixed) {
        moving.emplace_back(c * p.x - s * p.y + 3, s * p.x + c * p.y - 4, p.z + 5);
        mirrored.emplace_back(-p.x, p.y, p.z);
    }
    const Superposition onto = superpose(fixed, moving);
    EXPECT_LT(onto.rmsd, 1e-6);
    for (std::size_t i = 0; i < fixed.size(); ++i) EXPECT_LT(glm::distance(onto(moving[i]), fixed[i]), 1e-6);
    EXPECT_GT(superpose(fixed, mirrored).rmsd, 0.5);
    EXPECT_NEAR(glm::determinant(superpose(fixed, mirrored).rotation), 1, 1e-9);
}

TEST(Superpose, LaysLinesAndPointsOntoEachOther) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
    for (int trial = 0; trial < 300; ++trial) {
        // On a line, in a plane, at one place, two points; laid along another line, the opposite one, or an axis.
        const int kind = trial % 5, count = kind == 3 ? 2 : 6;
        glm::dvec3 a = glm::normalize(vector()), b = trial % 3 ? glm::normalize(vector()) : -a;
        if (trial % 7 == 0) a = {0, 1, 0};
        const glm::dvec3 at = 10.0 * vector(), to = 10.0 * vector();
        std::vector<glm::dvec3> fixed, moving;
        for (int i = 0; i < count; ++i) {
            const double along = kind == 2 ? 0.0 : i * i;
            fixed.push_back(at + along * a);
            moving.push_back(to + along * b);
            if (kind != 1) continue;
            fixed.back() += double(i % 2) * glm::normalize(glm::cross(a, glm::dvec3(0.3, 0.2, 0.9)));
            moving.back() += double(i % 2) * glm::normalize(glm::cross(b, glm::dvec3(0.1, 0.8, -0.6)));
        }
        const Superposition onto = superpose(fixed, moving);
        ASSERT_LT(onto.rmsd, 1e-5) << trial;
        for (int i = 0; i < count; ++i) ASSERT_LT(glm::distance(onto(moving[i]), fixed[i]), 1e-5) << trial;
        ASSERT_NEAR(glm::determinant(onto.rotation), 1, 1e-6) << trial;
    }
}

TEST(Superpose, LaysALineBestOntoWhatIsNone) {
    const std::vector<glm::dvec3> bent{{0, 0, 0}, {1, 0.5, 0}, {2, -0.5, 0}, {3, 0, 0}},
        line{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}};
    // By arithmetic: the best line through the bent one has the direction of sum(t p), t = -1.5, -0.5, 0.5, 1.5.
    const glm::dvec3 along = glm::normalize(-1.5 * bent[0] - 0.5 * bent[1] + 0.5 * bent[2] + 1.5 * bent[3]);
    const Superposition onto = superpose(bent, line), back = superpose(line, bent);
    EXPECT_LT(glm::distance(onto(line[3]) - onto(line[0]), 3.0 * along), 1e-9);
    EXPECT_NEAR(onto.rmsd, back.rmsd, 1e-9);
    EXPECT_NEAR(glm::determinant(back.rotation), 1, 1e-9);
}

TEST(Hdf5Structures, MdtrajStatesTheTopology) {
    const Molecule chains = readMoleculeFile(test::written() / "t.h5");
    EXPECT_EQ(chains.file.format, "h5md");
    EXPECT_EQ(chains.file.models, 5);
    ASSERT_EQ(chains.atoms.size(), 60u);
    EXPECT_EQ(chains.atoms[21].name.view(), "C2");
    EXPECT_EQ(chains.atoms[21].element, 6);
    EXPECT_EQ(chains.residues[1].name.view(), "LIG");
    ASSERT_EQ(chains.chains.size(), 3u);
    EXPECT_EQ(chains.chains[1].name, "B");
    EXPECT_EQ(chains.bonds.size(), 57u);
    EXPECT_TRUE(std::all_of(chains.bonds.begin(), chains.bonds.end(),
                            [](const Bond& bond) { return bond.source == BondSource::file; }));
    ASSERT_TRUE(chains.file.box.has_value());
    EXPECT_NEAR((*chains.file.box)[0].x, 40, 1e-4);
    const std::vector<float> numbers = test::readNumbers("h5");
    ReadOptions options;
    for (const int model : {1, 3, 5}) {
        options.model = model;
        const Molecule frame = readMoleculeFile(test::written() / "t.h5", options);
        const std::size_t first = static_cast<std::size_t>(model - 1) * (9 + 60 * 3) + 9;
        for (std::size_t i = 0; i < 60; ++i)
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(frame.atoms[i].position[axis], numbers[first + 3 * i + static_cast<std::size_t>(axis)],
                            1e-4);
    }
    options.model = 6;
    EXPECT_THROW(readMoleculeFile(test::written() / "t.h5", options), Error);
    options.model = 1;
    options.others = true;
    EXPECT_EQ(readMoleculeFile(test::written() / "t.h5", options).others.size(), 4u) << "frames to play";
}

TEST(Hdf5Structures, H5mdStatesSpecies) {
    const Molecule water = readMoleculeFile(test::written() / "water.h5md", {.model = 2});
    EXPECT_EQ(water.file.models, 2);
    ASSERT_EQ(water.atoms.size(), 3u);
    EXPECT_EQ(water.atoms[0].element, 8);
    EXPECT_EQ(water.atoms[2].element, 1);
    EXPECT_FLOAT_EQ(water.atoms[2].position.y, 1.93f);
    EXPECT_EQ(water.masses, (std::vector<float>{15.999f, 1.008f, 1.008f}));
    EXPECT_EQ(water.partialCharges, (std::vector<float>{-0.6f, 0.3f, 0.3f}));
    EXPECT_EQ(water.bonds.size(), 2u);
    EXPECT_NEAR((*water.file.box)[2].z, 22, 1e-4);
    EXPECT_EQ(water.file.boxRepeats, (std::array<bool, 3>{true, true, false}));
    EXPECT_TRUE(std::any_of(water.notes.begin(), water.notes.end(), [](const ReadNote& note) {
        return note.action == ReadAction::unused && note.what == "velocities" && note.count == 3;
    }));
    const auto left = std::find_if(water.notes.begin(), water.notes.end(),
                                   [](const ReadNote& note) { return note.action == ReadAction::leftOut; });
    ASSERT_NE(left, water.notes.end());
    EXPECT_EQ(describeNote(*left), "left out 1 bond: of atoms that are not there");
}

TEST(Hdf5Structures, SpeciesOfNumbersAreGrains) {
    const Molecule beads = readMoleculeFile(test::written() / "beads.h5md");
    ASSERT_EQ(beads.atoms.size(), 3u);
    EXPECT_EQ(beads.atoms[0].element, 0);
    EXPECT_FLOAT_EQ(beads.atoms[0].radius, 0.5f);
    EXPECT_EQ(beads.types[1].view(), "2");
    EXPECT_EQ(beads.file.boxRepeats, (std::array<bool, 3>{})) << "one word for all axes";
    const Molecule labels = readMoleculeFile(test::written() / "labels.h5md");
    EXPECT_EQ(labels.atoms[1].element, 8);
    EXPECT_EQ(labels.bonds.size(), 1u) << "by distance";
    EXPECT_EQ(readMoleculeFile(test::written() / "numbers.h5md").atoms[1].element, 8);
}

TEST(Hdf5Structures, SizesWithoutDataAreRefused) {
    for (const auto& [file, why] : {std::pair("many_atoms.h5md", "more than 50000000 atoms"),
                                    {"many_frames.h5md", "it states more frames than it holds"}}) {
        test::expectThrows([&] { readMoleculeFile(test::written() / file); }, why);
    }
}

TEST(Hdf5Structures, DamagedFilesAreRefused) {
    const std::string bytes = test::readContents(test::written() / "t.h5");
    for (std::size_t cut = 16; cut < bytes.size(); cut += bytes.size() / 40) {
        try {
            readMolecule("a.h5", bytes.substr(0, cut));
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("a.h5"), std::string::npos);
        }
    }
    EXPECT_THROW(readMolecule("a.h5", bytes, {.uploaded = true}), Error);
}

TEST(Hdf5Structures, AHeapThatDoesNotEndIsRefused) {
    // The unit of the positions lies in a heap: 16 bytes, then objects by number, the last of them number 0 and free.
    std::string bytes = test::readContents(test::written() / "t.h5md");
    EXPECT_NO_THROW(readMolecule("a.h5md", bytes));
    const std::size_t heap = bytes.find("GCOL");
    ASSERT_NE(heap, std::string::npos);
    std::size_t at = heap + 16;
    while (bytes[at] != 0) at += 16 + (static_cast<unsigned char>(bytes[at + 8]) + 7) / 8 * 8;
    bytes.replace(at + 8, 8, 8, '\0');
    const TemporaryFolder folder;
    write(folder / "a.h5md", bytes);
    EXPECT_THROW(readMolecule("a.h5md", bytes), Error);
    EXPECT_THROW(openTrajectory(folder / "a.h5md"), Error);
}

/// As HDF5 writes it.
std::string number(std::size_t value, int bytes = 8) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text.push_back(static_cast<char>(value >> 8 * i & 255));
    return text;
}

/// With each of these texts, of which there is one at least, exchanged for another as long.
std::string exchanged(std::string bytes, const std::string& before, const std::string& after) {
    std::size_t at = bytes.find(before);
    EXPECT_NE(at, std::string::npos);
    for (; at != std::string::npos; at = bytes.find(before, at + before.size())) bytes.replace(at, after.size(), after);
    return bytes;
}

TEST(Hdf5Structures, HeapsThatShareTheirObjectsAreRefused) {
    // Each of 400 heaps leads to the same 5,000 objects: walked one after the other they would cost the product.
    const std::size_t heaps = 400, objects = 5000, whole = 32 * heaps + 16 * objects;
    const std::string object("\1\0\0\0\0\0\0\0", 8);
    std::string bytes = test::readContents(test::written() / "t.h5md");
    for (std::size_t i = 0; i < heaps; ++i)
        bytes += std::string("GCOL\1\0\0\0", 8) + number(whole - 32 * i) + object + number(32 * (heaps - 1 - i));
    for (std::size_t i = 0; i < objects; ++i) bytes += object + number(0);
    EXPECT_THROW(readMolecule("a.h5md", bytes), Error);
}

TEST(Hdf5Structures, ReferencesIntoHeapsAreNotTrusted) {
    // The unit of the positions is a reference: two bytes, in the heap at this place, object 1 of it. Without it the
    // unit is Å.
    const std::string bytes = readContents(written() / "t.h5md");
    const std::size_t heap = bytes.find("GCOL");
    ASSERT_NE(heap, std::string::npos);
    const auto reference = [&](std::size_t length, std::size_t place, std::size_t object) {
        return number(length, 4) + number(place) + number(object, 4);
    };
    const std::string sound = reference(2, heap, 1);
    const float x = readMolecule("a.h5md", bytes).atoms[0].position.x;
    const std::vector<std::string> damaged{reference(2, heap, 60000),
                                           reference(2, heap, 0),
                                           reference(2, heap, 1 << 20),
                                           reference(2, heap + 1, 1),
                                           reference(2, std::size_t{1} << 62, 1),
                                           reference(4000, heap, 1)};
    const TemporaryFolder folder;
    for (const std::string& other : damaged) {
        const std::string changed = exchanged(bytes, sound, other);
        EXPECT_NEAR(readMolecule("a.h5md", changed).atoms[0].position.x, x / 10, 1e-4);
        write(folder / "a.h5md", changed);
        EXPECT_NEAR(openTrajectory(folder / "a.h5md")->read(0).positions[0].x, x / 10, 1e-4);
    }
    // An object that fills the heap: the library would write all of it into the two bytes of the text.
    std::string large = bytes;
    large.replace(heap + 24, 8, number(4096 - 32));
    EXPECT_FLOAT_EQ(readMolecule("a.h5md", large).atoms[0].position.x, x);
}

TEST(Hdf5Structures, NumbersOutsideTheirBytesAreRefused) {
    // 32-bit floats: class and order, 4 bytes, bits from 0 on, 32 of them, then exponent and mantissa.
    const std::string head("\x11\x20\x1f\0\4\0\0\0", 8), rest("\x17\x8\0\x17\x7f\0\0\0", 8),
        sound = head + number(0, 2) + number(32, 2) + rest;
    for (const char* file : {"t.h5", "t.h5md"}) {
        const std::string bytes = readContents(written() / file);
        EXPECT_NO_THROW(readMolecule(file, bytes));
        for (const auto& [offset, precision] : {std::pair(0xffff, 32), {1, 32}, {0, 0xffff}, {0, 0}})
            EXPECT_THROW(
                readMolecule(file, exchanged(bytes, sound, head + number(offset, 2) + number(precision, 2) + rest)),
                Error);
        EXPECT_THROW(readMolecule(file, exchanged(bytes, sound, sound.substr(0, 12) + "\xff" + sound.substr(13))),
                     Error);
    }
}

TEST(Hdf5Structures, DatasetsWithoutRoomAreRefused) {
    const std::string compact = readContents(written() / "compact.h5md");
    EXPECT_EQ(readMolecule("a.h5md", compact).atoms.size(), 2u);
    const auto sizes = [](std::size_t frames, std::size_t atoms) { return number(frames) + number(atoms) + number(3); };
    EXPECT_THROW(readMolecule("a.h5md", exchanged(compact, sizes(1, 2), sizes(1, 40000))), Error);
    // Chunks of 2 frames, of the 30 atoms that there are.
    const std::string chunks = readContents(written() / "t.h5md");
    const auto chunk = [](std::size_t atoms) { return number(2, 4) + number(atoms, 4) + number(3, 4); };
    EXPECT_THROW(readMolecule("a.h5md", exchanged(chunks, chunk(30), chunk(30000))), Error);
}

}  // namespace
}  // namespace nacre
