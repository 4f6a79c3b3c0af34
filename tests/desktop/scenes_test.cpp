// MolViewSpec scenes in the window of `nacre view`: dropped on it, and saved.

#include <gtest/gtest.h>
#include <zip.h>

#include <filesystem>
#include <fstream>

#include "tests/desktop/x_session.h"
#include "tests/support/run_program.h"

namespace nacre::test {
namespace {

constexpr const char* kScene =
    R"({"root": {"kind": "root", "children": [{"kind": "download", "params": {"url": "m.xyz"},
    "children": [{"kind": "parse", "params": {"format": "xyz"}, "children": [{"kind": "structure", "params":
    {"type": "model"}, "children": [{"kind": "component", "params": {"selector": "all"}, "children": [{"kind":
    "representation", "params": {"type": "spacefill"}, "children": [{"kind": "color", "params": {"color": "#ff0000"}}]}]}]}]}]},
    {"kind": "canvas", "params": {"background_color": "#0000ff"}}]}})";
constexpr const char* kWater = "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n";

void putArchive(const std::string& path) {
    int error = 0;
    zip_t* archive = zip_open(path.c_str(), ZIP_CREATE, &error);
    ASSERT_NE(archive, nullptr);
    const std::string scene(kScene), water(kWater);
    for (const auto& [name, text] : {std::pair("index.mvsj", &scene), {"m.xyz", &water}})
        zip_file_add(archive, name, zip_source_buffer(archive, text->data(), text->size(), 0), 0);
    ASSERT_EQ(zip_close(archive), 0);
}

/// Whether the lower left corner of the window, where nothing lies, is of the scene's background.
bool isBlue(const XSession& session) {
    const WindowPicture p = session.picture();
    if (p.height < 10) return false;
    const std::size_t at = static_cast<std::size_t>((p.height - 2) * p.width + 2) * 3;
    return p.rgb[at] < 20 && p.rgb[at + 1] < 20 && p.rgb[at + 2] > 235;
}

TEST(Window, ADroppedSceneIsShownAndSaved) {
    XSession session("sample:glucose --size 300x300");
    session.type("m");  // hides the panel
    std::ofstream(session.folder() / "m.xyz") << kWater;
    std::ofstream(session.folder() / "s.mvsj") << kScene;
    ASSERT_TRUE(session.drop({session.folder() / "s.mvsj"}));
    EXPECT_TRUE(session.waitForTitle("s.mvsj")) << session.title();
    EXPECT_TRUE(session.waitUntil([&] { return isBlue(session); })) << session.errors();
    // Saved, it says the same from where it is seen now, and nacre reads it.
    session.drag(150, 150, 190, 150);
    session.typeAtOnce({"Control_L+S", "Return"});
    std::string saved;
    EXPECT_TRUE(session.waitUntil([&] {
        for (const auto& entry : std::filesystem::directory_iterator(session.folder().path()))
            if (entry.path().extension() == ".mvsj" && entry.path().filename() != "s.mvsj") saved = entry.path();
        return !saved.empty();
    })) << session.errors();
    const nlohmann::json scene = nlohmann::json::parse(readContents(saved));
    const nlohmann::json& nodes = scene["root"]["children"];
    ASSERT_EQ(nodes.size(), 3u);
    EXPECT_EQ(nodes[0]["kind"], "download");
    EXPECT_EQ(nodes[1]["params"]["background_color"], "#0000ff");
    EXPECT_EQ(nodes[2]["kind"], "camera");
    EXPECT_NE(nodes[2]["params"]["position"][0], nodes[2]["params"]["target"][0]);
    nacreDone(session.folder(), "render '" + saved + "' -o again.png --size 60x60 --occlusion off");
    EXPECT_EQ(session.quit(), 0) << session.errors();
}

TEST(Window, ADroppedArchiveIsShown) {
    XSession session("sample:glucose --size 300x300");
    session.type("m");  // hides the panel
    putArchive(session.folder() / "s.mvsx");
    ASSERT_TRUE(session.drop({session.folder() / "s.mvsx"}));
    EXPECT_TRUE(session.waitForTitle("s.mvsx")) << session.title();
    EXPECT_TRUE(session.waitUntil([&] { return isBlue(session); })) << session.errors();
    EXPECT_EQ(session.quit(), 0) << session.errors();
}

}  // namespace
}  // namespace nacre::test
