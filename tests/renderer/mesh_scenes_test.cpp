// Cartoons in copies, of models, in fog, cut, and moved: one picture on every path, and counted.

#include <utility>

#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct MeshSceneCase {
    const char* name;
    Projection projection = Projection::orthographic;
    bool copies = false, models = false, fog = false, clip = false, contours = false, inverted = false;
};
void PrintTo(const MeshSceneCase& c, std::ostream* out) { *out << c.name; }

/// The DNA's cartoon: three of it side by side, or each strand a model.
Representation makeMeshScene(const MeshSceneCase& c) {
    Molecule m = molecule("sample:dna");
    RepresentationOptions options{Style::cartoon, ColorScheme::element};
    if (c.copies) {
        addCopies(m, {{0, 0, 0}, {24, 9, 5}, {48, 0, 10}});
        options.assembly = "1";
    }
    if (c.models)
        for (std::size_t i = 0; i < m.chains.size(); ++i) m.chains[i].model = static_cast<int>(i) + 1;
    Representation r = represent(m, drawnAtoms(m), options);
    if (c.inverted)
        for (auto* stream : {&r.triangles, &r.coarseTriangles})
            for (Triangle& t : *stream) std::swap(t.b, t.c);
    return r;
}

class MeshScenes : public SharedRenderers<MeshSceneCase> {};

TEST_P(MeshScenes, AreTheSameOnEveryPath) {
    const MeshSceneCase& c = GetParam();
    const Representation r = makeMeshScene(c);
    ASSERT_GT(r.triangles.size(), 1000u);
    RenderSettings s = settings(r, 72, c.projection);
    s.meshError = 0;  // every triangle is counted
    if (c.fog) s.effects.fog.range = Fog::Range::automatic;
    if (c.clip) s.effects.clip = {-2, 12, Clip::Cap::plain};
    if (c.contours) s.effects.contours.width = 2;
    if (c.contours) {
        ASSERT_TRUE(r.spheres.empty() && r.cylinders.empty());  // triangles are not taken for others
    }
    RenderSettings plain = s;
    plain.effects = {};
    FirstPicture picture;
    const LayerPicture& first = picture.layers;
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(visibility, r);
        picture.expectSame(renderer, s, visibilityName(visibility));
        const std::size_t triangles = r.triangles.size() * (c.copies ? 3 : 1);
        if (c.clip) {
            EXPECT_GT(renderer->stats().triangles, triangles);  // caps
        } else {
            EXPECT_EQ(renderer->stats().triangles, triangles);
        }
        EXPECT_EQ(renderer->stats().spheres, r.spheres.size());
    }
    std::size_t covered = 0, picked = 0, missed = 0;
    for (std::uint32_t i = 0; i < first.id.size(); ++i) {
        if (first.id[i] == 0 || ++covered % 60 != 0) continue;
        ++picked;
        missed += sharedRenderer(Visibility::tiles)->atomAt(s, i % 72 + 0.5, i / 72 + 0.5, 0) != first.id[i];
    }
    EXPECT_GT(picked, 2u);
    EXPECT_EQ(missed, 0u);
    if (c.inverted) {  // the fronts of what counts as closed are seen alone: here its inner sides
        Representation open = r;
        for (MeshRun& mesh : open.meshes) EXPECT_TRUE(std::exchange(mesh.closed, false));
        ValidatedRenderer renderer(Visibility::tiles, open);
        EXPECT_FALSE(renderer->layers(s).z == first.z);
    }
    if (c.fog || c.clip || c.contours) {
        EXPECT_FALSE(sharedRenderer(Visibility::tiles)->render(plain).rgba == picture.picture.rgba);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Cartoons, MeshScenes,
    testing::Values(MeshSceneCase{"Copies", Projection::perspective, true},
                    MeshSceneCase{"Models", Projection::orthographic, false, true},
                    MeshSceneCase{"Fog", Projection::perspective, false, false, true},
                    MeshSceneCase{"Cut", Projection::orthographic, false, false, false, true},
                    MeshSceneCase{"Lined", Projection::orthographic, false, false, false, false, true},
                    MeshSceneCase{"Inverted", Projection::orthographic, false, false, false, false, false, true},
                    MeshSceneCase{"InvertedCopies", Projection::perspective, true, false, false, false, false, true},
                    MeshSceneCase{"CutCopiesInFog", Projection::perspective, true, false, true, true}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(MovedMeshes, AreThoseThatWereMadeThere) {
    Molecule m = molecule("sample:dna");
    MovingScene moving(m, drawnAtoms(m), {Style::cartoon, ColorScheme::element});
    RenderSettings s = settings(moving.scene(), 64, Projection::orthographic);
    for (const Visibility path : {Visibility::tiles, Visibility::encoded}) {
        ValidatedRenderer moved(path), made(path);
        moved->setScene(moving.scene());
        LayerPicture before = moved->layers(s);
        for (const float bend : {0.02f, 0.08f}) {
            for (Atom& atom : m.atoms) atom.position.x += bend * atom.position.y;
            moving.move(m);
            moved->moveScene(moving.scene());
            made->setScene(moving.scene());
            const LayerPicture a = moved->layers(s), b = made->layers(s);
            EXPECT_TRUE(a.id == b.id) << visibilityName(path);
            EXPECT_TRUE(a.z == b.z) << visibilityName(path);
            EXPECT_FALSE(a.z == before.z) << visibilityName(path);
            before = a;
        }
    }
}

}  // namespace
}  // namespace nacre::test
