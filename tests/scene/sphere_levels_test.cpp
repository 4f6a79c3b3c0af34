#include "engine/scene/instances/sphere_levels.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numeric>
#include <random>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"

namespace nacre::test {
namespace {

Representation dnaTwice() {
    Molecule m = sampleMolecule("dna");
    std::vector<std::uint32_t> subchains(m.subchains.size());
    std::iota(subchains.begin(), subchains.end(), 0u);
    glm::mat4x3 aside(1.0f);
    aside[3] = {100, 0, 0};
    m.assemblies = {{"1", "", {{{glm::mat4x3(1.0f), aside}, subchains}}}};
    RepresentationOptions options{.style = Style::spacefill, .color = ColorScheme::element, .assembly = "1"};
    return represent(m, drawnAtoms(m), options);
}

/// How far spheres reach along a direction.
float reachAlong(std::span<const Sphere> spheres, const glm::vec3& way) {
    float reach = -1e30f;
    for (const Sphere& s : spheres) reach = std::max(reach, glm::dot(s.center, way) + s.radius);
    return reach;
}

TEST(SphereLevels, HaveFewerSpheresAndKeepTheirOutline) {
    const Representation r = dnaTwice();
    const SphereLevels levels = makeSphereLevels(r);
    ASSERT_EQ(levels.parts.size(), 1u);
    const LeveledPart& part = levels.parts[0];
    EXPECT_EQ(part.levels.front().count, r.spheres.size());
    EXPECT_EQ(SphereLevels::levelError(part.levels.front().step), 0);
    EXPECT_EQ(part.levels.back().count, 1u);
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    for (std::size_t l = 1; l < part.levels.size(); ++l) {
        const SphereLevel& level = part.levels[l];
        const float error = SphereLevels::levelError(level.step);
        EXPECT_LE(static_cast<float>(level.count), 0.8f * static_cast<float>(part.levels[l - 1].count) + 0.5f);
        const std::span<const Sphere> spheres(levels.spheres.data() + level.first, level.count);
        for (int i = 0; i < 200; ++i) {
            const glm::vec3 way = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
            EXPECT_NEAR(reachAlong(spheres, way), reachAlong(r.spheres, way), error * 1.1f) << level.count;
        }
    }
    // At the width of an atom, a sphere stands for several.
    for (const SphereLevel& level : part.levels)
        if (SphereLevels::levelError(level.step) >= 1.9f) {
            EXPECT_LT(6 * level.count, r.spheres.size());
        }
}

TEST(SphereLevels, HaveBallsAboutTheirSpheres) {
    const SphereLevels levels = makeSphereLevels(dnaTwice());
    for (const LeveledPart& part : levels.parts)
        for (const SphereLevel& level : part.levels)
            for (std::uint32_t i = level.first; i < level.first + level.count; ++i) {
                const Sphere& s = levels.spheres[i];
                const SphereLevels::Ball& ball = levels.balls[i / SphereLevels::kSpheres];
                EXPECT_LE(glm::distance(s.center, ball.center) + s.radius, ball.radius + 1e-4f);
                EXPECT_LE(glm::distance(s.center, part.center) + s.radius, part.radius + 1e-3f);
                EXPECT_NE(levels.looks[i].atom, 0u);
            }
}

TEST(SphereLevels, AreOfCopiesOfSpheresAlone) {
    Representation r = dnaTwice();
    EXPECT_TRUE(canHaveLevels(r));
    EXPECT_TRUE(hasNumbers(r));
    EXPECT_EQ(spheresInCopies(r), 2 * r.spheres.size());
    r.cylinders.emplace_back();
    EXPECT_FALSE(canHaveLevels(r));
    r = {};
    EXPECT_FALSE(canHaveLevels(r));
}

}  // namespace
}  // namespace nacre::test
