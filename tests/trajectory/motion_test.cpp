// Frames laid onto each other, made whole and smoothed.

#include "engine/molecule/trajectory/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/error.h"
#include "tests/trajectory/written_trajectories.h"

namespace nacre {
namespace {

using test::chains;
using test::readNumbers;
using test::written;

TEST(Motion, LaysFramesAsMdtrajDoes) {
    const Molecule molecule = chains();
    MotionOptions options;
    for (std::uint32_t i = 0; i < 20; ++i) options.fitted.push_back(i);
    Motion motion(openTrajectory(written() / "t.trr"), molecule, options);
    const std::vector<float> laid = readNumbers("laid"), rmsd = readNumbers("rmsd");
    ASSERT_EQ(rmsd.size(), 5u);
    for (std::size_t frame = 5; frame-- > 0;) {
        const std::vector<glm::vec3> positions = motion.positions(frame);
        EXPECT_NEAR(motion.rmsd(), 10 * rmsd[frame], 2e-3) << frame;
        for (std::size_t i = 0; i < 180; ++i)
            ASSERT_NEAR(positions[i / 3][static_cast<int>(i % 3)], laid[frame * 189 + 9 + i], 2e-3)
                << frame << " " << i;
    }
}

TEST(Motion, MakesMoleculesWhole) {
    const Molecule molecule = chains();
    ASSERT_EQ(molecule.bonds.size(), 57u);
    const std::unique_ptr<Trajectory> before = openTrajectory(written() / "t.trr");
    const auto longest = [&](const std::vector<glm::vec3>& p) {
        float length = 0;
        for (const Bond& bond : molecule.bonds) length = std::max(length, glm::distance(p[bond.a], p[bond.b]));
        return length;
    };
    Motion cut(openTrajectory(written() / "cut.trr"), molecule, {});
    MotionOptions options;
    options.whole = true;
    Motion whole(openTrajectory(written() / "cut.trr"), molecule, options);
    for (std::size_t frame = 0; frame < 5; ++frame) {
        EXPECT_GT(longest(cut.positions(frame)), 10) << "nothing was cut";
        const std::vector<glm::vec3> expected = before->read(frame).positions, made = whole.positions(frame);
        for (const Bond& bond : molecule.bonds)
            EXPECT_LT(glm::distance(made[bond.b] - made[bond.a], expected[bond.b] - expected[bond.a]), 1e-3);
    }
}

TEST(Motion, SmoothsOverNeighbouringFrames) {
    const Molecule molecule = chains();
    MotionOptions options;
    options.smoothed = 3;
    Motion motion(openTrajectory(written() / "t.trr"), molecule, options);
    const std::unique_ptr<Trajectory> t = openTrajectory(written() / "t.trr");
    const auto mean = [&](std::size_t from, std::size_t to, std::size_t atom) {
        glm::vec3 sum(0);
        for (std::size_t i = from; i <= to; ++i) sum += t->read(i).positions[atom];
        return sum / static_cast<float>(to - from + 1);
    };
    EXPECT_LT(glm::distance(motion.positions(2)[7], mean(1, 3, 7)), 1e-4);
    EXPECT_LT(glm::distance(motion.positions(0)[7], mean(0, 1, 7)), 1e-4);
    EXPECT_LT(glm::distance(motion.positions(4)[7], mean(3, 4, 7)), 1e-4);
}

/// Two bonded atoms that drift through the faces of a slanted box, 4 Å a frame.
class Drifting : public Trajectory {
public:
    explicit Drifting(std::size_t frames) {
        atoms_ = 2;
        frames_ = frames;
    }
    static glm::vec3 expectedPlace(std::size_t frame, float atom) {
        return {2 + 4 * static_cast<float>(frame) + atom, 3 * static_cast<float>(frame), 1};
    }
    static constexpr PeriodicBox kBox{glm::vec3(10, 0, 0), glm::vec3(3, 12, 0), glm::vec3(-2, 4, 9)};

private:
    void readFrame(std::size_t frame, TrajectoryFrame& result) override {
        for (const int atom : {0, 1}) {
            glm::vec3 p = expectedPlace(frame, static_cast<float>(atom));
            for (int k = 2; k >= 0; --k)
                p -= kBox[static_cast<std::size_t>(k)] * std::floor(p[k] / kBox[static_cast<std::size_t>(k)][k]);
            result.positions[static_cast<std::size_t>(atom)] = p;
        }
        result.box = kBox;
    }
};

TEST(Motion, AveragesNothingAcrossTheBox) {
    const Molecule molecule = readMolecule("two.xyz", "2\n\nC 0 0 0\nC 1.5 0 0\n");
    ASSERT_EQ(molecule.bonds.size(), 1u);
    for (const bool whole : {false, true}) {
        MotionOptions options;
        options.whole = whole;
        Motion plain(std::make_unique<Drifting>(12), molecule, options);
        options.smoothed = 5;
        Motion smooth(std::make_unique<Drifting>(12), molecule, options);
        for (std::size_t frame = 2; frame + 2 < 12; ++frame)  // what drifts evenly is its own mean
            for (const std::size_t atom : {0u, 1u})
                EXPECT_LT(glm::distance(smooth.positions(frame)[atom], plain.positions(frame)[atom]), 1e-4)
                    << whole << frame;
        // At the ends the mean is half a step or a step further on.
        EXPECT_LT(glm::distance(smooth.positions(0)[0], Drifting::expectedPlace(1, 0)), 1e-4);
    }
}

/// Two molecules that drift and turn together, each atom put back into a box of 20 Å; and a third that stays.
class Parted : public Trajectory {
public:
    Parted() {
        atoms_ = 6;
        frames_ = 8;
    }
    static constexpr glm::vec3 kPlaces[] = {{0, 0, 0}, {1.5f, 0, 0}, {0, 4, 0}, {1, 4, 1}, {0, -7, 0}, {0, -7, 1.5f}};

private:
    void readFrame(std::size_t frame, TrajectoryFrame& result) override {
        const auto t = static_cast<float>(frame);
        for (std::size_t atom = 0; atom < 6; ++atom) {
            glm::vec3 p = kPlaces[atom];
            if (atom < 4)
                p = glm::vec3(p.x * std::cos(t) - p.y * std::sin(t), p.x * std::sin(t) + p.y * std::cos(t), p.z) +
                    6.f * t * glm::vec3(1, 1, 0.1f);
            result.positions[atom] = p - 20.f * glm::floor(p / 20.f);
        }
        result.box = {glm::vec3(20, 0, 0), glm::vec3(0, 20, 0), glm::vec3(0, 0, 20)};
    }
};

TEST(Motion, LaysMoleculesThatTheBoxPartedAsIfItHadNot) {
    const Molecule molecule =
        readMolecule("m.xyz", "6\n\nC 0 0 0\nC 1.5 0 0\nC 0 4 0\nC 1 4 1\nC 0 -7 0\nC 0 -7 1.5\n");
    ASSERT_EQ(molecule.bonds.size(), 3u);
    MotionOptions options{.fitted = {0, 1, 2, 3}};
    Motion torn(std::make_unique<Parted>(), molecule, options);
    options.whole = true;
    Motion whole(std::make_unique<Parted>(), molecule, options);
    double farthest = 0;
    for (const std::size_t frame : {7u, 0u, 1u, 2u, 3u, 4u, 5u, 6u}) {
        const std::vector<glm::vec3> made = whole.positions(frame), first = whole.positions(0);
        whole.positions(frame);
        EXPECT_LT(whole.rmsd(), 1e-3) << frame;
        for (std::size_t atom = 0; atom < 4; ++atom) {
            EXPECT_LT(glm::distance(made[atom], first[atom]), 1e-3) << frame << " " << atom;
            EXPECT_NEAR(glm::distance(made[atom], made[0]), glm::distance(Parted::kPlaces[atom], Parted::kPlaces[0]),
                        1e-3);
        }
        EXPECT_LT(glm::distance(made[4], made[0]), 10 * std::sqrt(3.0)) << frame << ": half the box's diagonal";
        torn.positions(frame);
        farthest = std::max(farthest, torn.rmsd());
    }
    EXPECT_GT(farthest, 1);
    EXPECT_TRUE(torn.torn());
    EXPECT_FALSE(whole.torn());
}

/// The same molecules, of which only some frames have a box.
class Boxless : public Trajectory {
public:
    explicit Boxless(std::vector<bool> boxes) : boxes_(std::move(boxes)) {
        atoms_ = 4;
        frames_ = boxes_.size();
    }

private:
    void readFrame(std::size_t frame, TrajectoryFrame& result) override {
        // The second molecule stands at the other side of the box, and its bond goes through it.
        result.positions = {{1, 1, 1}, {2.5f, 1, 1}, {19.5f, 5, 1}, {1, 5, 1}};
        if (boxes_[frame]) result.box = {glm::vec3(20, 0, 0), glm::vec3(0, 20, 0), glm::vec3(0, 0, 20)};
    }
    std::vector<bool> boxes_;
};

TEST(Motion, MakesNothingWholeWithoutABox) {
    const Molecule molecule = readMolecule("m.xyz", "4\n\nC 1 1 1\nC 2.5 1 1\nC 0 5 1\nC 1.5 5 1\n");
    ASSERT_EQ(molecule.bonds.size(), 2u);
    for (const std::vector<std::uint32_t>& fitted : {std::vector<std::uint32_t>{}, {0, 1, 2}}) {
        MotionOptions options{.whole = true, .fitted = fitted};
        for (const std::vector<bool>& boxes : {std::vector<bool>{false, true}, {true, false}, {false, false}}) {
            Motion motion(std::make_unique<Boxless>(boxes), molecule, options);
            for (const std::size_t frame : {1u, 0u, 1u}) {
                const std::vector<glm::vec3> made = motion.positions(frame);
                const float bond = glm::distance(made[2], made[3]);
                EXPECT_NEAR(bond, boxes[frame] ? 1.5f : 18.5f, 1e-3f) << fitted.size() << frame;
            }
            EXPECT_TRUE(motion.boxless());
        }
        Motion boxed(std::make_unique<Boxless>(std::vector<bool>{true, true}), molecule, options);
        boxed.positions(1);
        EXPECT_FALSE(boxed.boxless());
    }
}

// What else is stated of the same atoms does not stand in the way of fitting models; other atoms do, and are named.
TEST(ModelTrajectory, IsOfPlacesAloneIfThatIsWanted) {
    const auto model = [](const char* name, const char* x, const char* factor) {
        return "MODEL        1\nATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00 50.00           N\nATOM   "
               "   2  " +
               std::string(name) + " GLY A   1       " + x + "   0.000   0.000  1.00 " + factor +
               "           C\nENDMDL\n";
    };
    const auto read = [&](const std::string& second) {
        return std::make_shared<const Molecule>(
            readMolecule("m.pdb", model("CA ", "1.500", "10.00") + second, {.others = true}));
    };
    const auto factors = read(model("CA ", "1.600", "90.00")), names = read(model("CB ", "1.600", "10.00"));
    EXPECT_EQ(trajectoryOfModels(factors, 1), nullptr);
    const auto places = trajectoryOfModels(factors, 1, true);
    ASSERT_NE(places, nullptr);
    EXPECT_EQ(places->read(1).positions.at(1), glm::vec3(1.6f, 0, 0));
    EXPECT_EQ(trajectoryOfModels(names, 1, true), nullptr);
    EXPECT_EQ(differenceOfModels(*names), "of model 2, atom 2 is CB of GLY 1; of the first, atom 2 is CA of GLY 1");
}

TEST(Motion, WantsTheSameAtoms) { EXPECT_THROW(Motion(openTrajectory(written() / "few.xtc"), chains(), {}), Error); }

}  // namespace
}  // namespace nacre
