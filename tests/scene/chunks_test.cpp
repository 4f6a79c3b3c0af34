#include "engine/scene/build/chunks.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace nacre {
namespace {

/// Spheres and cylinders here and there; the atom of each is its number.
Representation scattered(std::uint32_t count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-50, 50);
    Representation r;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 at(place(random), place(random), place(random));
        r.spheres.push_back({at, 1.5f});
        r.sphereLooks.push_back({0, i});
        r.cylinders.push_back({at, 0.2f, at + glm::vec3(1, 1, 0)});
        r.cylinderLooks.push_back({0, 0, i, i});
    }
    Mesh mesh;
    for (std::uint32_t i = 0; i < 3 * count; ++i) {
        mesh.positions.push_back(r.spheres[i / 3].center + glm::vec3(place(random), place(random), 0) * 0.02f);
        mesh.normals.emplace_back(0, 0, 1);
        mesh.atoms.push_back(i / 3);
        if (i % 3 == 2) mesh.triangles.emplace_back(i, i - 1, i - 2);
    }
    appendMesh(
        mesh, glm::dvec3(0),
        [](std::uint32_t atom) {
            return SphereLook{0, atom};
        },
        r);
    return r;
}

TEST(Chunks, HoldTheirPrimitives) {
    Representation r = scattered(1000);
    r.spheres[500].center.x = std::numeric_limits<float>::quiet_NaN();
    const Chunks chunks = makeChunks(r);
    ASSERT_EQ(chunks.spheres.size(), 32u);
    ASSERT_EQ(chunks.cylinders.size(), 32u);
    ASSERT_EQ(chunks.triangles.size(), 32u);
    for (std::size_t i = 0; i < r.triangles.size(); ++i) {
        const Triangle& t = r.triangles[i];
        const Chunk& c = chunks.triangles[i / Chunk::kPrimitives];
        for (const std::uint32_t v : {t.a, t.b, t.c})
            EXPECT_LE(glm::length(decodePosition(r.meshVertices[v], t.step()) - c.center), c.radius) << i;
    }
    for (std::size_t i = 0; i < r.spheres.size(); ++i) {
        const Chunk& c = chunks.spheres[i / Chunk::kPrimitives];
        if (i == 500) {
            EXPECT_EQ(c.radius, std::numeric_limits<float>::max());
        } else {
            EXPECT_LE(glm::length(r.spheres[i].center - c.center) + r.spheres[i].radius, c.radius) << i;
        }
        const Chunk& bonds = chunks.cylinders[i / Chunk::kPrimitives];
        for (const glm::vec3& end : {r.cylinders[i].a, r.cylinders[i].b})
            for (const float side : {-0.2f, 0.2f})
                EXPECT_LE(glm::length(end + glm::vec3(0, 0, side) - bonds.center), bonds.radius) << i;
    }
}

TEST(Chunks, OfTheOrderInSpaceAreSmall) {
    Representation r = scattered(20000);
    const auto mean = [](const std::vector<Chunk>& chunks) {
        double sum = 0;
        for (const Chunk& c : chunks) sum += c.radius;
        return sum / static_cast<double>(chunks.size());
    };
    const double before = mean(makeChunks(r).spheres);
    orderInSpace(r);
    const double after = mean(makeChunks(r).spheres);
    EXPECT_GT(before, 60);
    EXPECT_LT(after, 20);  // 32 of 20,000 fill a cube of 12 Å; some lie about a corner of the curve
}

TEST(OrderInSpace, KeepsRunsApartAndWhatBelongsTogether) {
    Representation r = scattered(3000);
    r.copies.lists = {{0}, {0, 1}};
    r.copies.transforms.resize(2, glm::dmat4x3(1.0));
    r.copies.spheres = {{0, 1100, 0}, {1100, 1900, 1}};
    r.sphereModels = {{0, 2000, 0}, {2000, 1000, 1}};
    for (std::size_t i = 10; i < 20; ++i) r.spheres[i] = r.spheres[9];  // at one place
    const Representation was = r;
    const std::vector<std::uint32_t> order = orderInSpace(r).spheres;
    const auto findRun = [](std::uint32_t i) { return i < 1100 ? 0 : i < 2000 ? 1 : 2; };
    std::vector<bool> there(3000, false);
    for (std::uint32_t i = 0; i < 3000; ++i) {
        EXPECT_FALSE(there[order[i]]);
        there[order[i]] = true;
        EXPECT_EQ(findRun(i), findRun(order[i]));
        EXPECT_EQ(r.spheres[i].center, was.spheres[order[i]].center);
        EXPECT_EQ(r.sphereLooks[i].atom, was.sphereLooks[order[i]].atom);
        if (i > 0 && r.spheres[i].center == r.spheres[i - 1].center) {
            EXPECT_GT(order[i], order[i - 1]);  // the last of equals is what shows
        }
        EXPECT_EQ(r.cylinders[i].a, was.cylinders[r.cylinderLooks[i].atomA].a);
    }
}

}  // namespace
}  // namespace nacre
