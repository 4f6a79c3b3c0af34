#pragma once
// Meshes that tests make themselves.

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre::test {

/// A ball of triangles: an icosahedron whose faces are halved `levels` times.
inline Mesh icosphere(const glm::vec3& center, float radius, int levels, std::uint32_t atom) {
    const float t = (1 + std::sqrt(5.0f)) / 2;
    std::vector<glm::vec3> at = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                                 {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    std::vector<glm::uvec3> faces = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (glm::vec3& p : at) p = glm::normalize(p);
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [known, added] = middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(at.size()));
            if (added) at.push_back(glm::normalize(at[a] + at[b]));
            return known->second;
        };
        std::vector<glm::uvec3> finer;
        for (const glm::uvec3& f : faces) {
            const std::uint32_t ab = middle(f.x, f.y), bc = middle(f.y, f.z), ca = middle(f.z, f.x);
            for (const glm::uvec3& part : {glm::uvec3(f.x, ab, ca), {f.y, bc, ab}, {f.z, ca, bc}, {ab, bc, ca}})
                finer.push_back(part);
        }
        faces = std::move(finer);
    }
    Mesh mesh;
    for (const glm::vec3& p : at) {
        mesh.positions.push_back(center + radius * p);
        mesh.normals.push_back(p);
    }
    mesh.atoms.assign(at.size(), atom);
    mesh.triangles = faces;
    return mesh;
}

/// A closed tube along a helix, about as a cartoon of a helix is: `residues` atoms, numbered from 0, one after another.
inline Mesh helixTube(float radius, float tube, float rise, std::uint32_t residues, std::uint32_t stepsEach = 8,
                      std::uint32_t around = 12) {
    Mesh mesh;
    const std::uint32_t rings = residues * stepsEach + 1;
    const auto path = [&](float u) {  // residues
        const float angle = u * std::numbers::pi_v<float> / 1.8f;
        return glm::vec3(radius * std::cos(angle), radius * std::sin(angle),
                         rise * (u - 0.5f * static_cast<float>(residues)));
    };
    for (std::uint32_t i = 0; i < rings; ++i) {
        const float u = static_cast<float>(i) / static_cast<float>(stepsEach);
        const glm::vec3 along = glm::normalize(path(u + 0.01f) - path(u - 0.01f));
        const glm::vec3 side = glm::normalize(glm::cross(along, glm::vec3(0, 0, 1))), up = glm::cross(side, along);
        for (std::uint32_t k = 0; k < around; ++k) {
            const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(around);
            const glm::vec3 n = side * std::cos(angle) + up * std::sin(angle);
            mesh.positions.push_back(path(u) + tube * n);
            mesh.normals.push_back(n);
            mesh.atoms.push_back(std::min(i / stepsEach, residues - 1));
        }
    }
    for (std::uint32_t i = 0; i + 1 < rings; ++i)
        for (std::uint32_t k = 0; k < around; ++k) {
            const std::uint32_t a = i * around + k, b = i * around + (k + 1) % around, c = a + around, d = b + around;
            mesh.triangles.push_back({a, c, b});
            mesh.triangles.push_back({b, c, d});
        }
    for (const std::uint32_t first : {0u, (rings - 1) * around}) {  // flat ends
        const bool end = first > 0;
        const auto base = static_cast<std::uint32_t>(mesh.positions.size());
        const glm::vec3 along = path(1.01f + (end ? static_cast<float>(residues) - 1 : -1.0f)) -
                                path(0.99f + (end ? static_cast<float>(residues) - 1 : -1.0f));
        for (std::uint32_t k = 0; k < around; ++k) {
            mesh.positions.push_back(mesh.positions[first + k]);
            mesh.normals.push_back(glm::normalize(along) * (end ? 1.0f : -1.0f));
            mesh.atoms.push_back(mesh.atoms[first]);
        }
        for (std::uint32_t k = 1; k + 1 < around; ++k)
            mesh.triangles.push_back(end ? glm::uvec3(base, base + k + 1, base + k)
                                         : glm::uvec3(base, base + k, base + k + 1));
    }
    return mesh;
}

inline SphereLook testLook(std::uint32_t atom) {
    const auto channel = [&](std::uint32_t of) { return 64 + atom * of % 192; };
    return {0xff000000u | channel(67) | channel(131) << 8 | channel(29) << 16, atom + 1};
}

/// A tube, a ball of triangles that cuts into it, and round and straight primitives among them.
inline Representation meshScene(bool others = true) {
    Representation r;
    appendMesh(helixTube(4, 1.2f, 1.5f, 9), glm::dvec3(0), testLook, r);
    appendMesh(icosphere({3.5f, 2, -1}, 2.5f, 3, 20), glm::dvec3(0), testLook, r);
    if (others) {
        for (std::uint32_t i = 0; i < 6; ++i) {
            const float angle = static_cast<float>(i);
            r.spheres.push_back({{4.3f * std::cos(angle), 4.3f * std::sin(angle), 2.0f * angle - 5}, 1.4f});
            r.sphereLooks.push_back(testLook(30 + i));
        }
        r.cylinders.push_back({{-6, -5, -4}, 0.5f, {6, 5, 4}, 0});
        r.cylinderLooks.push_back({testLook(40).color, testLook(41).color, 41, 42});
    }
    r.radius = 10;
    r.drawnAtoms = 42;
    return r;
}

/// Where a view puts the vertices of a scene's triangles, in ångströms.
inline std::vector<glm::dvec3> turnedVertices(const Representation& r, const View& view) {
    std::vector<glm::dvec3> turned(r.meshVertices.size());
    for (const Triangle& t : r.triangles)
        for (const std::uint32_t i : {t.a, t.b, t.c})
            turned[i] = view.rotation * glm::dvec3(decodePosition(r.meshVertices[i], t.step()));
    return turned;
}

}  // namespace nacre::test
