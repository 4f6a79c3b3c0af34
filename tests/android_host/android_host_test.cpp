// The Android shell as Android has it: callbacks in the system's order and in others, fingers, documents of other apps.
// SwiftShader draws, the validation layer watches, and every picture is compared with one drawn without a window.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

#include "engine/molecule/read.h"
#include "tests/android_host/expected.h"
#include "tests/android_host/host.h"

namespace nacre::test {
namespace {

/// What SwiftShader draws in no time.
constexpr const char* kBaked = R"({"input": "sample:glucose", "occlusion": 8})";
constexpr const char* kQuick = R"({"input": "sample:glucose", "occlusion": "off"})";

constexpr Covered kMenu{100, 75};  // where the button stands, in a window of one pixel a point

void sleep(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

class AndroidHost : public testing::Test {
protected:
    AndroidHost() {
        char name[] = "/tmp/nacre-android-XXXXXX";
        folder_ = mkdtemp(name);
    }
    ~AndroidHost() override {
        for (const std::string& fault : Faults::take()) ADD_FAILURE() << fault;
        std::filesystem::remove_all(folder_);
    }

    /// Waits until the window shows the view that the activity would save, to the last pixel.
    static void expectAsRendered(Host& host, Covered covered = kMenu, const char* what = "",
                                 std::uint32_t samples = app::ViewerOptions{}.mostSamples) {
        const app::SavedView view = host.view();
        const WindowPicture first = host.picture();
        const WindowPicture expected = expectedPicture(view, first.width, first.height, samples);
        Difference d;
        for (int i = 0; i < 100; ++i) {
            d = differenceOf(host.picture(), expected, covered);
            if (d.pixels == 0) break;
            sleep(0.2);
        }
        EXPECT_EQ(d.pixels, 0) << what << " differs by up to " << d.largest;
        EXPECT_GT(d.coloured, static_cast<int>(first.width * first.height / 60)) << what;
        if (d.pixels == 0) return;
        writePpm(host.picture(), "/tmp/nacre-android-shown.ppm");
        writePpm(expected, "/tmp/nacre-android-expected.ppm");
    }

    /// Waits for a condition, at most 20 s.
    template <typename Condition>
    static bool eventually(Condition condition) {
        for (int i = 0; i < 400; ++i) {
            if (condition()) return true;
            sleep(0.05);
        }
        return false;
    }

    std::filesystem::path folder_;
};

TEST_F(AndroidHost, ShowsTheSampleAndThenRests) {
    Host host(folder_, std::nullopt, kBaked);
    host.open(120, 160);
    expectAsRendered(host);
    sleep(0.5);
    const std::uint64_t before = host.frames();
    sleep(2);
    EXPECT_EQ(host.frames(), before);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "occlusion") || std::filesystem::is_empty(folder_ / "occlusion"));
    EXPECT_TRUE(takeLog().empty());
}

TEST_F(AndroidHost, TurnsPicturesForTheDisplay) {
    constexpr Covered kSmallMenu{50, 38};
    Host host(folder_, std::nullopt, kQuick, 80);
    host.open(80, 100, 1);
    expectAsRendered(host, kSmallMenu, "a quarter turn");
    host.resizeWindow(100, 80, 2);
    expectAsRendered(host, kSmallMenu, "half a turn");
    host.resizeWindow(80, 100, 3);
    expectAsRendered(host, kSmallMenu, "three quarters");
    host.resizeWindow(100, 80, 0);
    expectAsRendered(host, kSmallMenu, "upright");
}

TEST_F(AndroidHost, FingersRotateZoomAndFit) {
    Host host(folder_, std::nullopt, kQuick);
    host.open(320, 320);
    host.drag(100, 160, 210, 160, 11);  // the first 10 points tell a drag from a tap
    app::SavedView view = host.view();
    const double half = 50 * M_PI / 180;
    EXPECT_NEAR(view.camera.orientation.w, std::cos(half), 1e-5);
    EXPECT_NEAR(view.camera.orientation.y, std::sin(half), 1e-5);
    expectAsRendered(host);

    const auto two = [](float apart) {
        return std::vector<AInputEvent::Pointer>{{4, 160 - apart, 160}, {9, 160 + apart, 160}};
    };
    host.motion(AMOTION_EVENT_ACTION_DOWN, {{4, 120, 160}});
    host.motion(AMOTION_EVENT_ACTION_POINTER_DOWN | 1 << AMOTION_EVENT_ACTION_POINTER_INDEX_SHIFT, two(40));
    for (float apart = 45; apart <= 80; apart += 5) host.motion(AMOTION_EVENT_ACTION_MOVE, two(apart));
    host.motion(AMOTION_EVENT_ACTION_POINTER_UP | 0 << AMOTION_EVENT_ACTION_POINTER_INDEX_SHIFT, two(80));
    host.motion(AMOTION_EVENT_ACTION_UP, {{9, 240, 160}});
    EXPECT_NEAR(host.view().camera.zoom, 2, 1e-5);
    host.scroll(-1, 160, 160);
    EXPECT_NEAR(host.view().camera.zoom, 2 / 1.15, 1e-5);

    host.tap(250, 160, 2);
    EXPECT_TRUE(eventually([&] { return std::abs(host.view().camera.zoom - 1) < 1e-9; }));
    expectAsRendered(host);
}

TEST_F(AndroidHost, AKeyboardWorksToo) {
    Host host(folder_, std::nullopt, kQuick);
    host.open(160, 160);
    EXPECT_TRUE(host.key(AKEYCODE_3, AKEY_EVENT_ACTION_DOWN));
    EXPECT_EQ(host.view().style, "licorice");
    host.key(AKEYCODE_DPAD_RIGHT, AKEY_EVENT_ACTION_DOWN, AMETA_SHIFT_ON);
    EXPECT_GT(host.view().camera.pan.x, 0);
    EXPECT_FALSE(host.key(AKEYCODE_VOLUME_UP, AKEY_EVENT_ACTION_DOWN));
    host.queue()->inputMethodTakesNext = true;
    host.key(AKEYCODE_1, AKEY_EVENT_ACTION_DOWN);
    EXPECT_EQ(host.view().style, "licorice");
}

/// Whether the text box low in the window is there.
bool saysSomething(const WindowPicture& p) {
    const std::size_t at = std::size_t{3} * (std::size_t{p.height - 20} * p.width + p.width / 2 - 40);
    return p.rgb[at] < 40 && p.rgb[at + 1] < 40 && p.rgb[at + 2] < 50;
}

TEST_F(AndroidHost, ATapNamesAnAtom) {
    Host host(folder_, std::nullopt, kQuick);
    host.open(300, 200);
    expectAsRendered(host);
    EXPECT_FALSE(saysSomething(host.picture()));
    host.tap(150, 100);
    EXPECT_TRUE(eventually([&] { return saysSomething(host.picture()); }));
    sleep(0.5);
    host.tap(4, 190);  // beside it
    expectAsRendered(host);
}

TEST_F(AndroidHost, ThePanelIsReachedByFingers) {
    Host host(folder_, std::nullopt, kQuick);
    host.open(360, 480);
    expectAsRendered(host);
    EXPECT_FALSE(host.back());  // Android's, which ends the activity
    host.tap(40, 36);
    ASSERT_TRUE(eventually([&] { return host.picture().rgb[std::size_t{3} * (360 * 200 + 100)] < 60; }));
    sleep(0.3);
    host.tap(60, 276);  // "Ball and stick"
    EXPECT_TRUE(eventually([&] { return host.view().style == "ball-and-stick"; }));
    host.drag(200, 400, 200, 100);  // scrolls, and turns nothing
    EXPECT_NEAR(std::abs(host.view().camera.orientation.w), 1, 1e-12);
    EXPECT_EQ(host.view().style, "ball-and-stick");
    EXPECT_TRUE(host.back());
    host.view();  // waits
    EXPECT_FALSE(host.back());
    expectAsRendered(host);
}

TEST_F(AndroidHost, AWindowMayGoAndComeAgain) {
    Host host(folder_, std::nullopt, kQuick);
    host.open(120, 160);
    expectAsRendered(host);
    host.pause();
    host.stop();
    host.destroyWindow();
    const std::uint64_t before = host.frames();
    host.lowMemory();  // gives the device back, and refines no more
    sleep(0.3);
    EXPECT_EQ(host.frames(), before);
    host.start();
    host.resume();
    host.createWindow(160, 120, 1);
    expectAsRendered(host, kMenu, "", 1);
    refuseFrames(2);
    host.redraw();
    expectAsRendered(host, kMenu, "", 1);
    host.destroyWindow();  // and without a pause
    host.createWindow(160, 160);
    host.lowMemory();
    host.setDensity(320);
    host.setContent({0, 20, 160, 150});
    sleep(0.2);
    host.tap(100, 100);
}

TEST_F(AndroidHost, NothingIsDrawnWhileItIsNotSeen) {
    Host host(folder_, std::nullopt, kQuick);
    host.open(160, 160);
    expectAsRendered(host);
    host.key(AKEYCODE_SPACE, AKEY_EVENT_ACTION_DOWN);  // turns by itself
    sleep(0.5);
    host.pause();
    host.stop();
    sleep(0.3);
    const std::uint64_t before = host.frames();
    host.key(AKEYCODE_1, AKEY_EVENT_ACTION_DOWN);
    sleep(1);
    EXPECT_EQ(host.frames(), before);
    host.start();
    host.resume();
    expectAsRendered(host);
}

TEST_F(AndroidHost, TheStateOutlivesTheProcess) {
    std::string state;
    {
        Host host(folder_, std::nullopt, kQuick);
        host.open(160, 200);
        host.key(AKEYCODE_3, AKEY_EVENT_ACTION_DOWN);
        host.drag(80, 100, 80, 160);
        state = host.saveState();
        host.pause();
        host.stop();
    }
    Host restored(folder_, std::nullopt, state);
    restored.open(160, 200);
    EXPECT_EQ(restored.saveState(), state);
    expectAsRendered(restored);
    restored.destroy();
    Host again(folder_);  // from the launcher: as it was left
    EXPECT_EQ(again.saveState(), state);
    again.destroy();
    Host damaged(folder_, std::nullopt, "{\"zoom\": \"far\"}");
    EXPECT_EQ(damaged.saveState(), state);
    EXPECT_FALSE(takeLog().empty());
}

std::string pdbOf(const char* element, double x) {
    char line[400];
    std::snprintf(line, sizeof line,
                  "HETATM    1 %2s   UNK A   1    %8.3f%8.3f%8.3f  1.00  0.00          %2s\n"
                  "HETATM    2 %2s   UNK A   1    %8.3f%8.3f%8.3f  1.00  0.00          %2s\nEND\n",
                  element, x, 0.0, 0.0, element, element, -x, 0.0, 0.0, element);
    return line;
}

TEST_F(AndroidHost, OpensWhatOtherAppsHandOver) {
    Document document;
    document.name = "../../two atoms.pdb";
    document.bytes = pdbOf("FE", 1) + std::string(100000, '\n');
    std::string state;
    {
        Host host(folder_, document);
        host.open(120, 120);
        host.key(AKEYCODE_O, AKEY_EVENT_ACTION_DOWN);  // occlusion off
        ASSERT_TRUE(eventually([&] { return !host.view().input.empty(); }));
        expectAsRendered(host);
        const std::filesystem::path copy = host.view().input;
        EXPECT_EQ(copy.filename(), "two atoms.pdb");
        EXPECT_EQ(copy.parent_path().parent_path(), folder_ / "opened");
        state = host.saveState();
    }
    document.refuses = true;  // leave to read has gone with the activity
    Host host(folder_, document, state);
    host.open(120, 120);
    expectAsRendered(host);
    EXPECT_EQ(host.saveState(), state);
}

TEST_F(AndroidHost, OpensWhatProvidersStream) {
    Document document;
    document.bytes = pdbOf("C", 1) + std::string(1500000, '\n');
    document.hasDescriptor = false;
    Host host(folder_, document);
    host.start();
    ASSERT_TRUE(eventually([&] { return !host.view().input.empty(); }));
    const std::filesystem::path copy = host.view().input;
    EXPECT_EQ(copy.filename(), "7");  // the provider keeps no names
    std::ifstream file(copy, std::ios::binary);
    EXPECT_TRUE(std::string(std::istreambuf_iterator<char>(file), {}) == document.bytes);
}

TEST_F(AndroidHost, SaysWhyADocumentCannotBeOpened) {
    Document document;
    document.refuses = true;
    Host refused(folder_, document);
    refused.open(320, 200);
    EXPECT_TRUE(eventually([&] { return refused.frames() > 0 && saysSomething(refused.picture()); }));
    EXPECT_FALSE(takeLog().empty());
    refused.destroy();
    document.refuses = false;
    document.bytes = "no molecule at all";
    Host senseless(folder_, document);
    senseless.open(320, 200);
    EXPECT_TRUE(eventually([&] { return senseless.frames() > 0 && saysSomething(senseless.picture()); }));
}

TEST_F(AndroidHost, KeepsAFewOfTheOpenedFiles) {
    for (int i = 0; i < 10; ++i) {
        Document document;
        document.name = std::to_string(i) + ".pdb";
        document.bytes = pdbOf("C", 1 + i);
        Host host(folder_, document);
        host.start();
        ASSERT_TRUE(eventually([&] { return !host.view().input.empty(); })) << i;
    }
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_ / "opened")) ++count;
    EXPECT_EQ(count, 8u);
}

TEST_F(AndroidHost, EndsAtOnceWhileADocumentIsStillComing) {
    Document document;
    document.bytes = pdbOf("C", 1);
    document.seconds = 0.3;
    Host host(folder_, document);
    host.open(160, 160);
}

TEST_F(AndroidHost, WithoutADeviceTheActivityEnds) {
    setVulkanBroken(true);
    {
        Host host(folder_, std::nullopt, kQuick);
        host.open(160, 160);
        EXPECT_TRUE(eventually([&] { return host.finishAsked(); }));
        EXPECT_FALSE(takeLog().empty());
        host.tap(80, 80);
        EXPECT_EQ(host.saveState(), "");
    }
    setVulkanBroken(false);
}

/// Everything that the system may do next, one after the other, by chance.
void act(Host& host, std::mt19937& random, bool& started) {
    const auto roll = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const auto place = [&] { return static_cast<float>(roll(200)); };
    switch (roll(14)) {
        case 0:
            if (host.windowIsThere()) return host.destroyWindow();
            return host.createWindow(100 + roll(60), 100 + roll(60), roll(4));
        case 1:
            if (host.windowIsThere()) host.resizeWindow(100 + roll(60), 100 + roll(60), roll(4));
            return;
        case 2:
            started ? (host.pause(), host.stop()) : (host.start(), host.resume());
            started = !started;
            return;
        case 3:
            return host.lowMemory();
        case 4:
            return host.setDensity(160 + 80 * roll(3));
        case 5:
            if (host.queue()) return host.destroyQueue();
            return host.createQueue();
        case 6:
            return refuseFrames(roll(3));
        case 7:
            host.saveState();
            return;
        case 8:
            return host.setContent({roll(20), roll(20), 80 + roll(60), 80 + roll(60)});
        case 9:
            sleep(0.001 * roll(60));
            return;
        default:
            break;
    }
    if (!host.queue()) return;
    constexpr std::int32_t kActions[] = {AMOTION_EVENT_ACTION_DOWN,         AMOTION_EVENT_ACTION_UP,
                                         AMOTION_EVENT_ACTION_MOVE,         AMOTION_EVENT_ACTION_CANCEL,
                                         AMOTION_EVENT_ACTION_POINTER_DOWN, AMOTION_EVENT_ACTION_POINTER_UP};
    if (roll(3) == 0)
        host.key(roll(260), roll(2), roll(2) * AMETA_SHIFT_ON);
    else
        host.motion(kActions[roll(6)], {{roll(3), place(), place()}});
}

TEST_F(AndroidHost, SurvivesAnyOrder) {
    // More of them by hand: NACRE_ANDROID_SEEDS=50
    const char* asked = std::getenv("NACRE_ANDROID_SEEDS");
    const int seeds = asked ? std::atoi(asked) : 1;
    for (int seed = 1; seed <= seeds; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        // Two activities of one process, as when a second document is opened.
        Host first(folder_, std::nullopt, kQuick), second(folder_, std::nullopt, kQuick);
        bool firstStarted = false, secondStarted = false;
        for (int i = 0; i < 40; ++i) {
            act(first, random, firstStarted);
            act(second, random, secondStarted);
        }
        if (seed != seeds) continue;
        second.destroy();
        refuseFrames(0);
        if (first.windowIsThere()) first.destroyWindow();
        if (firstStarted) first.pause(), first.stop();
        Host last(folder_, std::nullopt, first.saveState());
        last.open(160, 160);
        EXPECT_FALSE(last.finishAsked());
    }
}

}  // namespace
}  // namespace nacre::test
