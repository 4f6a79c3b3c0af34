// Caps of clipped meshes, judged by rays through the meshes: a point of the plane is on a cap if the ray from it away
// from the viewer leaves the mesh once more than it enters.

#include "engine/scene/build/mesh_caps.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>
#include <random>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"

namespace nacre {
namespace {

using Corners = std::array<glm::dvec3, 3>;

std::vector<Corners> collectTriangles(const Representation& r, const glm::dmat3& rotation, bool surfaces) {
    std::vector<Corners> corners;
    for (const MeshRun& mesh : r.meshes) {
        if (mesh.surface != surfaces) continue;
        for (std::uint32_t i = mesh.first; i < mesh.first + mesh.count; ++i) {
            const Triangle& t = r.triangles[i];
            const auto at = [&](std::uint32_t v) {
                return rotation * glm::dvec3(decodePosition(r.meshVertices[v], t.step()));
            };
            corners.push_back({at(t.a), at(t.b), at(t.c)});
        }
    }
    return corners;
}

/// Height at which a line along z meets a triangle, if it does, and whether it is seen from its front.
std::optional<std::pair<double, bool>> meets(const Corners& t, const glm::dvec2& p) {
    const auto side = [&](const glm::dvec3& a, const glm::dvec3& b) {
        return (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x);
    };
    const double ofA = side(t[1], t[2]), ofB = side(t[2], t[0]), ofC = side(t[0], t[1]), sum = ofA + ofB + ofC;
    const bool inside = (ofA >= 0 && ofB >= 0 && ofC >= 0) || (ofA <= 0 && ofB <= 0 && ofC <= 0);
    if (!inside || sum == 0) return std::nullopt;
    return std::pair((ofA * t[0].z + ofB * t[1].z + ofC * t[2].z) / sum, sum > 0);
}

/// How often the mesh is around a point of the plane.
int windingAt(const std::vector<Corners>& mesh, const glm::dvec2& p, double height) {
    int winding = 0;
    for (const Corners& t : mesh)
        if (const auto hit = meets(t, p); hit && hit->first < height) winding += hit->second ? -1 : 1;
    return winding;
}

class MeshCaps : public testing::TestWithParam<std::pair<Style, Projection>> {};

TEST_P(MeshCaps, CoverWhatIsInside) {
    const Molecule dna = sampleMolecule("dna");
    const Representation r = represent(dna, drawnAtoms(dna), {GetParam().first});
    const bool surface = GetParam().first == Style::surface;
    Camera camera{.projection = GetParam().second, .rotationDegrees = {20, 35, 10}};
    const View view = makeView(camera, r.radius, 100, 100);
    std::mt19937 dice(7);
    for (const double near : {-6.0, 0.0, 4.3}) {
        Clip clip{.near = near};
        ASSERT_TRUE(needsCaps(r, clip));
        const Representation caps = meshCaps(r, view, clip);
        ASSERT_FALSE(caps.triangles.empty());
        const std::vector<Corners> mesh = collectTriangles(r, view.rotation, surface),
                                   cap = collectTriangles(caps, view.rotation, false);
        for (const Corners& t : cap)
            for (const glm::dvec3& corner : t) {  // just behind the plane, as shaders expect it
                EXPECT_GE(-near - corner.z, 0);
                EXPECT_LT(-near - corner.z, 0.004);
            }
        std::uniform_real_distribution<double> place(-r.radius, r.radius);
        int inside = 0, wrong = 0;
        constexpr int kPoints = 3000;
        for (int i = 0; i < kPoints; ++i) {
            const glm::dvec2 p(place(dice), place(dice));
            const bool within = windingAt(mesh, p, -near) > 0;
            const bool covered = std::ranges::any_of(cap, [&](const Corners& t) { return meets(t, p).has_value(); });
            inside += within;
            wrong += within != covered;
        }
        EXPECT_GT(inside, 10);
        EXPECT_LE(wrong, 2) << "of " << inside;  // at the rim, by rounding
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, MeshCaps,
                         testing::Values(std::pair(Style::surface, Projection::orthographic),
                                         std::pair(Style::surface, Projection::perspective),
                                         std::pair(Style::cartoon, Projection::orthographic)));

TEST(MeshCapsOf, SurfacesHaveTheNearestAtoms) {
    const Molecule dna = sampleMolecule("dna");
    const Representation r = represent(dna, drawnAtoms(dna), {Style::surface});
    const View view = makeView({}, r.radius, 100, 100);
    const Representation caps = meshCaps(r, view, Clip{.near = 0});
    int wrong = 0;
    for (const MeshVertex& vertex : caps.meshVertices) {
        const glm::dvec3 place = glm::dvec3(decodePosition(vertex, caps.triangles.front().step())) + r.center;
        double least = 1e9;
        std::uint32_t nearest = 0;
        for (const SurfaceAtom& atom : r.surfaceAtoms) {
            const double distance =
                glm::distance(place, glm::dvec3(atom.center) + r.center) - static_cast<double>(atom.radius);
            if (distance < least) least = distance, nearest = atom.look.atom;
        }
        wrong += caps.meshLooks[vertex.look].atom != nearest;
    }
    EXPECT_LE(wrong, static_cast<int>(caps.meshVertices.size() / 500));  // ties
}

TEST(MeshCapsOf, OpenAndTranslucentMeshesHaveNone) {
    const Molecule dna = sampleMolecule("dna");
    RepresentationOptions options{.style = Style::surface, .surfaceOpacity = 0.5};
    const Representation r = represent(dna, drawnAtoms(dna), options);
    Clip clip;
    EXPECT_FALSE(needsCaps(represent(dna, drawnAtoms(dna), {Style::surface}), clip));
    clip.near = 0;
    EXPECT_FALSE(needsCaps(r, clip));
    EXPECT_TRUE(meshCaps(r, makeView({}, r.radius, 100, 100), clip).triangles.empty());
}

}  // namespace
}  // namespace nacre
