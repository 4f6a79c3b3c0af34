// MolViewSpec scenes in the session of the phones' apps.

#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "app/phone/session.h"
#include "engine/error.h"
#include "tests/phone/run_to_rest.h"
#include "tests/support/headless_surface.h"
#include "tests/support/temporary_folder.h"

namespace nacre::app {
namespace {

std::string makeScene(const std::string& url) {
    return R"({"root": {"kind": "root", "children": [{"kind": "download", "params": {"url": ")" + url +
           R"("}, "children": [{"kind": "parse", "params": {"format": "xyz"}, "children": [{"kind": "structure",
        "params": {"type": "model"}, "children": [{"kind": "component", "params": {"selector": "all"}, "children": [
        {"kind": "representation", "params": {"type": "spacefill"}, "children": [{"kind": "color", "params":
        {"color": "#ff0000"}}]}]}]}]}]}, {"kind": "canvas", "params": {"background_color": "#0000ff"}}]}})";
}

/// The system's part, with a clock that leaps to what is due.
class ScenePhone {
public:
    explicit ScenePhone(const std::string& url) {
        std::ofstream(folder_ / "s.mvsj") << makeScene(url);
        std::ofstream(folder_ / "m.xyz") << "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n";
        PhoneHost host;
        host.validate = true;
        host.surface = test::headlessSurface();
        host.readFile = [](const std::string& path) -> std::string {
            throw Error("cannot read molecule", path, "scenes read their files");
        };
        host.wake = [] {};
        host.clock = [this] { return now_; };
        host.cache = folder_ / "cache";
        PictureDescription view;
        view.input.path = folder_ / "s.mvsj";
        view.occlusion.directions = 0;
        session = std::make_unique<PhoneSession>(std::move(host), view);
        session->resize({1280, 720}, 2);
        session->setSeen(true);
        session->viewer().frames().setMostSamples(1);
    }

    void run() { test::runToRest(*session, now_); }

private:
    const test::TemporaryFolder folder_;
    double now_ = 100;

public:
    std::unique_ptr<PhoneSession> session;
};

TEST(PhoneScenes, AreDrawnAsTheySay) {
    ScenePhone phone("m.xyz");
    phone.run();
    Viewer& viewer = phone.session->viewer();
    ASSERT_TRUE(viewer.document()) << viewer.messages().failure();
    ASSERT_TRUE(viewer.document()->molecule->guide);
    ASSERT_EQ(viewer.document()->drawing.scene().sphereLooks.size(), 3u);
    EXPECT_EQ(viewer.document()->drawing.scene().sphereLooks[0].color, 0xff0000ffu);
    EXPECT_EQ(viewer.frames().settings().background, (std::array<float, 4>{0, 0, 1, 1}));
    EXPECT_GT(phone.session->renderer()->stats().windowFrames, 0u);
    for (const std::string& message : phone.session->renderer()->validationMessages()) ADD_FAILURE() << message;
}

TEST(PhoneScenes, AskBeforeTheyDownload) {
    ScenePhone phone("https://example.invalid/m.xyz");
    phone.run();
    Viewer& viewer = phone.session->viewer();
    EXPECT_FALSE(viewer.document());
    ASSERT_TRUE(viewer.reading().question()) << viewer.messages().failure();
}

}  // namespace
}  // namespace nacre::app
