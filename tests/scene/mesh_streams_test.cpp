// Meshes as streams: what a vertex keeps in its 16 bytes, and what is left out.

#include "engine/scene/build/mesh_streams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <utility>

#include "engine/error.h"
#include "engine/scene/build/representation.h"

namespace nacre::test {
namespace {

static_assert(sizeof(MeshVertex) == 16 && sizeof(Triangle) == 16);

SphereLook makeLook(std::uint32_t atom) { return {0xff000000u + atom, atom + 1}; }

Mesh randomMesh(double reach, std::size_t count) {
    std::mt19937 engine(7);
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    Mesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        mesh.positions.emplace_back(number(-reach, reach), number(-reach, reach), number(-reach, reach));
        mesh.normals.push_back(
            glm::normalize(glm::vec3(number(-1, 1), number(-1, 1), number(-1, 1)) + glm::vec3(0, 0, 1e-6f)));
        mesh.atoms.push_back(static_cast<std::uint32_t>(i % 5));
        if (i >= 2) mesh.triangles.emplace_back(i - 2, i - 1, i);
    }
    return mesh;
}

TEST(MeshStreams, VerticesKeepTheirPlacesAndNormals) {
    for (const double reach : {0.5, 3.0, 60.0, 900.0}) {
        const Mesh mesh = randomMesh(reach, 500);
        Representation r;
        const glm::dvec3 shift(0.25 * reach, -0.125 * reach, 0);
        appendMesh(mesh, shift, makeLook, r);
        ASSERT_EQ(r.meshVertices.size(), 500u);
        ASSERT_EQ(r.triangles.size(), 498u);
        const float step = r.triangles[0].step();
        EXPECT_LE(step, reach * 1.25 / (1 << 19));  // 20 bits either way of the middle
        for (std::size_t i = 0; i < 500; ++i) {
            const glm::dvec3 off =
                glm::dvec3(decodePosition(r.meshVertices[i], step)) - glm::dvec3(mesh.positions[i]) - shift;
            EXPECT_LE(std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}),
                      0.5001 * static_cast<double>(step));
            EXPECT_GT(glm::dot(decodeNormal(r.meshVertices[i]), mesh.normals[i]), 1 - 1e-8f * 100);
        }
    }
}

TEST(MeshStreams, LooksAreSharedAndStepsArePowersOfTwo) {
    Representation r;
    appendMesh(randomMesh(9, 100), glm::dvec3(0), makeLook, r);
    appendMesh(randomMesh(90, 100), glm::dvec3(0), makeLook, r);
    ASSERT_EQ(r.meshLooks.size(), 10u);
    for (const MeshVertex& v : r.meshVertices) ASSERT_LT(v.look, 10u);
    EXPECT_EQ(r.meshLooks[r.meshVertices[102].look].atom, 3u);
    for (const Triangle& t : r.triangles) {
        int exponent = 0;
        EXPECT_EQ(std::frexp(t.step(), &exponent), 0.5f);
    }
    EXPECT_GE(r.triangles.back().a, 100u);
    EXPECT_LT(r.triangles.front().step(), r.triangles.back().step());
}

TEST(MeshStreams, WhatIsNotFiniteOrHasNoAreaIsLeftOut) {
    Mesh mesh = randomMesh(10, 12);
    mesh.positions[3].y = std::numeric_limits<float>::quiet_NaN();  // in triangles 1, 2, 3
    mesh.positions[9] = mesh.positions[8];                          // in triangles 7, 8: two corners in one place
    mesh.normals[0] = glm::vec3(0);
    Representation r;
    appendMesh(mesh, glm::dvec3(0), makeLook, r);
    EXPECT_EQ(r.triangles.size(), 10u - 3 - 2);
    for (const Triangle& t : r.triangles) EXPECT_TRUE(t.a != 3 && t.b != 3 && t.c != 3);
    EXPECT_TRUE(std::isfinite(decodeNormal(r.meshVertices[0]).z));
}

/// A tetrahedron whose faces have vertices of their own, with a level of two triangles back to back.
Mesh tetrahedron() {
    const glm::vec3 corners[] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    Mesh mesh;
    for (const glm::uvec3 t : {glm::uvec3(0, 1, 2), glm::uvec3(0, 3, 1), glm::uvec3(0, 2, 3), glm::uvec3(1, 3, 2)}) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int k = 0; k < 3; ++k) {
            mesh.positions.push_back(corners[t[k]]);
            mesh.normals.emplace_back(0, 0, 1);
            mesh.atoms.push_back(0);
        }
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    mesh.coarser.push_back({0.5f, {{0, 1, 2}, {2, 1, 0}}});
    return mesh;
}

TEST(MeshStreams, AMeshIsClosedIfAllItsLevelsAre) {
    const Mesh closed = tetrahedron();
    Mesh holed = closed, turned = closed, coarselyHoled = closed;
    holed.triangles.pop_back();
    std::swap(turned.triangles[1].x, turned.triangles[1].y);
    coarselyHoled.coarser[0].triangles.pop_back();
    const std::pair<const Mesh*, bool> cases[] = {
        {&closed, true}, {&holed, false}, {&turned, false}, {&coarselyHoled, false}};
    for (const auto& [mesh, isClosed] : cases) {
        Representation r;
        appendMesh(*mesh, glm::dvec3(0), makeLook, r);
        EXPECT_EQ(r.meshes[0].closed, isClosed);
        EXPECT_EQ(isSolid(r), isClosed);
    }
    Representation r;
    appendMesh(closed, glm::dvec3(0), makeLook, r);
    r.copies.transforms = {glm::dmat4x3(1), glm::dmat4x3(1)};
    EXPECT_TRUE(isSolid(r));
    r.copies.transforms[1][0].x = -1;  // a mirror image turns inside out
    EXPECT_FALSE(isSolid(r));
    r.copies.transforms.clear();
    appendMesh(holed, glm::dvec3(0), makeLook, r);
    EXPECT_FALSE(isSolid(r));
}

TEST(MeshStreams, OfAMeshWhoseListsDoNotFitThereIsNone) {
    Mesh mesh = randomMesh(10, 12);
    mesh.triangles.emplace_back(0, 1, 12);
    Representation r;
    EXPECT_THROW(appendMesh(mesh, glm::dvec3(0), makeLook, r), Error);
    mesh = randomMesh(10, 12);
    mesh.atoms.pop_back();
    EXPECT_THROW(appendMesh(mesh, glm::dvec3(0), makeLook, r), Error);
}

}  // namespace
}  // namespace nacre::test
