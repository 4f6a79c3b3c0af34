// Occlusion of meshes, and of what stands among them, against rays.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "engine/error.h"
#include "engine/mesh/cartoon.h"
#include "engine/mesh/surface.h"
#include "engine/molecule/kabsch_sander.h"
#include "engine/scene/build/chunks.h"
#include "tests/occlusion/traced_points.h"
#include "tests/renderer/meshes.h"
#include "tests/renderer/scenes.h"
#include "tests/support/error_text.h"
#include "tests/support/temporary_folder.h"

namespace nacre::test {
namespace {

enum class Made { tubes, cartoon, surface, cartoonWithSpheres };
struct MeshOcclusionCase {
    const char* name;
    const char* file;
    Made made;
};
void PrintTo(const MeshOcclusionCase& c, std::ostream* out) { *out << c.name; }

Representation makeMeshScene(const std::string& file, Made made) {
    const Molecule m = molecule(file);
    const std::vector<std::uint32_t> drawn = drawnAtoms(m);
    Representation r;
    const Representation spheres = represent(m, drawn, {Style::spacefill, ColorScheme::chain});
    r.center = spheres.center;
    r.radius = spheres.radius;
    r.drawnAtoms = drawn.size();
    const Mesh mesh = made == Made::surface ? surface(m, drawn, {}, r.center)
                                            : cartoon(m, drawn, secondaryStructure(m), {}, r.center);
    appendMesh(
        mesh, glm::dvec3(0),
        [](std::uint32_t atom) {
            return SphereLook{0xffffffff, atom + 1};
        },
        r);
    if (made != Made::cartoonWithSpheres) return r;
    const std::vector<std::uint32_t> inside = atomsOfCartoon(m, drawn).drawn;
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (!std::binary_search(inside.begin(), inside.end(), drawn[i])) {
            r.spheres.push_back(spheres.spheres[i]);
            r.sphereLooks.push_back(spheres.sphereLooks[i]);
        }
    return r;
}

class MeshOcclusion : public testing::TestWithParam<MeshOcclusionCase> {};

TEST_P(MeshOcclusion, IsNearTheRayTraced) {
    const MeshOcclusionCase& c = GetParam();
    NACRE_NEEDS_DATA(c.file);
    const Representation r = c.made == Made::tubes ? meshScene() : makeMeshScene(c.file, c.made);
    ASSERT_FALSE(r.triangles.empty());
    expectNearRays(r, 0.042);
}

std::string caseName(const testing::TestParamInfo<MeshOcclusionCase>& test) { return test.param.name; }
INSTANTIATE_TEST_SUITE_P(Scenes, MeshOcclusion,
                         testing::Values(MeshOcclusionCase{"Tubes", "sample:", Made::tubes},
                                         MeshOcclusionCase{"DnaCartoon", "sample:dna", Made::cartoon},
                                         MeshOcclusionCase{"GlucoseSurface", "sample:glucose", Made::surface},
                                         MeshOcclusionCase{"CrambinCartoon", "1crn.pdb", Made::cartoon},
                                         MeshOcclusionCase{"CrambinSurface", "1crn.pdb", Made::surface}),
                         caseName);
// On one driver.
INSTANTIATE_TEST_SUITE_P(Large, MeshOcclusion,
                         testing::Values(MeshOcclusionCase{"HaemoglobinCartoon", "4hhb.pdb", Made::cartoon},
                                         MeshOcclusionCase{"HaemoglobinMixed", "4hhb.pdb", Made::cartoonWithSpheres},
                                         MeshOcclusionCase{"HaemoglobinSurface", "4hhb.pdb", Made::surface}),
                         caseName);

TEST(OcclusionOfMeshes, WithLigandsIsNearTheRayTraced) {
    NACRE_NEEDS_DATA("4hhb.pdb");
    expectNearRays(scene("4hhb.pdb", Style::cartoon), 0.045);
}

TEST(OcclusionOfMeshes, HasFewTexelsForThinSticks) {
    ValidatedRenderer renderer(Visibility::automatic);
    Representation r = meshScene();
    RenderSettings s = settings(r, 40, Projection::orthographic);
    s.occlusion.directions = 1;
    renderer->setScene(r);
    renderer->render(s);
    EXPECT_EQ(renderer->stats().occlusion.patchTexels, 32u);
    // Maps show a mesh by 2.5 pixels per Å: of these less than one.
    for (Sphere& sphere : r.spheres) sphere.radius = 0.25f;
    renderer->setScene(r);
    renderer->render(s);
    EXPECT_EQ(renderer->stats().occlusion.patchTexels, 12u);
}

TEST(OcclusionOfMeshes, IsTheSameOnEveryPath) {
    const Representation r = meshScene();
    RenderSettings s = settings(r, 160, Projection::orthographic);
    s.occlusion.directions = 16;
    std::vector<float> first;
    PathRenderers renderers;
    for (const OcclusionMaps maps : {OcclusionMaps::fragdepth, OcclusionMaps::encoded, OcclusionMaps::tiles}) {
        s.occlusion.maps = maps;
        const std::vector<float> occlusion = sameOnEveryPath(renderers, r, s).occlusion;
        EXPECT_LT(*std::min_element(occlusion.begin(), occlusion.end()), 0.5f);
        if (first.empty()) first = occlusion;
        double difference = 0;
        for (std::size_t i = 0; i < occlusion.size(); ++i) {
            difference += std::abs(occlusion[i] - first[i]);
            // A pixel whose centre lies on a triangle's edge is another's by rounding: the depths are the same.
            const double most = maps == OcclusionMaps::tiles ? 1.01 / 255 : 1.0;
            ASSERT_NEAR(occlusion[i], first[i], most) << i;
        }
        EXPECT_LT(difference / static_cast<double>(occlusion.size()), 0.002);
    }
}

TEST(OcclusionOfMeshes, IsHandedOutAsPicturesShowIt) {
    Representation r = meshScene();
    orderInSpace(r);
    RenderSettings s = settings(r, 120, Projection::orthographic);
    s.occlusion.directions = 32;
    ValidatedRenderer renderer(Visibility::automatic, r);
    const BakedOcclusion baked = renderer->bakedOcclusion(s.occlusion);
    const LayerPicture l = renderer->layers(s);
    const glm::mat3 toObject(glm::transpose(s.view.rotation));
    const glm::vec3 axis = glm::normalize(r.cylinders[0].b - r.cylinders[0].a);
    std::size_t ofSpheres = 0, ofCylinder = 0;
    for (std::size_t i = 0; i < l.id.size(); ++i) {
        const glm::vec3 normal = toObject * glm::vec3(l.normal[3 * i], l.normal[3 * i + 1], l.normal[3 * i + 2]);
        for (std::uint32_t sphere = 0; sphere < r.spheres.size(); ++sphere)
            if (r.sphereLooks[sphere].atom == l.id[i]) {
                ASSERT_NEAR(baked.ofSphere(sphere, normal), l.occlusion[i], 2.0 / 255);
                ++ofSpheres;
            }
        if (l.id[i] != r.cylinderLooks[0].atomA && l.id[i] != r.cylinderLooks[0].atomB) continue;
        const double x = static_cast<double>(i % 120) + 0.5 - 60, y = 60 - static_cast<double>(i / 120) - 0.5;
        const glm::vec3 at = toObject * glm::vec3(x / s.view.pixelsPerAngstrom, y / s.view.pixelsPerAngstrom,
                                                  s.view.radius - static_cast<double>(l.z[i]));
        if (std::abs(glm::dot(normal, axis)) > 0.5f) continue;
        const float share = glm::dot(at - r.cylinders[0].a, axis) / glm::length(r.cylinders[0].b - r.cylinders[0].a);
        ASSERT_NEAR(baked.ofCylinder(0, axis, normal, share), l.occlusion[i], 3.0 / 255);
        ++ofCylinder;
    }
    EXPECT_GT(ofSpheres, 500u);
    EXPECT_GT(ofCylinder, 100u);
    float least = 1;
    for (std::uint32_t v = 0; v < r.meshVertices.size(); ++v) least = std::min(least, baked.ofVertex(v));
    EXPECT_LT(least, 0.4f);
    renderer->setScene(r);
    EXPECT_EQ(renderer->bakedOcclusion(s.occlusion).texels, baked.texels);
}

TEST(OcclusionOfMeshes, IsTheSameInTheSmallestParts) {
    const Representation r = meshScene();
    RenderSettings s = settings(r, 100, Projection::orthographic);
    s.occlusion.directions = 3;
    for (const OcclusionMaps maps : {OcclusionMaps::tiles, OcclusionMaps::fragdepth}) {
        s.occlusion.maps = maps;
        ValidatedRenderer atOnce(Visibility::automatic), inParts(Visibility::automatic);
        atOnce->setScene(r);
        inParts->setScene(r);
        int calls = 0;
        while (inParts->advanceOcclusion(s, OcclusionPace{0, 1, false}) < 1) {
            ASSERT_LT(++calls, 100'000);
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
        EXPECT_GT(calls, 10);
        EXPECT_EQ(inParts->layers(s).occlusion, atOnce->layers(s).occlusion);
    }
}

/// A flat sheet, one layer of triangles: with two sides.
Representation sheet() {
    Mesh mesh;
    for (std::uint32_t i = 0; i < 36; ++i) {
        mesh.positions.emplace_back(static_cast<float>(i % 6) - 2.5f, static_cast<float>(i / 6) - 2.5f, 0.0f);
        mesh.normals.emplace_back(0, 0, 1);
        mesh.atoms.push_back(0);
        if (i % 6 == 5 || i / 6 == 5) continue;
        mesh.triangles.emplace_back(i, i + 1, i + 7);
        mesh.triangles.emplace_back(i, i + 7, i + 6);
    }
    Representation r;
    appendMesh(mesh, glm::dvec3(0), testLook, r);
    r.radius = 4;
    r.drawnAtoms = 1;
    return r;
}

TEST(OcclusionOfMeshes, IsThatOfTheSideThatIsSeen) {
    Representation r = sheet();
    // A ball close over one side darkens it, and not the other one.
    r.spheres = {{{0, 0, 1.6f}, 1.5f}};
    r.sphereLooks = {testLook(1)};
    ValidatedRenderer renderer(Visibility::automatic, r);
    for (const bool behind : {false, true}) {
        RenderSettings s = settings(r, 100, Projection::orthographic, {0, behind ? 180.0 : 0, 0});
        s.occlusion.directions = 128;
        const LayerPicture l = renderer->layers(s);
        const std::size_t corner = 30 * 100 + 30, middle = 50 * 100 + 50;  // the corner is 2.2 Å from the middle
        EXPECT_EQ(l.id[corner], 1u);
        EXPECT_FLOAT_EQ(l.normal[3 * corner + 2], 1);
        if (behind) {
            EXPECT_GT(l.occlusion[corner], 0.98f);
            EXPECT_GT(l.occlusion[middle], 0.98f);
        } else {
            EXPECT_LT(l.occlusion[corner], 0.93f);
            EXPECT_EQ(l.id[middle], 2u);
        }
    }
}

TEST(OcclusionOfMeshes, CountsVerticesWhereItDoesNotFit) {
    const Representation r = meshScene(false);
    ValidatedRenderer renderer(Visibility::automatic, r);
    RenderSettings s = settings(r, 40, Projection::orthographic);
    s.occlusion.directions = 1;
    s.occlusion.bytes = 1000;
    expectThrows([&] { renderer->render(s); }, std::to_string(r.meshVertices.size()) + " primitives and vertices");
}

TEST(OcclusionOfMeshes, OfManyVerticesTakesMoreMemory) {
    Representation r = meshScene(false);
    ValidatedRenderer renderer(Visibility::automatic);
    RenderSettings s = settings(r, 40, Projection::orthographic);
    s.occlusion.directions = 1;
    // Those of the mesh need more than a half: depth maps make do with the rest.
    s.occlusion.bytes = 60 * r.meshVertices.size();
    renderer->setScene(r);
    renderer->render(s);
    EXPECT_EQ(renderer->stats().occlusion.budget, s.occlusion.bytes);
    EXPECT_LE(renderer->stats().occlusion.bytes, s.occlusion.bytes);
    EXPECT_GT(renderer->stats().occlusion.bytes, s.occlusion.bytes / 2);
    // So many that they do not fit what is usual; no triangle has them.
    s.occlusion.bytes = OcclusionSettings::kUsualBytes;
    renderer->render(s);
    EXPECT_EQ(renderer->stats().occlusion.budget, OcclusionSettings::kUsualBytes);
    r.meshVertices.resize(2'000'000, r.meshVertices.back());
    renderer->setScene(r);
    renderer->render(s);
    EXPECT_GT(renderer->stats().occlusion.budget, OcclusionSettings::kUsualBytes);
    EXPECT_LE(renderer->stats().occlusion.bytes, renderer->stats().occlusion.budget);
}

TEST(OcclusionOfMeshes, IsKeptOnDisk) {
    const TemporaryFolder folder;
    const Representation r = meshScene();
    RenderSettings s = settings(r, 100, Projection::orthographic);
    s.occlusion.directions = 16;
    s.occlusion.cache = folder.path();
    s.occlusion.worthKeeping = 0;
    std::vector<float> first;
    for (const bool cached : {false, true}) {
        ValidatedRenderer renderer(Visibility::automatic, r);
        const LayerPicture l = renderer->layers(s);
        EXPECT_EQ(renderer->stats().occlusion.cached, cached);
        if (first.empty()) first = l.occlusion;
        EXPECT_TRUE(l.occlusion == first);
    }
    // Another normal is another bake.
    Representation other = r;
    other.meshVertices[5].normal ^= 0x100;
    ValidatedRenderer renderer(Visibility::automatic, other);
    renderer->layers(s);
    EXPECT_FALSE(renderer->stats().occlusion.cached);
}

}  // namespace
}  // namespace nacre::test
