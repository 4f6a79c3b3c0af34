// What is counted of geometry, held against the shaders' own interfaces and against numbers by hand.

#include "engine/frame/geometry.h"

#include <gtest/gtest.h>

#include "engine/gpu/fold_constants.h"
#include "engine/graph/capability_sets.h"
#include "shaders.h"
#include "tests/frame/shapes.h"
#include "tests/renderer/scenes.h"
#include "tests/support/vertex_outputs.h"

namespace nacre::test {
namespace {

/// Bytes that a vertex stage hands on in a scene without ellipsoids.
std::uint32_t handedOn(std::span<const std::uint32_t> stage) { return outputBytes(gpu::foldConstants(stage, {})); }

Frame frameBy(Visibility path) { return makeFrame(makeShape(path, {1170, 2532})); }

/// Varyings of a corner in a pass of a path.
enum Kind { sphere, cylinder, triangle };
std::uint64_t bytesOfCorner(Visibility path, std::size_t pass, Kind kind) {
    const SceneCounts one{kind == sphere, kind == cylinder, kind == triangle, 1, false};
    const auto geometry = describeGeometry(frameBy(path).graph, one, {}, PlateShape::square, ImpostorShape::square);
    return geometry[pass].varyingBytes / geometry[pass].vertices;
}

TEST(Geometry, CountsWhatTheShadersHandOn) {
    constexpr std::uint32_t kPosition = 16;
    const auto expect = [](Visibility path, std::size_t pass, Kind kind, std::span<const std::uint32_t> shader) {
        EXPECT_EQ(bytesOfCorner(path, pass, kind), kPosition + handedOn(shader)) << pass << ", " << kind;
    };
    expect(Visibility::encoded, 0, sphere, shaders::plateVertex);
    expect(Visibility::encoded, 0, triangle, shaders::plateTriangleVertex);
    expect(Visibility::encoded, 1, sphere, shaders::geometrySphereVertex);
    expect(Visibility::encoded, 1, cylinder, shaders::geometryCylinderVertex);
    expect(Visibility::encoded, 1, triangle, shaders::geometryTriangleVertex);
    expect(Visibility::encoded, 2, sphere, shaders::lookSphereVertex);
    expect(Visibility::encoded, 2, cylinder, shaders::lookCylinderVertex);
    expect(Visibility::encoded, 2, triangle, shaders::lookTriangleVertex);
    expect(Visibility::deferred, 1, sphere, shaders::numberSphereVertex);
    expect(Visibility::deferred, 1, cylinder, shaders::numberCylinderVertex);
    expect(Visibility::deferred, 1, triangle, shaders::numberTriangleVertex);
}

TEST(Geometry, CountsTheRowsOfEllipsoids) {
    gpu::Specialization some;
    some.set(layout::kEllipsoidsId, 1);
    const std::uint32_t handed = outputBytes(gpu::foldConstants(shaders::geometrySphereVertex, some));
    const auto bytes = [&](bool ellipsoids) {
        const SceneCounts one{{.spheres = 1, .radiusPixels = 1, .hasEllipsoids = ellipsoids}};
        const auto geometry =
            describeGeometry(frameBy(Visibility::encoded).graph, one, {}, PlateShape::square, ImpostorShape::square);
        return std::pair(geometry[0].vertices, geometry[1].varyingBytes / geometry[1].vertices);
    };
    EXPECT_EQ(bytes(true).second, 16 + handed);
    EXPECT_EQ(bytes(true).second, bytes(false).second + 32);
    EXPECT_EQ(bytes(true).first, 0u);  // no plates
    EXPECT_EQ(bytes(false).first, 4u);
}

// On GPUs that store vertex outputs triangles and spheres pass at most half: the fragment stage fetches the rest.
TEST(Geometry, PassesNumbersWhereVertexOutputsGoThroughMemory) {
    const graph::GeometryCaps& mali = graph::capabilitySet("mali").plan.geometry;
    constexpr std::uint32_t kPosition = 16;
    const auto corner = [&](std::size_t pass, const SceneCounts& one) {
        const auto geometry =
            describeGeometry(frameBy(Visibility::encoded).graph, one, mali, PlateShape::square, ImpostorShape::square);
        return geometry[pass].varyingBytes / geometry[pass].vertices;
    };
    const std::uint32_t fetched = handedOn(shaders::lookSphereFetchedVertex);
    EXPECT_LE(2 * fetched, handedOn(shaders::lookSphereVertex));
    for (const double radius : {1.0, 9.4, 40.0}) EXPECT_EQ(corner(2, {1, 0, 0, radius, false}), kPosition + fetched);
    for (const std::size_t pass : {1u, 2u})
        EXPECT_EQ(corner(pass, {0, 0, 1, 1, false}), kPosition + handedOn(shaders::geometryTriangleFetchedVertex));
}

TEST(Geometry, OfALargeProteinIsAQuarterOfWhatPyramidsWithoutIndicesTook) {
    // 1AON at 1170x2532: 58,870 atoms of 9.4 pixels. Three plates and two pyramids of 24 corners each were 2,208 bytes
    // a sphere, 130 MB.
    const SceneCounts counts{58'870, 0, 0, 9.4, false};
    const graph::GeometryCaps& mali = graph::capabilitySet("mali").plan.geometry;
    ASSERT_TRUE(mali.storesVaryings);
    const PassGeometry sum = sumGeometry(describeGeometry(frameBy(Visibility::encoded).graph, counts, mali,
                                                          PlateShape::automatic, ImpostorShape::automatic));
    EXPECT_EQ(sum.varyingBytes, 58'870u * (8 * 16 + 4 * 32 + 4 * 32));
    EXPECT_LE(4 * sum.varyingBytes, 58'870u * 2'208u);
}

TEST(Geometry, OfAPictureIsToldByItsFrame) {
    ValidatedRenderer renderer(isDevicePath(Visibility::rasterOrder) ? Visibility::rasterOrder : Visibility::fragdepth);
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    renderer->setScene(r);
    RenderSettings s = settings(r, 32, Projection::orthographic);
    s.occlusion.directions = 0;
    s.tuning.plates = PlateShape::square;
    s.tuning.impostor = ImpostorShape::square;
    renderer->render(s);
    const auto& geometry = renderer->stats().geometry;
    ASSERT_EQ(geometry.size(), 2u);
    EXPECT_EQ(geometry[0].name, "opaque prepass");
    EXPECT_EQ(geometry[0].vertices, 4 * r.spheres.size());
    EXPECT_EQ(geometry[0].triangles, 2 * r.spheres.size());
    EXPECT_EQ(geometry[1].vertices, 4 * (r.spheres.size() + r.cylinders.size()));
    EXPECT_EQ(geometry[1].varyingBytes, 4 * (52 * r.spheres.size() + 92 * r.cylinders.size()));
    EXPECT_FALSE(renderer->stats().storesVaryings);
}

}  // namespace
}  // namespace nacre::test
