// Cameras of scene files: from and to views, and what their planes cut away.
#include "engine/scene/view/scene_camera.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"

namespace nacre {
namespace {

TEST(SceneViews, OfAViewSeesTheSame) {
    for (const auto& [width, height] : {std::pair(800u, 800u), {1200u, 600u}, {500u, 900u}}) {
        const View shown = makeView(Camera{.rotationDegrees = {20, -50, 75}, .zoom = 1.7}, 20, width, height);
        const glm::dvec3 center(5, -3, 2);
        const SceneCamera camera = makeCamera(shown, center, false);
        const View again = makeView(camera, {}, false, 20, width, height).view;
        EXPECT_NEAR(again.pixelsPerAngstrom, shown.pixelsPerAngstrom, 1e-9);
        EXPECT_LT(glm::distance(camera.target, center), 1e-9);
        for (int i = 0; i < 3; ++i) EXPECT_LT(glm::distance(again.rotation[i], shown.rotation[i]), 1e-9);
    }
}

TEST(SceneViews, OfAMovedPictureLooksAtItsMiddle) {
    const View shown = makeView(Camera{.rotationDegrees = {0, 90, 0}, .pan = {3, 1}}, 20, 600, 600);
    const SceneCamera camera = makeCamera(shown, {}, false);
    const glm::dvec3 middle = shown.rotation * camera.target;
    EXPECT_LT(glm::distance(middle, glm::dvec3(-3, -1, 0)), 1e-9);
}

TEST(SceneViews, OfAMoleculeThatFillsThePictureHasItWhole) {
    Camera hand{.zoom = 1.3};
    EXPECT_EQ(makeCamera(makeView(hand, 20, 600, 600), {}, true).radius, 20);
    hand.zoom = 0.5;
    const View small = makeView(hand, 20, 600, 600);
    EXPECT_EQ(makeCamera(small, {}, true).radius, makeCamera(small, {}, false).radius);
    hand.zoom = 8;
    const View close = makeView(hand, 20, 600, 600);
    EXPECT_GT(makeCamera(close, {}, true).radius, makeCamera(close, {}, false).radius);
    EXPECT_LT(makeCamera(close, {}, true).radius, 5);
}

/// A buckyball in a row of copies along z, and a camera between the first two.
Representation rowOfCopies(Style style) {
    const Molecule m = sampleMolecule("buckyball");
    Representation r = represent(m, drawnAtoms(m), RepresentationOptions{.style = style});
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < 5; ++i) {
        glm::dmat4x3 motion(1.0);
        motion[3].z = 20.0 * i;
        r.copies.transforms.push_back(motion);
        all.push_back(i);
    }
    r.copies.lists = {all};
    const auto run = [&](std::size_t count) {
        return std::vector<PrimitiveRun>(count > 0, {0, static_cast<std::uint32_t>(count), 0, {}, 6});
    };
    r.copies.spheres = run(r.spheres.size());
    r.copies.cylinders = run(r.cylinders.size());
    r.copies.triangles = run(r.triangles.size());
    r.radius = 100;
    return r;
}

TEST(SceneViews, AmongCopiesKeepsThoseBeforeIt) {
    SceneCamera camera{.target = {0, 0, 20}, .direction = {0, 0, -1}};
    camera.radius = 8;  // the second copy alone
    const SceneView seen = makeView(camera, {}, false, 100, 400, 400);
    ASSERT_TRUE(seen.clip.on());
    for (const Style style : {Style::ballAndStick, Style::surface}) {
        Representation r = rowOfCopies(style);
        // About the target, as drawings have it.
        for (glm::dmat4x3& motion : r.copies.transforms) motion[3] -= camera.target;
        const std::size_t spheres = r.spheres.size(), sticks = r.cylinders.size(), triangles = r.triangles.size();
        dropOutside(r, seen);
        EXPECT_TRUE(r.copies.transforms.empty());
        EXPECT_EQ(r.spheres.size(), spheres);
        EXPECT_EQ(r.cylinders.size(), sticks);
        EXPECT_EQ(r.triangles.size(), triangles);
        for (const Sphere& sphere : r.spheres) EXPECT_LT(glm::length(sphere.center), 6);
        for (const Triangle& t : r.triangles) EXPECT_LT(glm::length(decodePosition(r.meshVertices[t.a], t.step())), 8);
    }
}

}  // namespace
}  // namespace nacre
