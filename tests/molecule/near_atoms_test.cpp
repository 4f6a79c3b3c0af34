#include "engine/molecule/near_atoms.h"

#include <gtest/gtest.h>

#include <ctime>
#include <glm/geometric.hpp>
#include <random>

namespace nacre {
namespace {

Molecule cloud(std::size_t count, float size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> coordinate(-size, size);
    Molecule molecule;
    molecule.atoms.resize(count);
    for (Atom& atom : molecule.atoms) atom.position = {coordinate(random), coordinate(random), coordinate(random)};
    return molecule;
}

TEST(NearAtoms, AgreesWithEveryPair) {
    for (const double distance : {0.0, 0.7, 3.0, 12.0, 80.0}) {
        const Molecule molecule = cloud(700, 20, 7);
        std::vector<bool> marked(molecule.atoms.size()), expected(molecule.atoms.size());
        for (std::size_t i = 0; i < marked.size(); i += 31) marked[i] = true;
        for (std::size_t i = 0; i < marked.size(); ++i)
            for (std::size_t j = 0; j < marked.size() && !expected[i]; ++j)
                expected[i] = marked[j] && glm::distance(glm::dvec3(molecule.atoms[i].position),
                                                         glm::dvec3(molecule.atoms[j].position)) <= distance;
        EXPECT_EQ(atomsNear(molecule, marked, distance), expected) << distance;
    }
}

TEST(NearAtoms, TheBoundIsIncludedAndNothingIsNearNothing) {
    Molecule molecule = cloud(2, 0, 1);
    molecule.atoms[1].position = {5, 0, 0};
    EXPECT_EQ(atomsNear(molecule, {true, false}, 5.0), (std::vector<bool>{true, true}));
    EXPECT_EQ(atomsNear(molecule, {true, false}, 4.999), (std::vector<bool>{true, false}));
    EXPECT_EQ(atomsNear(molecule, {false, false}, 9999), (std::vector<bool>{false, false}));
}

TEST(NearAtoms, AMillionAtomsTakeSecondsWhateverTheDistanceAndTheSpread) {
    Molecule molecule = cloud(1'000'000, 120, 3);
    molecule.atoms[0].position = {1e8f, 0, 0};  // one far away, which would spoil a grid
    for (std::size_t i = 1; i < 1000; ++i) molecule.atoms[i].position = {1, 1, 1};  // and a heap
    std::vector<bool> marked(molecule.atoms.size());
    for (std::size_t i = 0; i < marked.size(); ++i) marked[i] = molecule.atoms[i].position.x < 0;
    for (const double distance : {2.0, 40.0, 200.0}) {
        const std::clock_t start = std::clock();  // of the processor: other programs may be busy
        const std::vector<bool> near = atomsNear(molecule, marked, distance);
        EXPECT_FALSE(near[0]);
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        RecordProperty("seconds_at_" + std::to_string(static_cast<int>(distance)), std::to_string(seconds));
        EXPECT_LT(seconds, 20.0) << distance;  // measured: under one
    }
}

}  // namespace
}  // namespace nacre
