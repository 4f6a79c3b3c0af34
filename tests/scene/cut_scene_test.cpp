// Planes that spare some atoms cut everything else, exactly.

#include "engine/scene/view/cut_scene.h"

#include <gtest/gtest.h>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/view/keep_spheres.h"

namespace nacre {
namespace {

double measureDepth(const View& view, const glm::vec3& p) { return -(view.rotation * glm::dvec3(p)).z; }

TEST(CutScene, LeavesTheChosenAtomsAndNothingElseInFront) {
    const Molecule dna = sampleMolecule("dna");
    std::vector<bool> chosen(dna.atoms.size());
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = dna.residues[dna.atoms[i].residue].chain == 0;
    Camera camera{.rotationDegrees = {10, 70, 0}};
    Clip clip{.near = 1.5, .far = 6};
    for (const Style style : {Style::licorice, Style::surface, Style::cartoon}) {
        Representation r = represent(dna, drawnAtoms(dna), {style});
        const View view = makeView(camera, r.radius, 100, 100);
        ASSERT_TRUE(cutScene(r, view, clip, chosen));
        const auto isChosen = [&](std::uint32_t number) { return number > 0 && chosen[number - 1]; };
        bool front = false, other = false;
        const auto judge = [&](const glm::vec3& p, std::uint32_t number, double room) {
            const double depth = measureDepth(view, p);
            if (isChosen(number)) {
                front = front || depth < clip.near - 1;
                return;
            }
            other = true;
            EXPECT_GE(depth, clip.near - room);
            EXPECT_LE(depth, clip.far + room);
        };
        for (std::size_t i = 0; i < r.spheres.size(); ++i) judge(r.spheres[i].center, r.sphereLooks[i].atom, 1e-4);
        for (std::size_t i = 0; i < r.cylinders.size(); ++i) {
            const CylinderLook& look = r.cylinderLooks[i];
            if (isChosen(look.atomA) != isChosen(look.atomB)) continue;
            judge(r.cylinders[i].a, look.atomA, 0.3);  // strands are beside their bonds
            judge(r.cylinders[i].b, look.atomB, 0.3);
        }
        for (const Triangle& t : r.triangles) {
            const auto atomNumber = [&](std::uint32_t v) { return r.meshLooks[r.meshVertices[v].look].atom; };
            const bool whole = isChosen(atomNumber(t.a)) && isChosen(atomNumber(t.b)) && isChosen(atomNumber(t.c));
            for (const std::uint32_t v : {t.a, t.b, t.c})
                if (whole || !isChosen(atomNumber(v)))
                    judge(decodePosition(r.meshVertices[v], t.step()), atomNumber(v), 0.01);
        }
        EXPECT_TRUE(front && other) << static_cast<int>(style);
    }
}

TEST(CutScene, KeepsEllipsoidsAndPlainSpheresApart) {
    Representation r;
    const EllipsoidRows rows = ellipsoidRows({glm::dvec3(1, 0, 0), glm::dvec3(0, 0.5, 0), glm::dvec3(0, 0, 0.3)});
    for (std::uint32_t i = 0; i < 5; ++i) {  // the first is cut away, the last three are plain
        r.spheres.push_back({{0, 0, i == 0 ? 5.0f : -static_cast<float>(i)}, 1});
        r.sphereLooks.push_back({0xff808080u, i + 1});
    }
    r.ellipsoids = {rows, rows};
    r.radius = 6;
    Representation seen = r;
    ASSERT_TRUE(cutScene(r, makeView({}, r.radius, 100, 100), {.near = 0}, std::vector<bool>(5)));
    ASSERT_EQ(r.spheres.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(r.ellipsoid(i) != nullptr, i == 0) << i;
    keepSpheres(seen, [](std::size_t i) { return i > 1; });
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(seen.ellipsoid(i), nullptr) << i;
}

TEST(CutScene, GivesCapsTheirColour) {
    const Molecule dna = sampleMolecule("dna");
    Clip clip{.near = 0};
    for (const bool colored : {false, true}) {
        if (colored) clip.capColor = {1, 0, 0.5f};
        Representation r = represent(dna, drawnAtoms(dna), {Style::surface});
        const View view = makeView({}, r.radius, 100, 100);
        ASSERT_TRUE(cutScene(r, view, clip, std::vector<bool>(dna.atoms.size())));
        std::size_t onPlane = 0, inColor = 0;
        for (const Triangle& t : r.triangles) {
            const auto isCap = [&](std::uint32_t v) {
                const double depth = measureDepth(view, decodePosition(r.meshVertices[v], t.step()));
                return depth > 0.0005 && depth < 0.004;  // edges of what was cut are at 0
            };
            if (!isCap(t.a) || !isCap(t.b) || !isCap(t.c)) continue;
            ++onPlane;
            inColor += r.meshLooks[r.meshVertices[t.a].look].color == 0xff8000ffu;
        }
        EXPECT_GT(onPlane, 100u);
        EXPECT_EQ(inColor, colored ? onPlane : 0u);
    }
}

}  // namespace
}  // namespace nacre
