// Primitives: which streams they go to, how well meshes fit what they stand for, and how they join a scene.

#include "engine/scene/build/primitives.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numbers>

#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/map_scene.h"
#include "engine/scene/build/mesh_streams.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

Representation drawn(const Primitives& primitives, const glm::dvec3& center = {}) {
    Representation scene;
    scene.center = center;
    addPrimitives(primitives, scene);
    return scene;
}

TEST(Primitives, OpaqueRoundOnesAreExact) {
    Primitives p;
    p.lines.push_back({{1, 0, 0}, {4, 0, 0}, 0.2});
    p.lines.push_back({{1, 0, 0}, {4, 0, 0}, 0, 3});
    p.balls.push_back({{0, 0, 5}, 2, {0xff0000ff, 1, 1}});
    p.notes = {"a ball"};
    const Representation r = drawn(p, {0, 0, 1});
    ASSERT_EQ(r.cylinders.size(), 1u);
    EXPECT_EQ(r.cylinders[0].a, glm::vec3(1, 0, -1));
    EXPECT_EQ(r.cylinders[0].radius, 0.2f);
    ASSERT_EQ(r.wires.size(), 1u);
    EXPECT_EQ(r.wires[0].radius, -1.5f) << "minus half of the width";
    ASSERT_EQ(r.spheres.size(), 1u);
    EXPECT_EQ(r.sphereLooks[0].color, 0xff0000ffu);
    EXPECT_EQ(r.sphereLooks[0].atom, 1u);
    EXPECT_TRUE(r.triangles.empty());
    EXPECT_DOUBLE_EQ(r.radius, 6);
}

TEST(Primitives, TranslucentOnesAreMeshesOfThatOpacity) {
    Primitives p;
    p.lines.push_back({{1, 0, 0}, {4, 0, 0}, 0.2, 0, {}, {0xff00ff00, 0.5}});
    p.balls.push_back({{0, 0, 5}, 2, {0xff0000ff, 0.25}});
    const Representation r = drawn(p);
    EXPECT_TRUE(r.cylinders.empty() && r.spheres.empty());
    EXPECT_FALSE(r.triangles.empty());
    ASSERT_EQ(r.meshLooks.size(), 2u);
    EXPECT_EQ(opacitySteps(r.meshLooks[0].color), kOpacitySteps / 2);
    EXPECT_EQ(opacitySteps(r.meshLooks[1].color), kOpacitySteps / 4);
}

TEST(Primitives, DashesHaveTheirLengthsAndHalfAGapAtTheEnds) {
    Primitives p;
    p.lines.push_back({{0, 0, 0}, {10, 0, 0}, 0.1, 0, {0.6, 0.4}});
    const Representation r = drawn(p);
    ASSERT_EQ(r.cylinders.size(), 10u);
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_NEAR(r.cylinders[i].a.x, 0.2f + static_cast<float>(i), 1e-5f);
        EXPECT_NEAR(r.cylinders[i].b.x, 0.8f + static_cast<float>(i), 1e-5f);
    }
}

/// The farthest that triangles stand from an ellipsoid, in its longest half axis: each at its corners and middles.
double standOff(const Representation& r, const std::array<glm::dvec3, 3>& axes) {
    double most = 0, longest = 0;
    for (const glm::dvec3& axis : axes) longest = std::max(longest, glm::length(axis));
    for (const Triangle& t : r.triangles) {
        glm::dvec3 middle{};
        for (const std::uint32_t v : {t.a, t.b, t.c})
            middle += glm::dvec3(decodePosition(r.meshVertices[v], t.step())) / 3.0;
        glm::dvec3 unit{};
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3& axis = axes[static_cast<std::size_t>(i)];
            unit[i] = glm::dot(middle, axis) / glm::dot(axis, axis);
        }
        most = std::max(most, 1 - glm::length(unit));
    }
    return most;
}

TEST(Primitives, EllipsoidsKeepTheirErrorAndTheirNormals) {
    const std::array<glm::dvec3, 3> axes{glm::dvec3(3, 0, 0), {0, 2, 0}, {0, 0, 1}};
    for (const std::size_t count : {1u, 200u, 900u, 3000u, 5000u}) {
        Primitives p;
        p.ellipsoids.push_back({{}, axes, {}});
        while (p.ellipsoids.size() < count) p.ellipsoids.push_back({{0, 0, 50}, {}, {}});  // of no extent: not drawn
        const Representation r = drawn(p);
        const double off = standOff(r, axes);
        EXPECT_LE(off, ellipsoidError(count) + 1e-5) << count;
        EXPECT_GE(off, 0.9 * ellipsoidError(count)) << count << ": no finer than stated";
        for (const MeshVertex& v : r.meshVertices) {
            const glm::dvec3 at(decodePosition(v, r.triangles[0].step()));
            const glm::dvec3 exact = glm::normalize(glm::dvec3(at.x / 9, at.y / 4, at.z / 1));
            EXPECT_GT(glm::dot(exact, glm::dvec3(decodeNormal(v))), 0.9999);
        }
    }
    EXPECT_NEAR(ellipsoidError(61), 2.44e-4, 1e-6);
    EXPECT_NEAR(ellipsoidError(244), 9.75e-4, 1e-6);
    EXPECT_NEAR(ellipsoidError(976), 3.88e-3, 1e-5);
    EXPECT_NEAR(ellipsoidError(3906), 0.0153, 1e-4);
    EXPECT_NEAR(ellipsoidError(10000), 0.0572, 1e-4);
}

/// What triangles enclose, with their sense: negative if they face inwards.
double measureVolume(const Representation& r) {
    double volume = 0;
    for (const Triangle& t : r.triangles) {
        const auto at = [&](std::uint32_t v) { return glm::dvec3(decodePosition(r.meshVertices[v], t.step())); };
        volume += glm::dot(at(t.a), glm::cross(at(t.b), at(t.c))) / 6;
    }
    return volume;
}

TEST(Primitives, SolidsFaceOutwardsAndEncloseWhatTheyShould) {
    Primitives box, mirrored, cone, oblique;
    box.boxes.push_back({{5, 0, 0}, {{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}});
    mirrored.boxes.push_back({{5, 0, 0}, {{{-1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}});
    cone.arrows.push_back({{0, 0, 0}, {0, 0, 3}, 0, 1, 3});
    oblique.ellipsoids.push_back({{}, {{{-1, 0, 0}, {1, 2, 0}, {0, 0, 3}}}, {}});
    EXPECT_NEAR(measureVolume(drawn(box)), 48, 1e-3);
    EXPECT_NEAR(measureVolume(drawn(mirrored)), 48, 1e-3);
    EXPECT_NEAR(measureVolume(drawn(cone)), std::numbers::pi, 0.02);
    EXPECT_NEAR(measureVolume(drawn(oblique)), 4.0 / 3 * std::numbers::pi * 6, 0.01);
}

TEST(Primitives, ASectorIsAsLargeAsItsAngle) {
    Primitives p;
    p.ellipses.push_back({{}, {2, 0, 0}, {0, 1, 0}, 0, std::numbers::pi / 2, {}});
    const Representation r = drawn(p);
    double area = 0;
    for (const Triangle& t : r.triangles) {
        const auto at = [&](std::uint32_t v) { return glm::dvec3(decodePosition(r.meshVertices[v], t.step())); };
        area += glm::length(glm::cross(at(t.b) - at(t.a), at(t.c) - at(t.a))) / 2;
    }
    EXPECT_NEAR(area, std::numbers::pi / 2, 2e-3);
}

TEST(Primitives, AMeshHasItsColoursByTriangleOrVertex) {
    Primitives p;
    Primitives::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.looks = {{0xff0000ff, 1, 0}, {0xff00ff00, 1, 0}};
    mesh.wires = PrimitiveLook{};
    p.meshes.push_back(mesh);
    const Representation r = drawn(p);
    ASSERT_EQ(r.triangles.size(), 2u);
    for (const std::size_t i : {0u, 1u})
        EXPECT_EQ(r.meshLooks[r.meshVertices[r.triangles[i].b].look].color, mesh.looks[i].color);
    EXPECT_EQ(r.wires.size(), 5u) << "an edge of two triangles is one line";
    p.meshes[0].looks.resize(3);
    EXPECT_THROW(drawn(p), Error);
    p.meshes[0].looks.resize(1);
    p.meshes[0].triangles[1][2] = 4;
    EXPECT_THROW(drawn(p), Error);
}

TEST(Primitives, ColoursOfVerticesBlendIfAsked) {
    Primitives p;
    Primitives::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};  // as many as vertices
    mesh.looks = {{0xff000001}, {0xff000002}, {0xff000003}, {0xff000004}};
    p.meshes.push_back(mesh);
    EXPECT_FALSE(drawn(p).blendsColors);
    p.meshes[0].blends = true;
    const Representation r = drawn(p);
    EXPECT_TRUE(r.blendsColors);
    const Triangle& last = r.triangles[3];
    EXPECT_EQ(r.meshLooks[r.meshVertices[last.a].look].color, 0xff000002u);
    EXPECT_EQ(r.meshLooks[r.meshVertices[last.c].look].color, 0xff000004u);
}

TEST(Primitives, JoinAMoleculeBehindItsNumbers) {
    const Molecule m = sampleMolecule("dna");
    Representation scene = represent(m, drawnAtoms(m), {Style::spacefill});
    const std::size_t spheres = scene.spheres.size(), atoms = m.atoms.size();
    Primitives p;
    p.balls.push_back({scene.center, 1, {0xffffffff, 1, 1}});
    p.ellipsoids.push_back({scene.center, {{{9, 0, 0}, {0, 9, 0}, {0, 0, 9}}}, {0xffffffff, 1, 2}});
    p.lines.push_back({scene.center, scene.center + glm::dvec3(90, 0, 0), 0, 1, {}, {}});
    p.notes = {"first", "second"};
    Representation beside;
    beside.center = scene.center;
    addPrimitives(p, beside);
    joinScenes(scene, beside);
    ASSERT_EQ(scene.spheres.size(), spheres + 1);
    EXPECT_EQ(scene.sphereLooks.back().atom, atoms + 1);
    EXPECT_EQ(scene.noteNumber(scene.sphereLooks.back().atom), 1u);
    EXPECT_EQ(scene.noteNumber(scene.meshLooks.back().atom), 2u);
    EXPECT_EQ(scene.wireLooks.back().atomA, 0u);
    EXPECT_EQ(scene.noteNumber(static_cast<std::uint32_t>(atoms)), 0u);
    EXPECT_DOUBLE_EQ(scene.radius, 90);
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_FALSE(scene.meshes[0].levels.empty()) << "a large ball is drawn coarser where it is small";
}

TEST(Primitives, WhatIsTooMuchIsRefused) {
    Primitives far, many, crowd;
    far.balls.push_back({{2e6, 0, 0}, 1, {}});
    EXPECT_THROW(drawn(far), Error);
    many.lines.assign(3000, {{0, 0, 0}, {1000, 0, 0}, 0, 1, {0.25, 0.25}});
    EXPECT_THROW(drawn(many), Error) << "dashes without end";
    crowd.balls.assign(20'000, {{0, 0, 0}, 5, {}});
    EXPECT_THROW(drawn(crowd), Error);
}

TEST(Primitives, WhatIsNotThereIsNotDrawn) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    Primitives p;
    p.lines.push_back({{1, 1, 1}, {1, 1, 1}, 0.2});
    p.lines.push_back({{kNan, 1, 1}, {1, 1, 1}, 0.2});
    p.arrows.push_back({{1, 1, 1}, {1, 1, 1}});
    p.balls.push_back({{1, kNan, 1}, 1, {}});
    p.ellipsoids.push_back({{1, 1, 1}, {}, {}});
    p.boxes.push_back({{}, {}});
    const Representation r = drawn(p);
    EXPECT_TRUE(r.spheres.empty() && r.cylinders.empty() && r.wires.empty() && r.triangles.empty());
}

}  // namespace
}  // namespace nacre
