// Spheres that others hide, against the nearest sphere at many places of the view.

#include "engine/occlusion/hidden_spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace nacre::test {
namespace {

constexpr glm::dvec3 kFront(0, 0, 1);

std::vector<Sphere> crowd(std::size_t count, float size) {
    std::mt19937 engine(5);
    const auto chance = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine); };
    std::vector<Sphere> spheres;
    for (std::size_t i = 0; i < count; ++i)
        spheres.push_back({{chance(-size, size), chance(-size, size), chance(-size, size)}, chance(1.2f, 2)});
    return spheres;
}

/// The sphere that a viewer sees along a line, or their number.
std::size_t findNearest(const std::vector<Sphere>& spheres, const glm::vec3& at, const glm::vec3& towards) {
    std::size_t nearest = spheres.size();
    float best = -1e9f;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const glm::vec3 d = spheres[i].center - at;
        const float height = glm::dot(d, towards);
        const float h = spheres[i].radius * spheres[i].radius - (glm::dot(d, d) - height * height);
        if (h > 0 && height + std::sqrt(h) > best) best = height + std::sqrt(h), nearest = i;
    }
    return nearest;
}

TEST(HiddenSpheres, AreNowhereNearest) {
    const std::vector<Sphere> spheres = crowd(800, 9);
    const glm::dvec3 towards = glm::normalize(glm::dvec3(0.8, 0.5, -0.2));
    const std::vector<bool> hidden = hiddenSpheres(spheres, towards);
    std::vector<bool> seen(spheres.size() + 1, false);
    const glm::dvec3 right = glm::normalize(glm::cross(towards, glm::dvec3(0, 1, 0))), up = glm::cross(towards, right);
    for (double y = -18; y < 18; y += 0.2)
        for (double x = -18; x < 18; x += 0.2)
            seen[findNearest(spheres, glm::vec3(x * right + y * up), towards)] = true;
    std::size_t found = 0, unseen = 0;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        EXPECT_FALSE(hidden[i] && seen[i]) << i;
        found += hidden[i];
        unseen += !seen[i];
    }
    EXPECT_GT(10 * found, 7 * unseen);  // most of them
}

TEST(HiddenSpheres, LieBehindOthersAllAround) {
    const auto isHidden = [](const Sphere& sphere, const std::vector<Sphere>& others) -> bool {
        std::vector<Sphere> all = others;
        all.push_back(sphere);
        return hiddenSpheres(all, kFront).back();
    };
    const std::vector<Sphere> ball{{{0, 0, 0}, 3}};
    EXPECT_TRUE(isHidden({{0, 0, -4}, 1}, ball));
    EXPECT_TRUE(isHidden({{0, 0, 0}, 1}, ball));  // inside
    EXPECT_FALSE(isHidden({{0, 0, 4}, 1}, ball));
    EXPECT_FALSE(isHidden({{0, 0, 2.5f}, 1}, ball));   // sticks out
    EXPECT_FALSE(isHidden({{2.1f, 0, -4}, 1}, ball));  // beside the outline
    EXPECT_FALSE(isHidden({{0, 0, -4}, 1}, {}));
    EXPECT_FALSE(isHidden({{0, 0, -9}, 4}, ball));  // larger
    const std::vector<Sphere> lost{{{0, 0, 0}, 3}, {{NAN, 0, 0}, 1}};
    EXPECT_FALSE(isHidden({{0, 0, -4}, 1}, lost));
}

}  // namespace
}  // namespace nacre::test
