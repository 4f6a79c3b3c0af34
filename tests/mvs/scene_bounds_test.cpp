// The sphere about a scene of many copies.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <numeric>

#include "engine/scene/build/scene_layers.h"

namespace nacre::test {
namespace {

/// Most memory that this process has had, MB.
long mostResident() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

TEST(SceneBounds, TakeNoMemoryForCopiesOfAtoms) {
    constexpr std::uint32_t kAtoms = 1000, kCopies = 10'000;  // 320 MB, if each were kept
    SceneGuide guide;
    for (std::uint32_t i = 0; i < kCopies; ++i) {
        guide.transforms.emplace_back(1.0);
        guide.transforms.back()[3] = {2.0 * i, 0, 0};
    }
    guide.lists.emplace_back(kCopies);
    std::iota(guide.lists[0].begin(), guide.lists[0].end(), 0u);
    guide.listOfResidue = {0};
    SceneLayer layer;
    Molecule m;
    m.residues.resize(1);
    m.residues[0].atomCount = kAtoms;
    m.atoms.resize(kAtoms);
    for (std::uint32_t i = 0; i < kAtoms; ++i) {
        m.atoms[i].position = {0, 0, static_cast<float>(i)};
        m.atoms[i].element = 6;
        layer.atoms.push_back(i);
    }
    m.guide = std::make_shared<const SceneGuide>(std::move(guide));
    const long before = mostResident();
    const Bounds bounds = computeBounds(m, std::span(&layer, 1));
    EXPECT_LT(mostResident() - before, 64);
    EXPECT_EQ(bounds.center, glm::dvec3(kCopies - 1, 0, (kAtoms - 1) / 2.0));
    EXPECT_NEAR(bounds.radius, std::hypot(kCopies - 1.0, (kAtoms - 1) / 2.0), 3);
}

}  // namespace
}  // namespace nacre::test
