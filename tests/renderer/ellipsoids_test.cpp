// Ellipsoids in pictures, beside their quadrics: the same on every path.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/molecule/displacement.h"
#include "tests/reference/displacements.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

Representation ellipsoidScene(const Molecule& m, EllipsoidForm form = EllipsoidForm::bands,
                              const std::string& assembly = "") {
    RepresentationOptions look{.style = Style::ellipsoids, .ellipsoids = form};
    look.assembly = assembly;
    return represent(m, drawnAtoms(m), look);
}

/// Flat, long and round ones without bonds, that do not overlap.
Molecule apartEllipsoids() {
    Molecule m = readMolecule("apart.xyz", "4\n\nC 0 0 0\nC 2.6 0 0.3\nC 0 2.6 -0.4\nC 2.6 2.6 0\n");
    for (const glm::dvec3& squares : {glm::dvec3(0.3, 0.03, 0.02), glm::dvec3(0.25, 0.2, 0.015),
                                      glm::dvec3(0.2, 0.08, 0.03), glm::dvec3(0.13, 0.1, 0.08)}) {
        const double s = static_cast<double>(m.displacements.size());
        const glm::dvec3 x = glm::normalize(glm::dvec3(std::cos(s), 1, std::sin(2 * s))),
                         y = glm::normalize(glm::cross(x, glm::dvec3(0.3, -1, s))), z = glm::cross(x, y);
        const glm::dmat3 turn(x, y, z);
        m.displacements.push_back(toDisplacement(
            turn * glm::dmat3({squares.x, 0, 0}, {0, squares.y, 0}, {0, 0, squares.z}) * glm::transpose(turn)));
    }
    return m;
}

/// Where the ray of a pixel is in view space: a point, and its direction away from the viewer.
struct Ray {
    glm::dvec3 from, way;
};
Ray rayOf(const View& view, double x, double y) {
    const glm::dvec2 q((x - view.width / 2.0) / view.pixelsPerAngstrom,
                       (view.height / 2.0 - y) / view.pixelsPerAngstrom);
    if (view.projection == Projection::orthographic) return {{q.x, q.y, 0}, {0, 0, -1}};
    const glm::dvec3 eye(0, 0, view.eyeDistance);
    return {eye, glm::normalize(glm::dvec3(q.x, q.y, 0) - eye)};
}

/// How far inside an ellipsoid's silhouette a ray passes: 1 through the centre, 0 on it, negative outside.
double depthInside(const Ray& ray, const glm::dvec3& center, const glm::dmat3& quadric) {
    const glm::dvec3 d = ray.from - center;
    const double a = glm::dot(ray.way, quadric * ray.way), b = glm::dot(d, quadric * ray.way),
                 c = glm::dot(d, quadric * d);
    return 1 - std::sqrt(c - b * b / a);
}

TEST(EllipsoidPictures, HaveTheSilhouettesAndDepthsOfTheQuadrics) {
    const Molecule m = apartEllipsoids();
    const Representation r = ellipsoidScene(m);
    const double scale = probabilityScale(50);
    ValidatedRenderer renderer(Visibility::automatic, r);
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        const RenderSettings s = settings(r, 500, projection);
        const LayerPicture picture = renderer->layers(s);
        std::size_t covered = 0, wrong = 0;
        double farthest = 0, leastCosine = 1;
        for (std::uint32_t i = 0; i < picture.id.size(); ++i) {
            const Ray ray = rayOf(s.view, i % 500 + 0.5, i / 500 + 0.5);
            double deepest = -10;
            for (std::size_t k = 0; k < m.atoms.size(); ++k) {
                const glm::dmat3 quadric = glm::inverse(s.view.rotation * tensorMatrix(m.displacements[k]) *
                                                        glm::transpose(s.view.rotation) * scale * scale);
                const glm::dvec3 center = s.view.seen(glm::dvec3(m.atoms[k].position) - r.center);
                deepest = std::max(deepest, depthInside(ray, center, quadric));
                if (picture.id[i] != k + 1) continue;
                const glm::dvec3 at =
                    projection == Projection::orthographic
                        ? glm::dvec3(ray.from.x, ray.from.y, s.view.radius - static_cast<double>(picture.z[i]))
                        : ray.from + ray.way * (static_cast<double>(picture.z[i]) / -ray.way.z);
                const double size = std::sqrt(glm::dot(at - center, quadric * (at - center)));
                // Near the silhouette depth changes faster than it is stored.
                if (deepest > 1e-3) farthest = std::max(farthest, std::abs(size - 1));
                const glm::dvec3 normal(picture.normal[3 * i], picture.normal[3 * i + 1], picture.normal[3 * i + 2]);
                const double cosine = glm::dot(normal, glm::normalize(quadric * (at - center)));
                if (deepest > 1e-2) leastCosine = std::min(leastCosine, cosine);
            }
            covered += deepest > 0;
            wrong += std::abs(deepest) > 2e-6 && (deepest > 0) != (picture.id[i] > 0);
        }
        EXPECT_GT(covered, 20'000u);
        EXPECT_EQ(wrong, 0u);
        EXPECT_LT(farthest, 1e-3);
        EXPECT_GT(leastCosine, 1 - 1e-5);
    }
}

/// The facing octant of each ellipsoid is empty, and what shows there lies in its principal planes.
TEST(EllipsoidPictures, LackTheOctantsThatFaceTheViewer) {
    const Molecule m = apartEllipsoids();
    const Representation r = ellipsoidScene(m, EllipsoidForm::octants);
    const double scale = probabilityScale(50);
    ValidatedRenderer renderer(Visibility::automatic, r);
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        const RenderSettings s = settings(r, 400, projection, {70, -40, 15});
        const LayerPicture picture = renderer->layers(s);
        std::size_t inOctant = 0, onFaces = 0, elsewhere = 0;
        for (std::uint32_t i = 0; i < picture.id.size(); ++i) {
            if (picture.id[i] == 0) continue;
            const std::size_t k = picture.id[i] - 1;
            const Ray ray = rayOf(s.view, i % 400 + 0.5, i / 400 + 0.5);
            const glm::dvec3 center = s.view.seen(glm::dvec3(m.atoms[k].position) - r.center);
            const glm::dvec3 at =
                (projection == Projection::orthographic
                     ? glm::dvec3(ray.from.x, ray.from.y, s.view.radius - static_cast<double>(picture.z[i]))
                     : ray.from + ray.way * (static_cast<double>(picture.z[i]) / -ray.way.z)) -
                center;
            const glm::dvec3 toEye = projection == Projection::orthographic
                                         ? glm::dvec3(0, 0, 1)
                                         : glm::dvec3(0, 0, s.view.eyeDistance) - center;
            double least = 1, square = 0;
            for (const glm::dvec3& own : *displacementAxes(m.displacements[k])) {
                const glm::dvec3 axis = s.view.rotation * own * scale;
                const double share = glm::dot(at, axis) / glm::dot(axis, axis);
                square += share * share;
                least = std::min(least, share * (glm::dot(toEye, axis) < 0 ? -1 : 1));
            }
            inOctant += least > 1e-3;
            if (std::abs(least) < 1e-3 && square < 0.98)
                ++onFaces;
            else if (std::abs(square - 1) > 0.05)
                ++elsewhere;
        }
        EXPECT_EQ(inOctant, 0u);
        EXPECT_GT(onFaces, 3000u);
        EXPECT_EQ(elsewhere, 0u);
    }
}

TEST(EllipsoidPictures, AreTheSameOnEveryPath) {
    PathRenderers renderers;
    Molecule m = glucoseWithTensors();
    m.displacements.resize(16);
    m.displacements.resize(m.atoms.size());
    for (const EllipsoidForm form : {EllipsoidForm::bands, EllipsoidForm::octants})
        for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
            const Representation r = ellipsoidScene(m, form);
            RenderSettings s = settings(r, 140, projection, {10, 0, 5});
            s.occlusion.directions = 8;
            s.effects.contours.width = 1;
            if (projection == Projection::perspective) s.effects.clip.near = -0.2;  // through atoms: caps
            sameOnEveryPath(renderers, r, s);
        }
}

/// A copy that is turned, and one that is a mirror image, look like a molecule that is.
TEST(EllipsoidPictures, TurnWithTheirCopies) {
    ValidatedRenderer renderer(Visibility::automatic);
    Molecule m = apartEllipsoids();
    m.subchains = {"A"};
    for (const float side : {1.0f, -1.0f}) {
        const glm::mat3 turn = glm::mat3(rotationMatrix({20, 70, -30})) * side;
        m.assemblies = {{"1", "", {{{}, {0}}}}};
        m.assemblies[0].parts[0].transforms = {glm::mat4x3(turn[0], turn[1], turn[2], glm::vec3(1, 2, 3))};
        Molecule moved = m;
        for (std::size_t i = 0; i < m.atoms.size(); ++i) {
            moved.atoms[i].position = turn * m.atoms[i].position + glm::vec3(1, 2, 3);
            turnDisplacement(moved, i, glm::dmat3(turn));
        }
        for (const EllipsoidForm form : {EllipsoidForm::bands, EllipsoidForm::octants}) {
            const Representation copy = ellipsoidScene(m, form, "1"), own = ellipsoidScene(moved, form);
            const RenderSettings s = settings(own, 300, Projection::perspective);
            renderer->setScene(copy);
            const LayerPicture a = renderer->layers(s);
            renderer->setScene(own);
            const LayerPicture b = renderer->layers(s);
            std::size_t differing = 0, covered = 0;
            for (std::size_t i = 0; i < a.id.size(); ++i) {
                covered += b.id[i] > 0;
                differing += a.id[i] != b.id[i] || (a.id[i] > 0 && std::abs(a.z[i] - b.z[i]) > 1e-3f);
            }
            EXPECT_GT(covered, 4000u);
            EXPECT_LT(differing, covered / 200);
        }
    }
}

TEST(EllipsoidPictures, OfOctantsDifferFromBandsWhereTheViewerLooksIn) {
    const Molecule m = glucoseWithTensors();
    ValidatedRenderer renderer(Visibility::automatic);
    std::vector<LayerPicture> pictures;
    for (const EllipsoidForm form : {EllipsoidForm::bands, EllipsoidForm::octants}) {
        const Representation r = ellipsoidScene(m, form);
        renderer->setScene(r);
        pictures.push_back(renderer->layers(settings(r, 300, Projection::orthographic, {0, 0, 0})));
    }
    std::size_t deeper = 0, nearer = 0, seen = 0;
    for (std::size_t i = 0; i < pictures[0].id.size(); ++i) {
        seen += pictures[0].id[i] > 0;
        deeper += pictures[1].z[i] > pictures[0].z[i] + 0.01f;
        nearer += pictures[1].z[i] < pictures[0].z[i] - 0.01f;
    }
    EXPECT_GT(deeper, seen / 20);
    EXPECT_EQ(nearer, 0u);
}

/// A shadow falls into a cut as if the light saw it: faces that no atom shades are as bright as without shadows.
TEST(EllipsoidPictures, LightReachesTheFacesOfCuts) {
    Molecule m = apartEllipsoids();  // larger, so that the shadows' soft edges are narrow
    for (Atom& atom : m.atoms) atom.position *= 5.0f;
    for (Displacement& u : m.displacements) u = toDisplacement(tensorMatrix(u) * 25.0);
    const Representation r = ellipsoidScene(m, EllipsoidForm::octants);
    ValidatedRenderer renderer(Visibility::automatic, r);
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        RenderSettings s = settings(r, 300, projection, {0, 0, 0});
        const LayerPicture plain = renderer->layers(s);
        s.effects.shadow.strength = 1;
        const LayerPicture shaded = renderer->layers(s);
        std::size_t darker = 0, seen = 0;
        for (std::size_t i = 0; i < plain.id.size(); ++i) {
            seen += plain.id[i] > 0;
            darker += plain.rgba[4 * i] > shaded.rgba[4 * i] + 0.02f;
        }
        EXPECT_LT(darker, 3 * seen / 20);
    }
}

}  // namespace
}  // namespace nacre::test
