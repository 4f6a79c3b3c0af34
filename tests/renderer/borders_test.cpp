// Borders of colours on surfaces: where two atoms are equally near, and not along the triangles' edges.

#include <glm/geometric.hpp>

#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct Misfit {
    std::size_t pixels = 0, wrong = 0;  ///< whose atom is farther than the nearest one by 0.1 Å
    double mean = 0;                    ///< Å by which the drawn atom is farther than the nearest one
};

/// Judges each pixel by the distances of its drawn point from the spheres of all atoms.
Misfit measureMisfit(const Representation& r, const LayerPicture& layers, const View& view) {
    Misfit misfit;
    for (std::uint32_t y = 0; y < layers.height; ++y)
        for (std::uint32_t x = 0; x < layers.width; ++x) {
            const std::size_t i = std::size_t{y} * layers.width + x;
            if (layers.id[i] == 0) continue;
            const glm::dvec3 seen((x + 0.5 - view.width / 2.0) / view.pixelsPerAngstrom,
                                  (view.height / 2.0 - y - 0.5) / view.pixelsPerAngstrom,
                                  view.radius - static_cast<double>(layers.z[i]));
            const glm::dvec3 place = glm::transpose(view.rotation) * seen;
            double nearest = 1e9, drawn = 1e9;
            for (const SurfaceAtom& atom : r.surfaceAtoms) {
                const double height = glm::distance(place, glm::dvec3(atom.center)) - static_cast<double>(atom.radius);
                nearest = std::min(nearest, height);
                if (atom.look.atom == layers.id[i]) drawn = height;
            }
            ++misfit.pixels;
            misfit.wrong += drawn - nearest > 0.1;
            misfit.mean += drawn - nearest;
        }
    misfit.mean /= static_cast<double>(misfit.pixels);
    return misfit;
}

TEST(Borders, RunWhereTwoAtomsAreEquallyNear) {
    const Representation r = scene("sample:dna", Style::surface);
    Representation plain = r;  // whose borders follow the triangles
    for (Triangle& t : plain.triangles) t = Triangle(t.a, t.b, t.c, t.step());
    const RenderSettings s = settings(r, 120, Projection::orthographic, {20, 30, 10}, 2);
    LayerPicture first;
    for (const Visibility path : devicePaths()) {
        ValidatedRenderer renderer(path, r);
        const LayerPicture layers = renderer->layers(s);
        if (first.id.empty()) first = layers;
        EXPECT_TRUE(layers.id == first.id) << visibilityName(path);
    }
    ValidatedRenderer renderer(Visibility::tiles, plain);
    const Misfit exact = measureMisfit(r, first, s.view), stairs = measureMisfit(r, renderer->layers(s), s.view);
    ASSERT_GT(exact.pixels, 7'000u);
    EXPECT_LT(exact.mean, 0.01);
    EXPECT_LT(exact.mean, 0.6 * stairs.mean) << stairs.mean;
    EXPECT_LT(exact.wrong, 0.6 * static_cast<double>(stairs.wrong)) << stairs.wrong;
}

/// A square of two triangles whose left corners belong to atom 1 and whose right ones to atom 2.
Mesh square(float marginLeft, float marginRight) {
    Mesh mesh;
    mesh.positions = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.atoms = {0, 1, 1, 0};
    mesh.margins = {marginLeft, marginRight, marginRight, marginLeft};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

TEST(Borders, DivideEdgesByTheMarginsOfTheirEnds) {
    PathRenderers renderers;
    for (const auto& [left, right, border] :
         {std::tuple(1.0f, 1.0f, 0.0), {1.0f, 3.0f, -2.5}, {3.0f, 1.0f, 2.5}, {0.5f, 4.5f, -4.0}}) {
        Representation r;
        appendMesh(
            square(left, right), {},
            [](std::uint32_t atom) {
                return SphereLook{0xff808080u, atom + 1};
            },
            r);
        r.radius = 8;
        r.drawnAtoms = 2;
        for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
            const RenderSettings s = settings(r, 100, projection, {0, 0, 0});
            for (const Visibility path : devicePaths()) {
                renderers[path]->setScene(r);
                const LayerPicture layers = renderers[path]->layers(s);
                double sum = 0;
                std::size_t rows = 0;
                for (std::uint32_t y = 30; y < 70; ++y, ++rows)
                    for (std::uint32_t x = 0; x < 100; ++x)
                        if (layers.id[y * 100 + x] == 1 && layers.id[y * 100 + x + 1] == 2)
                            sum += static_cast<int>(x) + 1 - 50;
                EXPECT_NEAR(sum / static_cast<double>(rows) / s.view.pixelsPerAngstrom, border, 0.15)
                    << visibilityName(path);
            }
        }
    }
}

}  // namespace
}  // namespace nacre::test
