#pragma once
// What tests of the tiles' lists look at, and what they ask them.

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>
#include <set>
#include <vector>

#include "engine/software/tile_lists.h"

namespace nacre::test {

struct ListedScene {
    std::vector<Sphere> spheres;
    std::vector<Cylinder> cylinders;
    std::vector<glm::vec4> rows;
    std::vector<TileCall> sphereCalls, cylinderCalls;
    Representation mesh;
    std::vector<Chunk> chunks;
    std::vector<TileCall> triangleCalls;
    TileView view;

    TileScenery scenery() const {
        return {
            spheres,       sphereCalls,          cylinders,   cylinderCalls, {},    mesh.triangles, mesh.meshVertices,
            triangleCalls, mesh.coarseTriangles, mesh.meshes, nullptr,       chunks};
    }
};

class RandomNumbers {
public:
    explicit RandomNumbers(std::uint32_t seed) : engine_(seed) {}
    double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    glm::dvec3 within(double reach) { return {(*this)(-reach, reach), (*this)(-reach, reach), (*this)(-reach, reach)}; }

private:
    std::mt19937 engine_;
};

/// Two meshes of triangles large and small, in two steps.
inline void addTriangles(RandomNumbers& number, ListedScene& s) {
    for (const double reach : {8.0, 2.5}) {
        Mesh mesh;
        for (std::uint32_t i = 0; i < 20; ++i) {
            mesh.positions.push_back(glm::vec3(number.within(reach)));
            mesh.normals.emplace_back(0, 0, 1);
            mesh.atoms.push_back(0);
            if (i >= 2) mesh.triangles.emplace_back(i, i - 1, i - 2);
        }
        appendMesh(
            mesh, glm::dvec3(0), [](std::uint32_t) { return SphereLook{}; }, s.mesh);
    }
}

/// Balls, sticks and triangles of many sizes at the places of one to three copies, seen from anywhere, zoomed in or
/// out.
inline ListedScene randomListedScene(std::uint32_t seed, bool perspective, int quarterTurns) {
    RandomNumbers number(seed);
    ListedScene s;
    for (int i = 0; i < 40; ++i)
        s.spheres.push_back({glm::vec3(number.within(8)), static_cast<float>(std::exp(number(-4, 1)))});
    for (int i = 0; i < 25; ++i) {
        const glm::dvec3 a = number.within(8);
        s.cylinders.push_back(
            {glm::vec3(a), static_cast<float>(std::exp(number(-4, 0))), glm::vec3(a + number.within(3)), 0});
    }
    addTriangles(number, s);
    s.chunks = makeChunks(s.mesh).triangles;
    const int copies = static_cast<int>(number(1, 3.99));
    for (int c = 0; c < copies; ++c) {
        const glm::dmat3 turn =
            glm::mat3_cast(glm::normalize(glm::dquat(number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1))));
        const glm::dvec3 shift = number.within(4);
        for (int i = 0; i < 3; ++i) s.rows.emplace_back(turn[0][i], turn[1][i], turn[2][i], shift[i]);
    }
    for (int c = 0; c < copies; ++c) {
        const auto base = static_cast<std::uint32_t>(200 * c + 1);
        s.sphereCalls.push_back({&s.rows[static_cast<std::size_t>(3 * c)], 5, 35, base});
        s.cylinderCalls.push_back({&s.rows[static_cast<std::size_t>(3 * c)], 0, 25, base + 40});
        s.triangleCalls.push_back({&s.rows[static_cast<std::size_t>(3 * c)], 3, 30, base + 65});
    }
    TileView& v = s.view;
    v.width = static_cast<std::uint32_t>(number(20, 150));
    v.height = static_cast<std::uint32_t>(number(20, 150));
    v.perspective = perspective;
    v.quarterTurns = quarterTurns;
    v.centers = seed % 2 == 0;
    v.pixels = static_cast<float>(std::exp(number(-0.5, 3)));
    v.axis = {static_cast<float>(v.width * number(0, 1)), static_cast<float>(v.height * number(0, 1))};
    constexpr float kRadius = 24;
    v.origin = perspective ? kRadius * 3 : kRadius;
    v.nearest = v.origin - kRadius - 1;
    v.range = 2 * (kRadius + 1);
    return s;
}

inline std::vector<std::uint32_t> writeLists(TileLists& lists) {
    std::vector<std::uint32_t> words(lists.words());
    lists.write(words.data());
    return {words.end() - static_cast<std::ptrdiff_t>(lists.entries()), words.end()};
}

/// The triangle that each pixel begins with, row by row; 0: none, and where lists begin with none.
inline std::vector<std::uint32_t> listSeeds(const TileLists& lists, const TileView& v) {
    std::vector<std::uint32_t> seeds(std::size_t{v.width} * v.height, 0);
    for (std::uint32_t y = 0; lists.seeded() && y < v.height; ++y)
        lists.writeSeeds(0, y, v.width, seeds.data() + std::size_t{y} * v.width);
    return seeds;
}

/// All that may be seen somewhere.
inline std::set<std::uint32_t> namedBy(TileLists& lists, const TileView& v) {
    const std::vector<std::uint32_t> numbers = writeLists(lists), seeds = listSeeds(lists, v);
    std::set<std::uint32_t> named(numbers.begin(), numbers.end());
    named.insert(seeds.begin(), seeds.end());
    named.erase(0);
    return named;
}

inline constexpr glm::vec4 kUnturned[] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

/// Of 16 x 16 pixels, an angstrom each.
inline TileView smallView() {
    TileView v;
    v.width = v.height = 16;
    v.axis = glm::vec2(8);
    v.origin = 4;
    v.range = 8;
    return v;
}

}  // namespace nacre::test
