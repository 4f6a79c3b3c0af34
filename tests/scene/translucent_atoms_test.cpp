// Translucent atoms and bonds of layers are triangles of that opacity.
#include "engine/scene/build/translucent_atoms.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>

#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

constexpr std::uint32_t kSeenThrough = packedColor(0xff0000), kSolid = packedColor(0x0000ff);

/// Atom 3 is translucent, atom 7 is not; a stick between them.
Representation stickLayer(SceneLayer& layer) {
    layer.atoms = {3, 7};
    layer.opacity = {0.5f, 1.0f};
    Representation part;
    part.spheres = {{{1, 2, 3}, 0.5f}, {{4, 2, 3}, 0.7f}};
    part.sphereLooks = {{kSeenThrough, 4}, {kSolid, 8}};
    part.cylinders = {{{1, 2, 3}, 0.25f, {4, 2, 3}, 0}};
    part.cylinderLooks = {{kSeenThrough, kSolid, 4, 8}};
    return part;
}

TEST(TranslucentAtoms, AreTrianglesAndTheOthersStay) {
    SceneLayer layer;
    Representation part = stickLayer(layer);
    meshTranslucentAtoms(layer, part);
    ASSERT_EQ(part.spheres.size(), 1u);
    EXPECT_EQ(part.sphereLooks[0].atom, 8u);
    EXPECT_TRUE(part.cylinders.empty());
    std::set<std::pair<std::uint32_t, std::uint32_t>> looks;
    for (const SphereLook& look : part.meshLooks) looks.emplace(look.color, look.atom);
    EXPECT_EQ(looks,
              (std::set<std::pair<std::uint32_t, std::uint32_t>>{{withOpacity(kSeenThrough, 0.5), 4}, {kSolid, 8}}));
    double farthest = 0;
    for (const Triangle& t : part.triangles)
        for (const std::uint32_t corner : {t.a, t.b, t.c}) {
            const MeshVertex& v = part.meshVertices[corner];
            if (part.meshLooks[v.look].atom != 4) continue;
            const float away = glm::distance(positionOf(v, t.step()), glm::vec3(1, 2, 3));
            farthest = std::max(farthest, static_cast<double>(away));
        }
    EXPECT_NEAR(farthest, std::hypot(1.5, 0.25), 1e-3);  // to the middle of the stick
}

TEST(TranslucentAtoms, OpaqueLayersAreLeftAlone) {
    SceneLayer layer;
    Representation part = stickLayer(layer);
    layer.opacity.clear();
    meshTranslucentAtoms(layer, part);
    EXPECT_EQ(part.spheres.size(), 2u);
    EXPECT_EQ(part.cylinders.size(), 1u);
    EXPECT_TRUE(part.triangles.empty());
}

}  // namespace
}  // namespace nacre
