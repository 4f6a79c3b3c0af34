// Cartoons drawn coarser where they are small, of copies and of models, in fog and cut: one picture on every path, and
// off from that of all triangles by no more than was asked for.

#include "engine/scene/instances/mesh_levels.h"

#include <cmath>

#include "engine/error.h"
#include "engine/passes/scene_buffers.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct LevelsCase {
    const char* name;
    Projection projection = Projection::orthographic;
    double meshError = 1;
    bool copies = false, models = false, fog = false, clip = false, translucent = false;
};
void PrintTo(const LevelsCase& c, std::ostream* out) { *out << c.name; }

/// The DNA's cartoon: three of it side by side, or two models of which the second is shifted.
Representation levelsScene(const LevelsCase& c) {
    Molecule m = molecule("sample:dna");
    RepresentationOptions options{Style::cartoon, ColorScheme::element};
    if (c.translucent) options.cartoonOpacity = 0.6;
    if (c.copies) {
        addCopies(m, {{0, 0, 0}, {24, 9, 5}, {48, 0, 10}});
        options.assembly = "1";
    }
    if (c.models) {
        // Each strand one by itself.
        for (std::size_t i = 0; i < m.chains.size(); ++i) m.chains[i].model = static_cast<int>(i) + 1;
    }
    return represent(m, drawnAtoms(m), options);
}

RenderSettings levelsSettings(const LevelsCase& c, const Representation& r) {
    RenderSettings s = settings(r, 72, c.projection);
    s.meshError = c.meshError;
    if (c.fog) s.effects.fog.range = Fog::Range::automatic;
    if (c.clip) s.effects.clip = {-2, 12, Clip::Cap::plain};
    return s;
}

std::uint64_t drawnCoarser(const FrameStats& stats) {
    std::uint64_t drawn = 0;
    for (std::size_t i = 1; i < stats.meshLevels.size(); ++i) drawn += stats.meshLevels[i].drawn;
    return drawn;
}

class MeshLevelsPicture : public SharedRenderers<LevelsCase> {};

TEST_P(MeshLevelsPicture, IsTheSameOnEveryPath) {
    const LevelsCase& c = GetParam();
    const Representation r = levelsScene(c);
    const RenderSettings s = levelsSettings(c, r);
    FirstPicture picture;
    const LayerPicture& first = picture.layers;
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(visibility, r);
        picture.expectSame(renderer, s, visibilityName(visibility));
        const FrameStats& stats = renderer->stats();
        ASSERT_GE(stats.meshLevels.size(), 4u);
        std::uint64_t drawn = 0;
        for (const MeshLevelCount& level : stats.meshLevels) drawn += level.drawn;
        EXPECT_EQ(drawn, stats.triangles);
        if (c.clip) {  // caps have no coarser levels
            EXPECT_GT(drawnCoarser(stats), 0u);
            EXPECT_LT(drawnCoarser(stats), stats.triangles);
        } else if (c.meshError > 0) {
            EXPECT_EQ(drawnCoarser(stats), stats.triangles);
        } else {
            EXPECT_EQ(drawnCoarser(stats), 0u);
        }
    }
    std::size_t covered = 0, picked = 0;
    for (std::uint32_t i = 0; i < first.id.size(); ++i) {
        if (first.id[i] == 0) continue;
        if (++covered % 60 == 0)
            picked += sharedRenderer(Visibility::tiles)->atomAt(s, i % 72 + 0.5, i / 72 + 0.5, 0) != first.id[i];
    }
    EXPECT_GT(covered, 200u);
    EXPECT_EQ(picked, 0u);  // a pick draws as the picture did
}

INSTANTIATE_TEST_SUITE_P(Scenes, MeshLevelsPicture,
                         testing::Values(LevelsCase{"Parallel"}, LevelsCase{"Perspective", Projection::perspective, 2},
                                         LevelsCase{"Finest", Projection::orthographic, 0},
                                         LevelsCase{"Copies", Projection::perspective, 1, true},
                                         LevelsCase{"Models", Projection::orthographic, 1, false, true},
                                         LevelsCase{"FogAndClip", Projection::perspective, 1, false, false, true, true},
                                         LevelsCase{"Translucent", Projection::orthographic, 1, false, false, false,
                                                    false, true}),
                         [](const auto& tested) { return std::string(tested.param.name); });

constexpr std::uint32_t kFiner = 3;  // samples across a pixel of the finest's picture

/// Pixels of a picture that are covered, or are not, farther than this from any place of which a finer one says so.
std::size_t outlinesFartherThan(double pixels, const LayerPicture& coarse, const LayerPicture& finest) {
    const int width = static_cast<int>(finest.width), height = static_cast<int>(finest.height);
    const auto covers = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < width && y < height &&
               finest.id[static_cast<std::size_t>(y) * finest.width + static_cast<std::size_t>(x)] != 0;
    };
    const double samples = pixels * kFiner;
    const int reach = static_cast<int>(std::ceil(samples)), middle = kFiner / 2;
    std::size_t far = 0;
    for (std::size_t p = 0; p < coarse.id.size(); ++p) {
        const bool here = coarse.id[p] != 0;
        const int x = static_cast<int>(p % coarse.width * kFiner) + middle,
                  y = static_cast<int>(p / coarse.width * kFiner) + middle;
        bool near = false;
        for (int j = -reach; j <= reach && !near; ++j)
            for (int i = -reach; i <= reach && !near; ++i)
                near = i * i + j * j <= samples * samples && covers(x + i, y + j) == here;
        far += !near;
    }
    return far;
}

TEST(MeshLevels, OutlinesAreOffByNoMoreThanWasAskedFor) {
    const Representation r = levelsScene({"DNA"});
    ValidatedRenderer renderer(Visibility::tiles, r);
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        RenderSettings s = settings(r, 160, projection);
        RenderSettings fine = s;
        fine.view = scaled(s.view, kFiner);
        fine.meshError = 0;
        const LayerPicture finest = renderer->layers(fine);
        const std::uint64_t all = renderer->stats().triangles;
        for (const double error : {0.5, 1.0, 3.0}) {
            s.meshError = error;
            const LayerPicture coarse = renderer->layers(s);
            EXPECT_LT(renderer->stats().triangles, all) << error;
            // As far as from one sample of the finest to the next it may be off beside that. Each piece keeps within
            // it: where the outlines of two cross, both may leave the corner out.
            EXPECT_LE(outlinesFartherThan(error + 1.0 / kFiner, coarse, finest), coarse.id.size() / 20'000) << error;
        }
        // The measure tells: within a third of a pixel the coarsest is not.
        EXPECT_GT(outlinesFartherThan(1.0 / kFiner, renderer->layers(s), finest), 0u);
    }
}

TEST(MeshLevels, AreTheCoarsestWithinTheError) {
    const Representation r = levelsScene({"DNA"});
    ASSERT_EQ(r.meshes.size(), 1u);
    const MeshRun& mesh = r.meshes[0];
    const auto triangles = static_cast<std::uint32_t>(r.triangles.size());
    ASSERT_GE(mesh.levels.size(), 3u);
    for (const MeshRun::Level& level : mesh.levels) {
        const auto error = static_cast<double>(level.error);
        const std::vector<PrimitiveRun> runs = drawnRuns(r, error * 1.001);
        ASSERT_EQ(runs.size(), 1u);
        EXPECT_EQ(runs[0].first, triangles + level.first);
        EXPECT_EQ(runs[0].count, level.count);
        EXPECT_NE(drawnRuns(r, error * 0.999)[0].first, runs[0].first);
    }
    EXPECT_EQ(drawnRuns(r, 0)[0].count, triangles);
    // A pixel at the front of the view's ball is less than one in its middle.
    const View flat = settings(r, 100, Projection::orthographic).view;
    EXPECT_DOUBLE_EQ(errorInSpace(flat, 0.5) * flat.pixelsPerAngstrom, 0.5);
    const View deep = settings(r, 100, Projection::perspective).view;
    EXPECT_DOUBLE_EQ(errorInSpace(deep, 0.5) * deep.pixelsPerAngstrom * deep.eyeDistance,
                     0.5 * (deep.eyeDistance - deep.radius));
}

TEST(MeshLevels, AreLeftOutWhereABufferIsTooSmall) {
    Representation r = levelsScene({"DNA"});
    const std::uint64_t all = shapeBytes(r), levels = r.coarseTriangles.size() * sizeof(Triangle);
    fitBuffer(r, all);
    EXPECT_FALSE(r.meshes[0].levels.empty());
    // The finest goes first; the others are what they were.
    const Representation before = r;
    fitBuffer(r, all - 1);
    ASSERT_EQ(r.meshes[0].levels.size(), before.meshes[0].levels.size() - 1);
    for (std::size_t i = 0; i < r.meshes[0].levels.size(); ++i) {
        const MeshRun::Level &kept = r.meshes[0].levels[i], &was = before.meshes[0].levels[i + 1];
        EXPECT_EQ(kept.error, was.error);
        ASSERT_EQ(kept.count, was.count);
        EXPECT_EQ(r.coarseTriangles[kept.first].a, before.coarseTriangles[was.first].a);
        EXPECT_EQ(r.coarseTriangles[kept.first + kept.count - 1].c,
                  before.coarseTriangles[was.first + was.count - 1].c);
    }
    fitBuffer(r, all - levels);
    EXPECT_TRUE(r.meshes[0].levels.empty());
    EXPECT_EQ(shapeBytes(r), all - levels);
    EXPECT_EQ(drawnRuns(r, 10)[0].count, r.triangles.size());
    fitBuffer(r, 0);  // what there is without levels stays
    EXPECT_EQ(shapeBytes(r), all - levels);
}

/// What is drawn at an error: the corners of its triangles.
std::vector<glm::vec3> drawnPlaces(const Representation& r, double error) {
    std::vector<glm::vec3> places;
    for (const PrimitiveRun& run : drawnRuns(r, error))
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
            const Triangle& t = drawnTriangle(r, i);
            for (const std::uint32_t v : {t.a, t.b, t.c}) places.push_back(decodePosition(r.meshVertices[v], t.step()));
        }
    return places;
}

TEST(MeshLevels, AreDrawnForMeshesThatABufferHasNoRoomFor) {
    for (const auto& [copies, models] : {std::pair{false, false}, {true, false}, {false, true}}) {
        const Representation whole = levelsScene({"DNA", Projection::orthographic, 1, copies, models});
        const std::size_t levels = whole.meshes[0].levels.size();
        Representation r = whole;
        fitBuffer(r, shapeBytes(whole) - whole.coarseTriangles.size() * sizeof(Triangle) - 1);
        ASSERT_EQ(r.meshes.size(), whole.meshes.size());
        EXPECT_LT(shapeBytes(r), shapeBytes(whole) - whole.coarseTriangles.size() * sizeof(Triangle));
        ASSERT_EQ(r.meshes[0].levels.size(), levels - 1);
        EXPECT_EQ(r.meshes[0].error, whole.meshes[0].levels[0].error);
        // What its levels show is what they showed.
        for (std::size_t i = 0; i < levels; ++i) {
            const double error = 1.001 * static_cast<double>(whole.meshes[0].levels[i].error);
            EXPECT_TRUE(drawnPlaces(r, error) == drawnPlaces(whole, error)) << error;
        }
        fitBuffer(r, 0);
        EXPECT_EQ(r.meshes[0].error, whole.meshes[0].levels.back().error);
        EXPECT_TRUE(r.coarseTriangles.empty());
        std::size_t placed = 0, ofModels = 0;
        for (const PrimitiveRun& run : r.copies.triangles) placed += run.count;
        for (const ModelRun& run : r.triangleModels) ofModels += run.count;
        EXPECT_EQ(placed, copies ? r.triangles.size() : 0);
        EXPECT_EQ(ofModels, models ? r.triangles.size() : 0);
        ValidatedRenderer renderer(Visibility::tiles);
        RenderSettings s = settings(whole, 72, Projection::orthographic);
        renderer->setScene(r);
        const LayerPicture few = renderer->layers(s);
        EXPECT_EQ(renderer->stats().meshLevels[0].error, static_cast<double>(r.meshes[0].error));
        s.meshError = 1.001 * static_cast<double>(r.meshes[0].error) * s.view.pixelsPerAngstrom;
        renderer->setScene(whole);
        const LayerPicture coarsest = renderer->layers(s);
        EXPECT_TRUE(few.id == coarsest.id);
        EXPECT_TRUE(few.z == coarsest.z);
    }
}

TEST(MeshLevels, HaveTheRoomThatShadersRead) {
    gpu::Caps caps;
    caps.maxStorageBufferBytes = 1000;
    caps.tiles.texels = false;
    EXPECT_EQ(passes::mostShapeBytes(caps), 1000u);
    caps.tiles.texels = true;  // as many vectors as there are words in the other
    EXPECT_EQ(passes::mostShapeBytes(caps), 4000u);
    caps.maxBufferBytes = 3000;
    EXPECT_EQ(passes::mostShapeBytes(caps), 3000u);
    EXPECT_NO_THROW(gpu::checkBuffer(caps, 3000, "pixels"));
    EXPECT_THROW(gpu::checkBuffer(caps, 3001, "pixels"), Error);
}

TEST(MeshLevels, OfWhatMovesAreThoseOfWhereItIs) {
    Molecule m = molecule("sample:dna");
    MovingScene moving(m, drawnAtoms(m), {Style::cartoon, ColorScheme::element});
    RenderSettings s = settings(moving.scene(), 64, Projection::orthographic);
    s.meshError = 1;
    ValidatedRenderer moved(Visibility::tiles), made(Visibility::tiles);
    moved->setScene(moving.scene());
    moved->render(s);
    for (const float bend : {0.02f, 0.08f}) {
        for (Atom& atom : m.atoms) atom.position.x += bend * atom.position.y;
        moving.move(m);
        moved->moveScene(moving.scene());
        made->setScene(moving.scene());
        const LayerPicture a = moved->layers(s), b = made->layers(s);
        EXPECT_TRUE(a.id == b.id);
        EXPECT_TRUE(a.z == b.z);
        EXPECT_EQ(drawnCoarser(moved->stats()), moved->stats().triangles);
    }
}

}  // namespace
}  // namespace nacre::test
