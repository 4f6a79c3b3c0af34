// Lists of tiles that the device makes show the same pixels as those of the host, and as triangles.

#include <cstdlib>
#include <functional>

#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

enum class ListMaker { host, device };

/// @param room  for entries of the device's lists; 1: as usual
std::unique_ptr<ValidatedRenderer> byTiles(ListMaker lists, std::size_t room = 1) {
    setenv("NACRE_DEVICE_LISTS", lists == ListMaker::device ? std::to_string(room).c_str() : "0", 1);
    auto renderer = std::make_unique<ValidatedRenderer>(Visibility::tiles, ValidatedRenderer::fresh);
    unsetenv("NACRE_DEVICE_LISTS");
    return renderer;
}

struct ListedView {
    const char* name;
    Style style;
    Projection projection;
    std::function<void(RenderSettings&)> change;
};

const ListedView kListedViews[] = {
    {"Spheres", Style::spacefill, Projection::orthographic, [](RenderSettings&) {}},
    {"Ribbons", Style::cartoon, Projection::orthographic, [](RenderSettings&) {}},
    {"SpheresInPerspective", Style::spacefill, Projection::perspective, [](RenderSettings&) {}},
    {"SticksInPerspective", Style::ballAndStick, Projection::perspective, [](RenderSettings&) {}},
    {"Turned", Style::ballAndStick, Projection::orthographic, [](RenderSettings& s) { s.view.quarterTurns = 1; }},
    {"Large", Style::spacefill, Projection::orthographic, [](RenderSettings& s) { s.view.pixelsPerAngstrom *= 12; }},
    {"Panned", Style::spacefill, Projection::orthographic,
     [](RenderSettings& s) {
         s.view.pan = {9, -7};
     }},
    {"Outlined", Style::ballAndStick, Projection::orthographic,
     [](RenderSettings& s) { s.effects.contours.width = 3; }},
    {"WithHalos", Style::ballAndStick, Projection::orthographic, [](RenderSettings& s) { s.effects.halos.width = 5; }},
    {"Empty", Style::spacefill, Projection::orthographic,
     [](RenderSettings& s) {
         s.view.pan = {900, 0};
     }},
};
void PrintTo(const ListedView& c, std::ostream* out) { *out << c.name; }

class DeviceLists : public testing::TestWithParam<ListedView> {
protected:
    static void SetUpTestSuite() {
        host_ = byTiles(ListMaker::host);
        device_ = byTiles(ListMaker::device);
    }
    static void TearDownTestSuite() { host_.reset(), device_.reset(); }
    static std::string decision(Renderer& renderer, const char* what) {
        for (const Decision& d : renderer.decisions())
            if (d.what == what) return d.how;
        return "none";
    }
    static inline std::unique_ptr<ValidatedRenderer> host_, device_;
};

TEST_P(DeviceLists, ShowTheSamePixels) {
    const Representation r = scene("sample:dna", GetParam().style);
    RenderSettings s = settings(r, 200, GetParam().projection);
    GetParam().change(s);
    (*host_)->setScene(r);
    (*device_)->setScene(r);
    const Picture expected = (*host_)->render(s), shown = (*device_)->render(s);
    if (decision(*host_->operator->(), "path") == "tiles") {
        EXPECT_EQ(decision(*device_->operator->(), "geometry"), "lists of the device");
        EXPECT_EQ(decision(*host_->operator->(), "geometry"), "lists of the host");
    } else {  // rims, where compute does not shade
        EXPECT_TRUE(s.effects.rims());
    }
    EXPECT_EQ(shown.rgba, expected.rgba);
    const LayerPicture layers = (*host_)->layers(s), other = (*device_)->layers(s);
    EXPECT_EQ(other.id, layers.id);
    EXPECT_EQ(other.z, layers.z);
    // Lists of a second frame begin empty again.
    EXPECT_EQ((*device_)->render(s).rgba, expected.rgba);
}

/// Without subgroup operations, as on phones: by a path, the same pixels as by triangles.
class TilesOfPhones : public testing::TestWithParam<ListedView> {
protected:
    static void SetUpTestSuite() {
        setenv("NACRE_NO_SUBGROUPS", "1", 1);
        tiles_ = std::make_unique<ValidatedRenderer>(Visibility::tiles, ValidatedRenderer::fresh);
        triangles_ = std::make_unique<ValidatedRenderer>(Visibility::fragdepth, ValidatedRenderer::fresh);
        unsetenv("NACRE_NO_SUBGROUPS");
    }
    static void TearDownTestSuite() { tiles_.reset(), triangles_.reset(); }
    static inline std::unique_ptr<ValidatedRenderer> tiles_, triangles_;
};

TEST_P(TilesOfPhones, ShowTheSamePixels) {
    const Representation r = scene("sample:dna", GetParam().style);
    RenderSettings s = settings(r, 200, GetParam().projection);
    GetParam().change(s);
    (*tiles_)->setScene(r);
    (*triangles_)->setScene(r);
    const Picture expected = (*triangles_)->render(s);
    EXPECT_EQ((*tiles_)->render(s).rgba, expected.rgba);
    if (!s.effects.rims()) {  // those are drawn by `deferred`
        std::string told;
        for (const Decision& d : (*tiles_)->decisions())
            if (d.what == "path" || d.what == "shading" || d.what == "geometry") told += d.how + "; ";
        EXPECT_EQ(told, "tiles; fragments, by an image of numbers; lists of the device; ");
    }
    const LayerPicture layers = (*triangles_)->layers(s), other = (*tiles_)->layers(s);
    EXPECT_EQ(other.id, layers.id);
    EXPECT_EQ(other.z, layers.z);
    EXPECT_EQ((*tiles_)->render(s).rgba, expected.rgba) << "the next frame";
}

INSTANTIATE_TEST_SUITE_P(Views, TilesOfPhones, testing::ValuesIn(kListedViews),
                         [](const auto& i) { return i.param.name; });

TEST(TilesOfPhonesInRounds, ShowTheSamePixels) {
    setenv("NACRE_NO_SUBGROUPS", "1", 1);
    for (const Style style : {Style::spacefill, Style::cartoon}) {
        const Representation r = scene("sample:dna", style);
        const auto tiles = byTiles(ListMaker::device, 2 * (r.spheres.size() + r.triangles.size()));
        ValidatedRenderer triangles(Visibility::fragdepth, ValidatedRenderer::fresh);
        const RenderSettings s = settings(r, 200, Projection::orthographic);
        (*tiles)->setScene(r);
        triangles->setScene(r);
        const Picture expected = triangles->render(s);
        for (int frame = 0; frame < 2; ++frame) EXPECT_EQ((*tiles)->render(s).rgba, expected.rgba);
        const std::string& plan = (*tiles)->planText();
        EXPECT_NE(plan.find("lists: sort"), plan.rfind("lists: sort")) << "one round";
    }
    unsetenv("NACRE_NO_SUBGROUPS");
}

/// Layers are drawn by the depth of what compute found.
TEST(TilesOfPhonesBehindLayers, ShowTheSamePixels) {
    setenv("NACRE_NO_SUBGROUPS", "1", 1);
    Representation r = scene("sample:dna", Style::ballAndStick);
    for (const float size : {5.0f, 3.0f})
        appendMesh(
            icosphere({0.2f, 0, 0}, size, 3, 0), glm::dvec3(0),
            [](std::uint32_t) {
                return SphereLook{withOpacity(0xff4080ffu, 0.4), 0};
            },
            r);
    const RenderSettings s = settings(r, 200, Projection::perspective);
    ValidatedRenderer tiles(Visibility::tiles, ValidatedRenderer::fresh);
    ValidatedRenderer triangles(Visibility::fragdepth, ValidatedRenderer::fresh);
    unsetenv("NACRE_NO_SUBGROUPS");
    tiles->setScene(r);
    triangles->setScene(r);
    const Picture shown = tiles->render(s);
    EXPECT_EQ(shown.rgba, triangles->render(s).rgba);
    r.triangles.clear();
    triangles->setScene(r);
    EXPECT_NE(shown.rgba, triangles->render(s).rgba);
}

INSTANTIATE_TEST_SUITE_P(Views, DeviceLists, testing::ValuesIn(kListedViews),
                         [](const auto& i) { return i.param.name; });

/// The picture's size changes, and the scene has copies.
TEST(DeviceListsOfCopies, ShowTheSamePixels) {
    Molecule m = molecule("sample:dna");
    addCopies(m, {glm::vec3(24, 0, 0), glm::vec3(3, 20, 4), glm::vec3(-20, 11, 7)});
    RepresentationOptions options{.style = Style::ballAndStick, .color = ColorScheme::element, .assembly = "1"};
    const Representation r = represent(m, drawnAtoms(m), options);
    const auto host = byTiles(ListMaker::host), device = byTiles(ListMaker::device);
    (*host)->setScene(r);
    (*device)->setScene(r);
    for (const std::uint32_t side : {320u, 90u, 240u}) {
        const RenderSettings s = settings(r, side, Projection::orthographic);
        EXPECT_EQ((*device)->render(s).rgba, (*host)->render(s).rgba) << side;
    }
}

/// Buffers grow from scene to scene, and a new one may have the handle of the last.
TEST(DeviceListsOfScenes, ShowTheSamePixels) {
    const auto host = byTiles(ListMaker::host), device = byTiles(ListMaker::device);
    for (const char* name : {"sample:glucose", "sample:dna", "sample:glucose", "sample:buckyball"}) {
        const Representation r = scene(name, Style::spacefill);
        const RenderSettings s = settings(r, 128, Projection::orthographic);
        (*host)->setScene(r);
        (*device)->setScene(r);
        EXPECT_EQ((*device)->render(s).rgba, (*host)->render(s).rgba) << name;
    }
}

/// Samples at edges, which search the lists.
TEST(DeviceListsOfEdges, ShowTheSamePixels) {
    const Representation r = scene("sample:dna", Style::ballAndStick);
    RenderSettings s = settings(r, 200, Projection::orthographic);
    s.supersample = RenderSettings::kEdges;
    const auto host = byTiles(ListMaker::host), device = byTiles(ListMaker::device);
    (*host)->setScene(r);
    (*device)->setScene(r);
    EXPECT_EQ((*device)->render(s).rgba, (*host)->render(s).rgba);
}

/// Lists that do not fit their memory are made and drawn in several rounds.
TEST(DeviceListsInRounds, ShowTheSamePixels) {
    const auto host = byTiles(ListMaker::host);
    for (const Style style : {Style::spacefill, Style::ballAndStick, Style::cartoon}) {
        const Representation r = scene("sample:dna", style);
        const auto device =
            byTiles(ListMaker::device, 2 * (r.spheres.size() + r.cylinders.size() + r.triangles.size()));
        const RenderSettings s = settings(r, 200, Projection::orthographic);
        (*host)->setScene(r);
        (*device)->setScene(r);
        for (int frame = 0; frame < 2; ++frame) {
            EXPECT_EQ((*device)->render(s).rgba, (*host)->render(s).rgba);
            const std::string& plan = (*device)->planText();
            const std::size_t first = plan.find("lists: sort");
            ASSERT_NE(first, std::string::npos);
            EXPECT_NE(plan.find("lists: sort", first + 1), std::string::npos) << "one round";
        }
        const LayerPicture layers = (*host)->layers(s), other = (*device)->layers(s);
        EXPECT_EQ(other.id, layers.id);
        EXPECT_EQ(other.z, layers.z);
    }
}

}  // namespace
}  // namespace nacre::test
