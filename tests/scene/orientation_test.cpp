#include "engine/scene/view/orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"

namespace nacre {
namespace {

using Balls = std::vector<glm::dvec4>;

/// A lump of points, three times as long as it is wide, with a tail to one side.
Balls lump(const glm::dmat3& turn) {
    Balls balls;
    for (int i = -9; i <= 9; ++i)
        for (int j = -4; j <= 4; ++j)
            for (int k = -2; k <= 2; ++k) {
                const double tail = i > 5 ? 1.5 : 1, slope = k > 0 ? 1.3 : 1;
                balls.emplace_back(turn * glm::dvec3(i * tail, j, k * slope), 1.0);
            }
    return balls;
}

/// Mean products of coordinates as the picture has them: the definition, not the algorithm.
glm::dmat3 spreadSeen(const Balls& balls, const glm::dquat& orientation) {
    glm::dvec3 mean(0);
    for (const glm::dvec4& b : balls) mean += glm::dvec3(b) / static_cast<double>(balls.size());
    glm::dmat3 spread(0.0);
    for (const glm::dvec4& b : balls) {
        const glm::dvec3 p = glm::mat3_cast(orientation) * (glm::dvec3(b) - mean);
        spread += glm::outerProduct(p, p) / static_cast<double>(balls.size());
    }
    return spread;
}

void expectSameTurn(const glm::dquat& a, const glm::dquat& b) {
    EXPECT_NEAR(std::abs(a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z), 1.0, 1e-9);
}

TEST(Orientation, LaysTheLongestAxisAcrossTheLongerSideAndTheShortestTowardsTheViewer) {
    const Balls balls = lump(rotationMatrix({33, -71, 118}));
    for (const bool wide : {true, false}) {
        const glm::dmat3 spread = spreadSeen(balls, principalOrientation(balls, wide));
        const int longest = wide ? 0 : 1, middle = wide ? 1 : 0;
        EXPECT_GT(spread[longest][longest], 2 * spread[middle][middle]);
        EXPECT_GT(spread[middle][middle], 2 * spread[2][2]);
        for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
            EXPECT_NEAR(spread[i][j], 0, 1e-10);
    }
}

TEST(Orientation, IsTheSameHoweverTheMoleculeLay) {
    const Balls straight = lump(glm::dmat3(1.0));
    for (const glm::dvec3 degrees : {glm::dvec3(10, 20, 30), glm::dvec3(180, 0, 0), glm::dvec3(0, 180, 5)}) {
        const glm::dmat3 turn = rotationMatrix(degrees);
        for (const bool wide : {true, false}) {
            const glm::dmat3 first = glm::mat3_cast(principalOrientation(straight, wide));
            const glm::dmat3 second = glm::mat3_cast(principalOrientation(lump(turn), wide)) * turn;
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) EXPECT_NEAR(first[i][j], second[i][j], 1e-9);
            EXPECT_NEAR(glm::determinant(first), 1.0, 1e-9);
        }
    }
    // The tail shows to the right: there the points reach farther.
    const glm::dquat orientation = principalOrientation(straight, true);
    EXPECT_GT((orientation * glm::dvec3(1, 0, 0)).x, 0.99);
}

TEST(Orientation, WithoutAxesTheFilesFrameStays) {
    Balls cube, rod;
    for (int i = 0; i < 8; ++i) cube.emplace_back(i & 1, i >> 1 & 1, i >> 2, 1.0);
    expectSameTurn(principalOrientation(cube, true), {1, 0, 0, 0});
    expectSameTurn(principalOrientation({glm::dvec4(3, 4, 5, 1)}, true), {1, 0, 0, 0});
    expectSameTurn(principalOrientation({}, true), {1, 0, 0, 0});
    // A rod along z lies down; about itself it stays as it was.
    for (int i = 0; i < 20; ++i) rod.emplace_back(0, 0, i, 1.0);
    const glm::dquat lying = principalOrientation(rod, true), standing = principalOrientation(rod, false);
    EXPECT_NEAR(std::abs((lying * glm::dvec3(0, 0, 1)).x), 1, 1e-9);
    EXPECT_NEAR(std::abs((standing * glm::dvec3(0, 0, 1)).y), 1, 1e-9);
}

TEST(Orientation, FacesTheOpening) {
    // A shell with a hole towards +x, and something inside that is to be seen.
    Balls all{glm::dvec4(0, 0, 0, 1)};
    for (int i = 0; i < 600; ++i) {
        const double z = 1 - (2 * i + 1) / 600.0, a = 2.399963 * i, r = std::sqrt(1 - z * z);
        const glm::dvec3 way(r * std::cos(a), r * std::sin(a), z);
        if (way.x < 0.8) all.emplace_back(way * 10.0, 1.2);
    }
    const glm::dquat turn = facingOrientation({all[0]}, all, glm::dmat3(1.0));
    EXPECT_GT((turn * glm::dvec3(1, 0, 0)).z, 0.95);
    // What stands outside is seen from outside.
    all.emplace_back(0, -14, 0, 1.0);
    const glm::dquat other = facingOrientation({all.back()}, all, glm::dmat3(1.0));
    EXPECT_GT((other * glm::dvec3(0, -1, 0)).z, 0.8);
}

TEST(Orientation, FacesTheBroadSideOfWhatIsFlat) {
    Balls disc;
    for (int i = 0; i < 24; ++i)
        for (const double r : {2.0, 5.0})
            disc.emplace_back(r * std::cos(0.2618 * i), 0.02 * r * std::sin(0.2618 * i), r * std::sin(0.2618 * i), 1.0);
    const glm::dquat turn = facingOrientation(disc, disc, glm::dmat3(1.0));
    EXPECT_GT(std::abs((turn * glm::dvec3(0, 1, 0)).z), 0.95);
}

TEST(Orientation, ClosesInOnATarget) {
    const Balls target{glm::dvec4(5, 2, 3, 1), glm::dvec4(7, 2, 3, 1)};
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        Camera camera{.projection = projection, .rotationDegrees = {20, 30, 40}};
        const View view = makeView(closeUp(camera, target, 20, 3, 1e4), 20, 800, 600);
        const glm::dvec3 middle = view.rotation * glm::dvec3(6, 2, 3);
        const double magnify = view.eyeDistance > 0 ? view.eyeDistance / (view.eyeDistance - middle.z) : 1;
        EXPECT_NEAR(middle.x * magnify + view.pan.x, 0, 1e-9);
        EXPECT_NEAR(middle.y * magnify + view.pan.y, 0, 1e-9);
        const double whole = makeView(Camera{.projection = projection}, 20, 800, 600).pixelsPerAngstrom;
        EXPECT_NEAR(view.pixelsPerAngstrom * magnify, whole * 20 / 5, 1e-6);  // 2 Å of it, 3 around
    }
}

TEST(Orientation, FillsThePicture) {
    const Balls balls = lump(rotationMatrix({33, -71, 118}));
    Representation scene;
    for (const glm::dvec4& ball : balls) scene.spheres.push_back({glm::vec3(ball), static_cast<float>(ball.w)});
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        Camera camera{.projection = projection, .orientation = principalOrientation(balls, true)};
        for (const double zoom : {1.0, 0.5}) {
            camera.zoom = zoom;
            const View view = makeView(fitted(camera, scene, nullptr, 25, 900, 300, 1e4), 25, 900, 300);
            glm::dvec2 most(0);
            for (const glm::dvec4& ball : balls) {
                const glm::dvec3 v = view.rotation * glm::dvec3(ball);
                const double magnify = view.eyeDistance > 0 ? view.eyeDistance / (view.eyeDistance - v.z) : 1;
                const glm::dvec2 reach = glm::abs(glm::dvec2(v)) + ball.w;
                most = glm::max(most, (reach * magnify + view.pan * glm::sign(glm::dvec2(v))) * view.pixelsPerAngstrom);
            }
            EXPECT_LE(most.x, 0.95 * 450 * zoom + 1e-3);
            EXPECT_LE(most.y, 0.95 * 150 * zoom + 1e-3);
            EXPECT_TRUE(most.x > 0.94 * 450 * zoom || most.y > 0.94 * 150 * zoom) << most.x << " " << most.y;
        }
    }
}

TEST(Orientation, KnowsTheAtomsOfAScene) {
    const Molecule dna = sampleMolecule("dna");
    const Representation scene = represent(dna, drawnAtoms(dna, {}), {});
    std::vector<bool> chosen(dna.atoms.size());
    chosen[10] = true;
    const Balls one = chosenBalls(scene, chosen);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_NEAR(glm::distance(glm::dvec3(one[0]) + scene.center, glm::dvec3(dna.atoms[10].position)), 0, 1e-4);
    EXPECT_EQ(drawnBalls(scene).size(), scene.drawnAtoms);
}

TEST(Orientation, KnowsTheAtomsOfLines) {
    const Molecule dna = sampleMolecule("dna");
    const Representation scene = represent(dna, drawnAtoms(dna, {}), RepresentationOptions{.style = Style::line});
    std::vector<bool> chosen(dna.atoms.size());
    chosen[10] = true;
    const Balls ends = chosenBalls(scene, chosen);
    ASSERT_FALSE(ends.empty());  // one for each bond
    for (const glm::dvec4& end : ends)
        EXPECT_NEAR(glm::distance(glm::dvec3(end) + scene.center, glm::dvec3(dna.atoms[10].position)), 0, 1e-4);
    EXPECT_EQ(drawnBalls(scene).size(), 2 * scene.wires.size());
}

TEST(Orientation, ShowsCartoonsAndSurfacesWhole) {
    const Molecule dna = sampleMolecule("dna");
    const Representation scene = represent(dna, drawnAtoms(dna, {}), RepresentationOptions{.style = Style::cartoon});
    ASSERT_FALSE(scene.triangles.empty());
    const Balls balls = drawnBalls(scene);
    double most = 0;  // the radius of the scene is that of what is drawn
    for (const glm::dvec4& ball : balls) most = std::max(most, glm::length(glm::dvec3(ball)) + ball.w);
    EXPECT_NEAR(most, scene.radius, 1e-3);
    // Of one residue, what has its numbers: near its atoms.
    const Residue& residue = dna.residues[5];
    std::vector<bool> chosen(dna.atoms.size());
    for (std::uint32_t i = 0; i < residue.atomCount; ++i) chosen[residue.firstAtom + i] = true;
    const Balls some = chosenBalls(scene, chosen);
    ASSERT_GT(some.size(), 20u);
    EXPECT_LT(some.size(), balls.size() / 10);
    for (const glm::dvec4& ball : some) {
        double nearest = 1e9;
        for (std::uint32_t i = 0; i < residue.atomCount; ++i)
            nearest = std::min(nearest, glm::distance(glm::dvec3(ball) + scene.center,
                                                      glm::dvec3(dna.atoms[residue.firstAtom + i].position)));
        EXPECT_LT(nearest, 4.0);
    }
}

TEST(Orientation, SurfacesHideAsAtomsDo) {
    // Vertices are balls without a radius: a sheet of them before an atom, and one beside it.
    const Balls atom{{0, 0, 0, 1.5}};
    Balls before = atom, beside = atom;
    for (double x = -3; x <= 3; x += 0.5)
        for (double y = -3; y <= 3; y += 0.5) {
            before.emplace_back(x, y, 4, 0);
            beside.emplace_back(x + 8, y, 4, 0);
        }
    EXPECT_EQ(hiddenShare(atom, before, glm::dmat3(1)), 1);
    EXPECT_EQ(hiddenShare(atom, beside, glm::dmat3(1)), 0);
    EXPECT_EQ(hiddenShare(atom, before, glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, -1)), 0) << "it lies behind now";
}

}  // namespace
}  // namespace nacre
