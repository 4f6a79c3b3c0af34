#include "app/picture/saved_view.h"

#include <gtest/gtest.h>

#include <ctime>

#include "app/input/input_files.h"
#include "app/picture/appearance_values.h"
#include "engine/error.h"
#include "tests/support/error_text.h"

namespace nacre::app {
namespace {

TEST(SavedView, ComesBackToTheLastDigit) {
    PictureDescription view;
    view.input.path = "/tmp/a \"b\".pdb";
    view.input.format = Format::pdb;
    view.input.model = 3;
    view.look.assembly = "PAU";
    view.look.style = Style::licorice;
    view.look.color = ColorScheme::chain;
    view.look.cartoon = {HelixForm::cylinder, BaseForm::ladder, true, false};
    view.look.surface.kind = SurfaceKind::gaussian;
    view.look.surface.probe = 1.8;
    view.look.surface.resolution = 0.55;
    view.look.surface.cavities = false;
    view.look.surfaceOpacity = 0.35;
    view.look.cartoonOpacity = 0.8;
    view.look.rules = {parseShow("ligand=ball-and-stick"), parseHide("chain B"), parseColorBy("chain A=#ff8000")};
    view.look.rules[1].on = false;
    view.drawn = {true, false};
    view.camera.projection = Projection::perspective;
    view.camera.fovDegrees = 41.5;
    view.camera.zoom = 1.0 / 3;
    view.camera.pan = {0.1, -2e-7};
    view.camera.orientation = glm::normalize(glm::dquat(0.3, -0.2, 0.9, 0.1));
    view.background = parseColor("#102030");
    view.lighting = false;
    view.occlusion.directions = 0;
    const PictureDescription back = parseSavedView(savedViewJson(view), "test");
    EXPECT_EQ(savedViewJson(back), savedViewJson(view));
    EXPECT_EQ(back.camera.orientation, view.camera.orientation);
    EXPECT_EQ(back.camera.pan, view.camera.pan);
    EXPECT_EQ(back.look, view.look);
}

TEST(SavedView, StatesFilesFromItsFolderOn) {
    EXPECT_EQ(pathInView("/data/a.view.json", "/data/sub/1bna.pdb"), "sub/1bna.pdb");
    EXPECT_EQ(pathInView("/data/a.view.json", "/data/1bna.pdb"), "1bna.pdb");
    EXPECT_EQ(pathInView("/data/a.view.json", "/data/sub/../../other/1bna.pdb"), "/data/sub/../../other/1bna.pdb");
    for (const char* none : {"", "-", "sample:dna", "pdb:1bna"}) EXPECT_EQ(pathInView("/data/a.view.json", none), none);
    InputOptions input;  // which leads there again
    input.path = "sub/1bna.pdb";
    input.namedBy = "/data/a.view.json";
    EXPECT_EQ(resolveInputPath(input), "/data/sub/1bna.pdb");
}

TEST(SavedView, AnEmptyObjectIsTheDefault) {
    PictureDescription standard;
    standard.aim.fits = false;  // a view keeps its scale
    EXPECT_EQ(savedViewJson(parseSavedView("{}", "test")), savedViewJson(standard));
}

TEST(SavedView, BadFilesAreRefusedByTheirKey) {
    for (const auto& [json, word] :
         std::vector<std::pair<const char*, const char*>>{{"", "not a JSON"},
                                                          {"[]", "not a JSON"},
                                                          {"{\"zoom\": 0}", "zoom"},
                                                          {"{\"zoom\": \"wide\"}", "zoom"},
                                                          {"{\"style\": \"hologram\"}", "style"},
                                                          {"{\"helices\": \"spring\"}", "helices"},
                                                          {"{\"probe\": 11}", "probe"},
                                                          {"{\"model\": 1.5}", "model"},
                                                          {"{\"orientation\": [0, 0, 0, 0]}", "orientation"},
                                                          {"{\"orientation\": [1, 0, 0]}", "orientation"},
                                                          {"{\"pan\": [1, null]}", "pan"},
                                                          {"{\"rules\": [{\"paint\": \"all\"}]}", "rules"},
                                                          {"{\"rules\": [{\"off\": true}]}", "rules"},
                                                          {"{\"rules\": [{\"hide\": \"all\", \"off\": 1}]}", "rules"},
                                                          {"{\"rules\": [{\"hide\": \"chain (\"}]}", "rules"},
                                                          {"{\"background\": 5}", "background"},
                                                          {"{\"water\": true}", "water"},
                                                          {"{\"colour\": \"element\"}", "colour"},
                                                          {"{\"scripts\": 1}", "views are files of --save-view"},
                                                          {"[1, 2]", "views are files of --save-view"}}) {
        try {
            parseSavedView(json, "v.json");
            ADD_FAILURE() << json;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("v.json"), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    }
    PictureDescription view;
    EXPECT_THROW(applySavedView("/nowhere/v.json", view), Error);
}

TEST(SavedView, IsRefusedWhereItIsNestedTooDeep) {
    const auto nested = [](std::size_t levels) {
        return R"({"title": ")" + std::string(100, '[') + R"(\"", "rules": )" + std::string(levels, '[') +
               std::string(levels, ']') + "}";
    };
    const auto catchError = [](const std::string& json) -> std::string {
        return test::errorText([&] { parseSavedView(json, "v.json"); });
    };
    const std::string tooDeep = "cannot read view: v.json: it is nested more than 64 levels deep";
    EXPECT_EQ(catchError(nested(64)), tooDeep);
    EXPECT_EQ(catchError(nested(100'000)), tooDeep);
    EXPECT_NE(catchError(nested(63)), tooDeep) << "brackets in strings do not count";
}

TEST(SavedView, ManyKeysAreNoBurden) {
    std::string text = "{";
    for (int i = 0; i < 131'000; ++i) text += "\"k" + std::to_string(i) + "\":1,";
    const std::clock_t begin = std::clock();
    EXPECT_THROW(parseSavedView(text + "\"zoom\":1}", "a.json"), Error);
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 5);  // of processor time; it took 80
}

}  // namespace
}  // namespace nacre::app
