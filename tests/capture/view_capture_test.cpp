// F12 in a real window.

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/capture/inspect.h"
#include "tests/desktop/x_session.h"

namespace nacre::test {
namespace {

/// Presses F12, and waits until the window says something. @returns whether it did
bool pressF12(XSession& session) {
    const WindowPicture before = session.picture();
    session.type("F12");
    return session.waitUntil([&] { return session.picture() != before; });
}

TEST(ViewCapture, F12CapturesTheNextFrame) {
    XSession session("sample:glucose --size 400x300 --visibility encoded --capture");
    const WindowPicture before = session.picture();
    EXPECT_TRUE(pressF12(session));
    session.type("Escape");
    EXPECT_TRUE(session.waitUntil([&] { return session.picture() == before; }));
    EXPECT_EQ(session.quit(), 0) << session.errors();

    const nlohmann::json listing = inspect(session.folder() / "glucose.rdc");
    EXPECT_EQ(listing["unnamed"], nlohmann::json::array());
    ASSERT_EQ(listNames(listing["submissions"]), std::vector<std::string>{"screen"});
    const nlohmann::json& pass = listing["submissions"][0]["steps"][0];
    ASSERT_EQ(pass["subpasses"].size(), 3u);
    EXPECT_EQ(listNames(pass["subpasses"][2]["passes"]), (std::vector<std::string>{"impostor colour", "overlay"}));
    EXPECT_EQ(pass["attachments"][0]["store"], "don't care");
    EXPECT_EQ(pass["attachments"][1]["store"], "don't care");
    EXPECT_EQ(pass["attachments"][2]["store"], "store");
}

TEST(ViewCapture, F12SaysWhatIsMissing) {
    XSession session("sample:glucose --size 400x300");
    EXPECT_TRUE(pressF12(session));
    EXPECT_EQ(session.quit(), 0) << session.errors();
    EXPECT_FALSE(std::filesystem::exists(session.folder() / "glucose.rdc"));
}

}  // namespace
}  // namespace nacre::test
