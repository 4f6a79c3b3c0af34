// Triangles among round and straight primitives: one picture on every path, that of a ray caster, without gaps.

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "tests/renderer/meshes.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct MeshCase {
    const char* name;
    Projection projection;
    bool clipped = false, contours = false;
    double zoom = 1;
};
void PrintTo(const MeshCase& c, std::ostream* out) { *out << c.name; }

RenderSettings makeSettings(const MeshCase& c, const Representation& r, std::uint32_t size) {
    RenderSettings s = settings(r, size, c.projection, {20, 30, 10}, c.zoom);
    if (c.clipped) s.effects.clip = {-2, 6, Clip::Cap::hatched};
    if (c.contours) s.effects.contours.width = 2;
    return s;
}

class MeshPicture : public SharedRenderers<MeshCase> {};

TEST_P(MeshPicture, IsTheSameOnEveryPath) {
    const MeshCase& c = GetParam();
    const Representation r = meshScene();
    RenderSettings s = makeSettings(c, r, 160);
    FirstPicture picture;
    const LayerPicture& layers = picture.layers;
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(visibility, r);
        for (const bool prepass : {true, false}) {
            s.tuning.plates = prepass ? PlateShape::octagon : PlateShape::none;
            picture.expectSame(renderer, s, visibilityName(visibility) + std::string(prepass ? "" : ", no prepass"));
            if (c.zoom > 1) {  // some are beside the picture
                EXPECT_LT(renderer->stats().triangles, r.triangles.size());
            } else if (c.clipped) {
                EXPECT_GT(renderer->stats().triangles, r.triangles.size());  // caps
            } else {
                EXPECT_EQ(renderer->stats().triangles, r.triangles.size());
            }
        }
    }
    std::size_t ofMesh = 0;
    for (const std::uint32_t id : layers.id) ofMesh += id > 0 && id < 30;
    EXPECT_GT(ofMesh, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Views, MeshPicture,
                         testing::Values(MeshCase{"Parallel", Projection::orthographic},
                                         MeshCase{"Perspective", Projection::perspective},
                                         MeshCase{"Clipped", Projection::perspective, true},
                                         MeshCase{"Contours", Projection::orthographic, false, true},
                                         MeshCase{"Near", Projection::perspective, true, true, 8}),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// What a ray sees of the triangles: in double precision, by solving for the point in each triangle's own plane.
struct Sight {
    double Z = std::numeric_limits<double>::infinity();
    std::uint32_t atom = 0;
    bool sure = true;  ///< no edge, other surface or boundary of looks is near
};
Sight traced(const Representation& r, const std::vector<glm::dvec3>& vertices, const View& view, double x, double y) {
    const glm::dvec2 q((x - view.width / 2.0) / view.pixelsPerAngstrom,
                       (view.height / 2.0 - y) / view.pixelsPerAngstrom);
    const bool perspective = view.projection == Projection::perspective;
    const glm::dvec3 origin = perspective ? glm::dvec3(0, 0, view.eyeDistance) : glm::dvec3(q, view.radius);
    const glm::dvec3 ray = perspective ? glm::dvec3(q, -view.eyeDistance) : glm::dvec3(0, 0, -1);
    const double perUnit = perspective ? view.eyeDistance : 1;
    Sight sight;
    double second = sight.Z;
    for (const Triangle& t : r.triangles) {
        const glm::dvec3 &a = vertices[t.a], ab = vertices[t.b] - a, ac = vertices[t.c] - a, n = glm::cross(ab, ac);
        const double facing = glm::dot(ray, n);
        if (std::abs(facing) < 1e-12) continue;
        const double along = glm::dot(a - origin, n) / facing;
        const glm::dvec3 p = origin + ray * along - a;
        const double beta = glm::dot(glm::cross(p, ac), n) / glm::dot(n, n);
        const double gamma = glm::dot(glm::cross(ab, p), n) / glm::dot(n, n);
        const double alpha = 1 - beta - gamma, least = std::min({alpha, beta, gamma});
        if (least < -1e-3) continue;
        const double Z = along * perUnit;
        const auto look = [&](std::uint32_t i) { return r.meshLooks[r.meshVertices[i].look].atom; };
        double share[3] = {alpha, beta, gamma};
        const std::uint32_t looks[3] = {look(t.a), look(t.b), look(t.c)};
        double best = -1, next = -1;
        std::uint32_t atom = 0;
        for (int i = 0; i < 3; ++i) {
            double sum = 0;
            for (int k = 0; k < 3; ++k) sum += looks[k] == looks[i] ? share[k] : 0;
            if (sum > best && looks[i] != atom)
                next = best, best = sum, atom = looks[i];
            else if (looks[i] != atom)
                next = std::max(next, sum);
        }
        const bool sure = least > 1e-3 && best - next > 1e-3;
        if (Z < sight.Z)
            second = sight.Z, sight = {Z, atom, sure};
        else
            second = std::min(second, Z);
    }
    if (sight.atom != 0) sight.sure = sight.sure && second - sight.Z > 1e-3;
    return sight;
}

TEST(MeshFrame, IsThatOfARayCaster) {
    const Representation r = meshScene(false);
    ValidatedRenderer renderer(Visibility::tiles, r);
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        const RenderSettings s = settings(r, 48, projection, {70, -20, 200});
        const LayerPicture l = renderer->layers(s);
        const std::vector<glm::dvec3> vertices = turnedVertices(r, s.view);
        std::size_t compared = 0, seen = 0, wrong = 0;
        double worst = 0;
        for (std::uint32_t y = 0; y < 48; ++y)
            for (std::uint32_t x = 0; x < 48; ++x) {
                const Sight sight = traced(r, vertices, s.view, x + 0.5, y + 0.5);
                if (!sight.sure) continue;
                const std::size_t i = y * std::size_t{48} + x;
                ++compared;
                wrong += l.id[i] != sight.atom;
                if (sight.atom == 0 || l.id[i] != sight.atom) continue;
                ++seen;
                worst = std::max(worst, std::abs(static_cast<double>(l.z[i]) - sight.Z));
            }
        EXPECT_GT(compared, 2000u);
        EXPECT_GT(seen, 400u);
        EXPECT_EQ(wrong, 0u);
        EXPECT_LT(worst, 1e-4);
    }
}

TEST(MeshFrame, ShowsWhatElseTheSceneHas) {
    PathRenderers renderers;
    std::vector<std::vector<float>> pictures;
    for (const bool balls : {false, true})
        for (const bool sticks : {false, true}) {
            Representation r = meshScene();
            if (!balls) r.spheres.clear(), r.sphereLooks.clear();
            if (!sticks) r.cylinders.clear(), r.cylinderLooks.clear();
            RenderSettings s = settings(r, 64, Projection::orthographic, {70, -20, 200});
            s.occlusion.directions = 0;
            pictures.push_back(sameOnEveryPath(renderers, r, s).rgba);
            for (std::size_t i = 0; i + 1 < pictures.size(); ++i) EXPECT_NE(pictures[i], pictures.back());
        }
}

TEST(MeshFrame, HasNoGaps) {
    Representation r;
    appendMesh(icosphere(glm::vec3(0), 5, 5, 0), glm::dvec3(0), testLook, r);  // 20,480 triangles, some below a pixel
    r.radius = 5;
    r.drawnAtoms = 1;
    for (const Visibility visibility : {Visibility::tiles, Visibility::encoded}) {
        ValidatedRenderer renderer(visibility, r);
        for (int turn = 0; turn < 4; ++turn) {
            // Turns by quarters put vertices and edges onto the middles of pixels.
            const RenderSettings s = settings(r, 200, turn % 2 ? Projection::perspective : Projection::orthographic,
                                              {turn < 2 ? 0.0 : 12.3 * turn, turn < 2 ? 90.0 : 45, 0});
            const LayerPicture l = renderer->layers(s);
            for (std::uint32_t y = 0; y < 200; ++y)
                for (std::uint32_t x = 0; x < 200; ++x)
                    if (std::hypot(x - 99.5, y - 99.5) < 0.98 * 95) {
                        ASSERT_EQ(l.id[y * std::size_t{200} + x], 1u) << x << " " << y << ", turn " << turn;
                    }
        }
    }
}

/// Where the host knows all that pixels show, tiles are drawn that no list names anything for.
TEST(MeshFrame, IsDrawnWhereEveryListIsEmpty) {
    Representation r;
    appendMesh(icosphere(glm::vec3(0), 5, 0, 0), glm::dvec3(0), testLook, r);
    r.radius = 5;
    r.drawnAtoms = 1;
    // The middle of a face, and nothing of its edges.
    const RenderSettings s = settings(r, 40, Projection::orthographic, {20.905, 0, 0}, 12);
    ValidatedRenderer tiles(Visibility::tiles), other(Visibility::encoded);
    tiles->setScene(r);
    other->setScene(r);
    for (int frame = 0; frame < 2; ++frame) {
        EXPECT_EQ(tiles->render(s).rgba, other->render(s).rgba);
        if (isSoftwareDevice()) {
            EXPECT_GT(tiles->stats().lists.tiles, 0u);
        }
        EXPECT_EQ(tiles->stats().lists.entries, 0u);
        EXPECT_EQ(tiles->stats().coveredPixels, 1600u);
    }
}

TEST(MeshFrame, MeetsASphereWhereItDoesInSpace) {
    // A ball of triangles about a sphere that is a little smaller, and one that is a little larger than it.
    for (const float radius : {4.8f, 5.01f}) {
        Representation r;
        appendMesh(icosphere(glm::vec3(0), 5, 4, 0), glm::dvec3(0), testLook, r);
        r.spheres = {{glm::vec3(0), radius}};
        r.sphereLooks = {testLook(1)};
        r.radius = 5.1;
        r.drawnAtoms = 2;
        for (const Visibility visibility : devicePaths()) {
            ValidatedRenderer renderer(visibility, r);
            RenderSettings s = settings(r, 120, Projection::orthographic);
            for (const bool facets : {false, true}) {  // whose apex is farther in front than depth reaches
                if (facets) s.tuning.plates = PlateShape::dome3, s.tuning.impostor = ImpostorShape::pyramid;
                const LayerPicture l = renderer->layers(s);
                std::size_t counts[3] = {};
                for (const std::uint32_t id : l.id) ++counts[id];
                EXPECT_EQ(counts[radius < 5 ? 2 : 1], 0u) << visibilityName(visibility) << ", " << facets;
                EXPECT_GT(counts[radius < 5 ? 1 : 2], 5000u) << visibilityName(visibility) << ", " << facets;
            }
        }
    }
}

TEST(MeshFrame, CapsWhatAPlaneCuts) {
    Representation r;
    appendMesh(icosphere(glm::vec3(0), 5, 4, 0), glm::dvec3(0), testLook, r);
    r.radius = 5;
    r.drawnAtoms = 1;
    ValidatedRenderer renderer(Visibility::tiles, r);
    RenderSettings s = settings(r, 64, Projection::orthographic);
    s.effects.clip.near = 0;
    const LayerPicture l = renderer->layers(s);
    const std::size_t middle = 32 * 64 + 32;
    EXPECT_EQ(l.id[middle], 1u);
    EXPECT_EQ(std::vector(&l.normal[3 * middle], &l.normal[3 * middle] + 3), (std::vector<float>{0, 0, 1}));
    EXPECT_NEAR(l.z[middle], 5, 0.004);  // the plane's
    s.effects.clip = {};
    EXPECT_NEAR(renderer->layers(s).z[middle], 0, 0.05);
}

TEST(MeshFrame, CastsTheShadowOfWhatItStandsFor) {
    // A ball before a larger one, of triangles or round, among sticks: the light's view finds the triangles, too.
    std::vector<std::vector<float>> pictures;
    for (const bool mesh : {true, false}) {
        Representation r;
        r.spheres = {{{0.8f, -1.5f, -2}, 3}};
        r.cylinders = {{{-4, 0, 0}, 0.3f, {-4, 3, 0}, 0}};
        r.cylinderLooks = {{0xff808080, 0xff808080, 1, 1}};
        if (mesh)
            appendMesh(
                icosphere({-0.7f, 1.1f, 2}, 1, 4, 0), glm::dvec3(0), [](std::uint32_t) { return testLook(0); }, r);
        else
            r.spheres.push_back({{-0.7f, 1.1f, 2}, 1});
        r.sphereLooks.assign(r.spheres.size(), testLook(0));
        r.radius = 6;
        r.drawnAtoms = 2;
        ValidatedRenderer renderer(Visibility::fragdepth, r);
        RenderSettings s = settings(r, 120, Projection::orthographic, {0, 0, 0});
        s.effects.shadow.strength = 1;
        pictures.push_back(renderer->render(s).rgba);
        s.effects.shadow.strength = 0;
        pictures.push_back(renderer->render(s).rgba);
    }
    const auto differ = [&](std::size_t a, std::size_t b) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < pictures[a].size(); i += 4)
            count += std::abs(pictures[a][i] - pictures[b][i]) > 0.05f;
        return count;
    };
    EXPECT_GT(differ(0, 1), 100u);  // the shadow
    EXPECT_LT(differ(0, 2), 60u);   // its rim, and that of the ball
}

TEST(MeshFrame, TellsTheAtomUnderThePointer) {
    Representation r;
    appendMesh(icosphere(glm::vec3(0), 5, 3, 16), glm::dvec3(0), testLook, r);
    r.radius = 5;
    r.drawnAtoms = 1;
    for (const Visibility visibility : {Visibility::tiles, Visibility::fragdepth}) {
        ValidatedRenderer renderer(visibility, r);
        EXPECT_EQ(renderer->atomAt(settings(r, 100, Projection::orthographic), 50, 50, 0), 17u);
    }
}

}  // namespace
}  // namespace nacre::test
