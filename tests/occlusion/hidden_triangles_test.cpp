// What a viewer cannot see of meshes, by a depth map of the host's.

#include "engine/occlusion/hidden_triangles.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "engine/occlusion/occluder_mesh.h"
#include "tests/renderer/meshes.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

constexpr double kSceneRadius = 20;
constexpr std::uint32_t kMapPixels = 80;
constexpr float kMapPixel = 2 * static_cast<float>(kSceneRadius) / kMapPixels;

/// A ball of radius 6 around the origin, for a viewer in a direction.
occlusion::HiddenTriangles behindBall(const glm::dvec3& towards) {
    Representation r;
    appendMesh(icosphere({0, 0, 0}, 6, 4, 0), glm::dvec3(0), testLook, r);
    occlusion::OccluderMeshes meshes;
    meshes.of(r, 0, static_cast<std::uint32_t>(r.triangles.size()), kMapPixel);
    return {meshes, towards, kSceneRadius, kMapPixels};
}

/// Whether a triangle around a place is hidden.
bool hides(const occlusion::HiddenTriangles& hidden, const glm::vec3& place) {
    return hidden.hides(place, place + glm::vec3(0.3f, 0, 0.1f), place + glm::vec3(0, 0.3f, 0.2f));
}

TEST(HiddenTriangles, LieBehindSomethingAllAround) {
    const occlusion::HiddenTriangles hidden = behindBall({0, 0, 1});
    EXPECT_TRUE(hides(hidden, {0, 0, -10}));
    EXPECT_TRUE(hides(hidden, {3, -2, -7}));
    EXPECT_TRUE(hides(hidden, {0, 0, 0}));  // inside
    EXPECT_FALSE(hides(hidden, {0, 0, 10}));
    EXPECT_FALSE(hides(hidden, {0, 0, 6}));
    EXPECT_FALSE(hides(hidden, {0, 0, 5.5f}));  // no farther than the map's error
    EXPECT_FALSE(hides(hidden, {8, 0, -10}));
    EXPECT_FALSE(hides(hidden, {5.7f, 0, -10}));  // so near to the outline that a pixel beside it may show it
    EXPECT_FALSE(hides(hidden, {0, 0, -10 + 100}));
    EXPECT_FALSE(hides(hidden, {30, 0, -10}));  // beyond the map
    // A large one is hidden only where all of it is.
    EXPECT_TRUE(hidden.hides({-2, 0, -9}, {2, 0, -9}, {0, 2, -9}));
    EXPECT_FALSE(hidden.hides({-2, 0, -9}, {9, 0, -9}, {0, 2, -9}));
    EXPECT_FALSE(hidden.hides({-2, 0, -9}, {2, 0, 9}, {0, 2, -9}));
}

TEST(HiddenTriangles, GoWithTheViewer) {
    const glm::dvec3 towards = glm::normalize(glm::dvec3(0.8, 0.5, -0.2));
    const occlusion::HiddenTriangles hidden = behindBall(towards);
    EXPECT_TRUE(hides(hidden, glm::vec3(towards * -10.0)));
    EXPECT_FALSE(hides(hidden, glm::vec3(towards * 10.0)));
    EXPECT_FALSE(hides(hidden, {0, 0, -10}));
}

TEST(HiddenTriangles, AreNoneWithoutMeshes) {
    EXPECT_FALSE(hides({}, {0, 0, -10}));
    EXPECT_FALSE(hides({occlusion::OccluderMeshes(), {0, 0, 1}, kSceneRadius, kMapPixels}, {0, 0, -10}));
}

}  // namespace
}  // namespace nacre::test
