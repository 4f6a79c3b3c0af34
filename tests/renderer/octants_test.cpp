// Ellipsoids with an octant cut out: one picture on every path, in which the ball at the corner does not show.

#include "engine/frame/scene.h"
#include "engine/molecule/element.h"
#include "engine/occlusion/depth_maps.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

Representation octantScene(EllipsoidForm form, int ellipsoids = 100) {
    Molecule m = molecule("sample:glucose");
    m.displacements.resize(m.atoms.size());
    for (std::uint32_t i = 0; i < m.atoms.size(); ++i)
        if (!isHydrogen(m.atoms[i].element) && ellipsoids-- > 0)
            m.displacements[i] = {0.14f, 0.1f, 0.06f, 0.02f, -0.03f, 0.01f};
    return represent(m, drawnAtoms(m),
                     {.style = Style::ellipsoids, .ellipsoids = form, .viewer = glm::dvec4(0, 0, 1, 0)});
}

TEST(OctantPictures, AreTheSameOnEveryPath) {
    PathRenderers renderers;
    const Representation r = octantScene(EllipsoidForm::octants, 4);
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        RenderSettings s = settings(r, 140, projection, {10, 0, 5});
        s.occlusion.directions = 8;
        s.effects.contours.width = 1;
        if (projection == Projection::perspective) s.effects.clip.near = -0.2;  // through atoms: caps
        sameOnEveryPath(renderers, r, s);
    }
}

TEST(OctantPictures, DifferFromBandsWhereTheViewerLooksIn) {
    ValidatedRenderer renderer(Visibility::automatic);
    std::vector<LayerPicture> pictures;
    for (const EllipsoidForm form : {EllipsoidForm::bands, EllipsoidForm::octants}) {
        const Representation r = octantScene(form);
        renderer->setScene(r);
        pictures.push_back(renderer->layers(settings(r, 300, Projection::orthographic, {0, 0, 0})));
    }
    // The outlines are the same; the octants lie deeper.
    std::size_t deeper = 0, nearer = 0, seen = 0;
    for (std::size_t i = 0; i < pictures[0].id.size(); ++i) {
        seen += pictures[0].id[i] > 0;
        deeper += pictures[1].z[i] > pictures[0].z[i] + 0.01f;
        nearer += pictures[1].z[i] < pictures[0].z[i] - 0.01f;
    }
    EXPECT_GT(deeper, seen / 10);
    EXPECT_EQ(nearer, 0u);
}

/// The balls at the corners would ask for the largest depth maps, and for samples everywhere as thin shapes do.
TEST(OctantPictures, TakeNoMoreThanBands) {
    const Representation bands = octantScene(EllipsoidForm::bands), octants = octantScene(EllipsoidForm::octants);
    EXPECT_EQ(measureSizes(octants).smallestRadius, measureSizes(bands).smallestRadius);
    EXPECT_EQ(occlusion::DepthMapSizes::pixelsFor(octants, 64u << 20, 32),
              occlusion::DepthMapSizes::pixelsFor(bands, 64u << 20, 32));
}

TEST(OctantPictures, ShowNoBall) {
    ValidatedRenderer renderer(Visibility::automatic);
    Representation r = octantScene(EllipsoidForm::octants);
    RenderSettings s = settings(r, 600, Projection::orthographic, {0, 0, 0});
    renderer->setScene(r);
    const Picture with = renderer->render(s);
    for (Sphere& sphere : r.spheres)
        if (sphere.radius <= 1e-3f) sphere.center.z -= 0.02f;  // into the ellipsoid
    renderer->setScene(r);
    EXPECT_EQ(renderer->render(s).rgba, with.rgba);
}

}  // namespace
}  // namespace nacre::test
