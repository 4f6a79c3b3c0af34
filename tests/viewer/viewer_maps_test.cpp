// Density maps in the window: levels by the wheel, and maps that follow the camera.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>

#include "app/drawing/focus.h"
#include "app/input/map_input.h"
#include "app/picture/appearance_values.h"
#include "tests/viewer/viewer_bench.h"

namespace nacre::app::test {
namespace {

TEST(Viewer, TheWheelTurnsTheLevelOfAMapAsOneStep) {
    std::vector<float> values(1000);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 10);
    keepMap("ramp", std::make_shared<const DensityMap>(mapOfValues(
                        "ramp", glm::ivec3(10), {glm::dvec3(10), glm::dvec3(90)}, {}, false, std::move(values))));
    Bench b;
    b.viewer.changeLevel(1, b.now);
    EXPECT_TRUE(b.viewer.view().maps.levels.empty()) << "there is no map";
    PictureDescription look = b.viewer.view();
    look.maps.files = {"ramp"};
    look.maps.levels = {{MapLevel::Unit::value, 4.5}};  // the mean
    b.viewer.setLook(look, b.now);
    b.load();
    ASSERT_EQ(b.viewer.document()->drawing.maps().sigmas.size(), 1u);
    const int scenes = b.screen.scenes;
    for (int i = 0; i < 3; ++i) b.viewer.changeLevel(1, b.now += 0.1);
    EXPECT_EQ(b.viewer.view().maps.levels[0], (MapLevel{MapLevel::Unit::sigma, 0.3}));
    b.load();
    b.load();
    EXPECT_GT(b.screen.scenes, scenes);
    EXPECT_NEAR(b.viewer.document()->drawing.maps().sigmas[0], 0.3, 1e-6);
    b.viewer.undo(b.now + 5);
    EXPECT_EQ(b.viewer.view().maps.levels[0], (MapLevel{MapLevel::Unit::value, 4.5})) << "one turn is one step";
    // A slice has no level.
    look.maps.slices = {{2, 0.5}};
    b.viewer.setLook(look, b.now += 5);
    b.load();
    b.viewer.changeLevel(1, b.now);
    EXPECT_EQ(b.viewer.view().maps.levels, look.maps.levels);
}

TEST(Viewer, TheFirstMapOfAStructureShowsSticksAndContoursNearTheFocus) {
    const std::string path = ::testing::TempDir() + "focus.dx";
    std::ofstream file(path);
    file << "object 1 class gridpositions counts 4 4 4\norigin 0 0 0\ndelta 5 0 0\ndelta 0 5 0\ndelta 0 0 5\n"
            "object 2 class gridconnections counts 4 4 4\n"
            "object 3 class array type double rank 0 items 64 data follows\n";
    for (int i = 0; i < 64; ++i) file << i % 7 << '\n';
    file.close();
    for (const bool chosen : {false, true}) {
        Bench b("sample:dna");
        PictureDescription look = b.viewer.view();
        look.look.style = Style::cartoon;
        if (chosen) look.look.rules.push_back(parseHide("chain B"));
        b.viewer.setLook(look, b.now);
        b.load();
        b.viewer.reading().open(path, b.now);
        b.load();
        EXPECT_EQ(b.viewer.messages().failure(), "");
        ASSERT_EQ(b.viewer.view().maps.files.size(), 1u);
        EXPECT_TRUE(b.viewer.view().maps.aroundFocus);
        EXPECT_EQ(b.viewer.view().look.style, chosen ? Style::cartoon : Style::licorice);
        b.viewer.undo(b.now);
        EXPECT_TRUE(b.viewer.view().maps.files.empty());
        EXPECT_EQ(b.viewer.view().look.style, Style::cartoon);
    }
    std::filesystem::remove(path);
}

TEST(Viewer, ALoneCrystalMapIsSeenFromNear) {
    for (const bool crystal : {true, false}) {
        std::vector<float> values(1000);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 7);
        keepMap("lone.ccp4",
                std::make_shared<const DensityMap>(mapOfValues(
                    "lone.ccp4", glm::ivec3(10), {glm::dvec3(100), glm::dvec3(90)}, {}, crystal, std::move(values))));
        CountingScreen screen;
        Sources nothing{[](const PictureDescription&) { return Molecule(); }};
        PictureDescription opened;
        opened.input.path = "lone.ccp4";
        opened.maps.files = {"lone.ccp4"};
        Viewer viewer(screen, nothing, opened, {});
        viewer.frames().resize({640, 480}, 1, 100);
        viewer.reading().loader().wait();
        viewer.update(101);
        ASSERT_TRUE(viewer.document()) << viewer.messages().failure();
        ASSERT_EQ(viewer.view().maps.files.size(), 1u);
        const PictureDescription& view = viewer.view();
        EXPECT_EQ(view.maps.aroundFocus, crystal);
        const double radius = viewer.document()->drawing.radius();
        EXPECT_GT(radius, 70) << "half of the cell's diagonal";
        EXPECT_NEAR(view.camera.zoom, crystal ? radius / (1.2 * kMapReachOfFocus) : 1, 1e-6);
    }
}

TEST(Viewer, MapsFollowWhatTheCameraLooksAt) {
    keepMap("flat",
            std::make_shared<const DensityMap>(mapOfValues("flat", glm::ivec3(10), {glm::dvec3(10), glm::dvec3(90)}, {},
                                                           false, std::vector<float>(1000, 1))));
    CountingScreen screen;
    Viewer viewer(screen, sampleSources(), Bench::makeView("sample:dna"), {});
    double now = 100;
    const auto rest = [&] {
        for (int i = 0; i < 20; ++i) {
            viewer.reading().loader().wait();
            viewer.update(now += 0.05);
        }
    };
    viewer.frames().resize({640, 480}, 1, now);
    rest();
    PictureDescription look = viewer.view();
    look.maps.files = {"flat"};
    look.maps.aroundFocus = true;
    viewer.setLook(look, now);
    rest();
    ASSERT_TRUE(viewer.document()->drawing.maps().focus);
    const glm::dvec3 first = *viewer.document()->drawing.maps().focus;
    const std::uint64_t before = viewer.document()->drawing.sceneNumber();
    const int scenes = screen.scenes;
    for (int i = 0; i < 5; ++i) viewer.run(ViewerCommand::panLeft, now);
    rest();
    const glm::dvec3 then = *viewer.document()->drawing.maps().focus;
    EXPECT_GT(glm::distance(then, first), 1);
    EXPECT_EQ(screen.scenes, scenes + 1);
    EXPECT_EQ(viewer.document()->drawing.sceneNumber(), before) << "the molecule stays";
    EXPECT_EQ(then, findFocus(*viewer.document()->molecule, viewer.view(),
                              {viewer.view().camera, viewer.document()->drawing.radius()},
                              viewer.document()->drawing.scene().center));
    rest();
    EXPECT_EQ(screen.scenes, scenes + 1) << "it rests";
    // Nor does a level build the molecule, wherever the camera is meanwhile.
    viewer.run(ViewerCommand::rotateLeft, now);
    look = viewer.view();
    look.maps.levels = {{MapLevel::Unit::value, 0.5}};
    viewer.setLook(look, now);
    rest();
    EXPECT_GT(screen.scenes, scenes + 1);
    EXPECT_EQ(viewer.document()->drawing.sceneNumber(), before);
}

}  // namespace
}  // namespace nacre::app::test
