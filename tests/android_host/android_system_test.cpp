// What Android asks of an app besides windows and documents: Back, the system's bars, a main thread that never hangs,
// the display's rate, heat, mice and pens, the size of text.

#include <cmath>
#include <future>
#include <sstream>
#include <utility>

#include "tests/android_host/host_fixture.h"

namespace nacre::test {
namespace {

struct Place {
    int left = -1, top = -1, height = 0;
};

/// Where the control of a name stands, pixels; -1: it is not there.
Place findPlace(Host& host, const std::string& name) {
    std::istringstream lines(host.java().controls());
    for (std::string line; std::getline(lines, line);) {
        if (line.find('\t' + name + '\t') == std::string::npos) continue;
        std::vector<std::string> fields;
        std::istringstream parts(line);
        for (std::string part; std::getline(parts, part, '\t');) fields.push_back(part);
        const int top = std::stoi(fields.at(5));
        return {std::stoi(fields.at(4)), top, std::stoi(fields.at(7)) - top};
    }
    return {};
}

TEST_F(AndroidHost, BackClosesThePanelWhereItIsACallback) {
    Host host(folder_, std::nullopt, kQuick);
    host.lowMemory();
    host.open(360, 480);
    ASSERT_TRUE(eventually([&] { return findPlace(host, "Menu").left >= 0; }));
    EXPECT_FALSE(host.java().wantsBack());
    host.java().press("button", "Menu");
    ASSERT_TRUE(eventually([&] { return host.java().wantsBack(); }));
    host.java().back();
    EXPECT_TRUE(eventually([&] { return !host.java().wantsBack(); }));
    EXPECT_TRUE(eventually([&] { return findPlace(host, "Spacefill").left < 0; }));
}

// The first start on a device takes seconds: none of them on the main thread, whatever the system does meanwhile.
TEST_F(AndroidHost, NothingWaitsForADeviceThatIsBeingMade) {
    std::promise<void> made;
    const std::shared_future<void> device = made.get_future().share();
    whileDevicesAreMade([device] { device.wait(); });
    Host host(folder_, std::nullopt, kQuick);
    host.lowMemory();
    host.open(120, 160);
    EXPECT_EQ(host.view().input.path, "sample:glucose");
    host.resizeWindow(160, 120, 1);
    host.pause();
    host.stop();
    host.destroyWindow();
    host.start();
    host.resume();
    host.createWindow(160, 160);
    EXPECT_EQ(host.frames(), 0u);
    made.set_value();
    whileDevicesAreMade({});
    expectAsRendered(host, kMenu, "", 1);
    EXPECT_FALSE(host.finishAsked());
}

// A driver that hangs holds up the render thread alone: what waits for it does so for a while, all waits together.
TEST_F(AndroidHost, NothingWaitsForEverForADriverThatHangs) {
    Host host(folder_, std::nullopt, kQuick);
    host.lowMemory();
    host.open(120, 160);
    expectAsRendered(host, kMenu, "", 1);
    host.setHeldUp(true);
    std::promise<void> goesOn;
    const std::shared_future<void> driver = goesOn.get_future().share();
    std::atomic<bool> hangs{false};
    whileImagesAreAwaited([&hangs, driver] { hangs = true, driver.wait(); });
    host.key(AKEYCODE_3, AKEY_EVENT_ACTION_DOWN);
    ASSERT_TRUE(eventually([&] { return hangs.load(); }));
    app::mainThreadPatience = 0.2;
    host.resume();
    host.pause();
    EXPECT_FALSE(host.saveState().empty());
    host.stop();
    host.destroyWindow();
    host.destroy();
    goesOn.set_value();
    whileImagesAreAwaited({});
    EXPECT_TRUE(eventually([&] { return host.windowsAreLetGo(); })) << "what was left ends once the driver goes on";
    // The frame that hung comes late, which Android's own windows refuse.
    for (const std::string& fault : Faults::take()) EXPECT_EQ(fault, "a frame for a window that is gone");
}

TEST_F(AndroidHost, AMotionAsksForTheDisplaysBestRateAndItsTicks) {
    Host host(folder_, std::nullopt, kQuick);
    host.lowMemory();
    host.open(160, 160);
    host.java().displayRefreshes(60, 120);
    expectAsRendered(host, kMenu, "", 1);
    EXPECT_FALSE(host.java().animated());
    const int before = workReports();
    host.key(AKEYCODE_SPACE, AKEY_EVENT_ACTION_DOWN);  // turns by itself
    ASSERT_TRUE(eventually([&] { return host.java().animated(); }));
    EXPECT_EQ(host.window()->rate, 120);
    const std::uint64_t frames = host.frames();
    for (int i = 0; i < 1200 && host.frames() < frames + 5; ++i) {
        host.java().tick();
        sleep(0.01);
    }
    EXPECT_GE(host.frames(), frames + 5);
    EXPECT_GT(workReports(), before);
    EXPECT_EQ(workTarget(), std::llround(1e9 / 60));
    host.key(AKEYCODE_SPACE, AKEY_EVENT_ACTION_DOWN);
    EXPECT_TRUE(eventually([&] { return !host.java().animated(); }));
    EXPECT_EQ(host.window()->rate, 0);
}

/// The middle of the widest row of red pixels.
std::pair<float, float> placeOfAnOxygen(const WindowPicture& p) {
    std::uint32_t widest = 0;
    std::pair<float, float> place{0, 0};
    for (std::uint32_t y = 0; y < p.height; ++y)
        for (std::uint32_t x = 0, run = 0; x < p.width; ++x) {
            const std::uint8_t* rgb = &p.rgb[std::size_t{3} * (std::size_t{y} * p.width + x)];
            run = rgb[0] > 2 * rgb[1] ? run + 1 : 0;
            if (run > widest) widest = run, place = {static_cast<float>(x) - static_cast<float>(run) / 2, y};
        }
    return place;
}

TEST_F(AndroidHost, APenThatHoversNamesTheAtomBelow) {
    Host host(folder_, std::nullopt, kQuick);
    host.lowMemory();
    host.open(300, 200);
    expectAsRendered(host, kMenu, "", 1);
    EXPECT_FALSE(saysSomething(host.picture()));
    const auto [x, y] = placeOfAnOxygen(host.picture());
    const auto hover = [&](std::int32_t action) { host.pointer(AMOTION_EVENT_TOOL_TYPE_STYLUS, action, x, y); };
    hover(AMOTION_EVENT_ACTION_HOVER_ENTER);
    hover(AMOTION_EVENT_ACTION_HOVER_MOVE);
    EXPECT_TRUE(eventually([&] { return saysSomething(host.picture()); }));
    hover(AMOTION_EVENT_ACTION_HOVER_EXIT);
    EXPECT_TRUE(eventually([&] { return !saysSomething(host.picture()); }));
}

// A screen reader makes the finger that explores a hovering one: its places go to the controls, not to the picture.
TEST_F(AndroidHost, AFingerThatExploresByTouchGoesToTheScreenReader) {
    Host host(folder_, std::nullopt, kQuick);
    host.lowMemory();
    host.open(300, 200);
    expectAsRendered(host, kMenu, "", 1);
    host.pointer(AMOTION_EVENT_TOOL_TYPE_FINGER, AMOTION_EVENT_ACTION_HOVER_ENTER, 144, 86);
    EXPECT_EQ(host.java().explored(), std::pair(144.0, 86.0));
    sleep(1);
    EXPECT_FALSE(saysSomething(host.picture()));
}

TEST_F(AndroidHost, MemoryIsGivenBackInTheBackground) {
    Host host(folder_, std::nullopt, kQuick);
    host.lowMemory();
    host.open(120, 160);
    expectAsRendered(host, kMenu, "", 1);
    const auto leaveAndReturn = [&](int level) {
        const int before = devicesMade();
        host.pause();
        host.stop();
        host.destroyWindow();
        host.java().trim(level);
        host.view();  // waits
        host.start();
        host.resume();
        host.createWindow(120, 160);
        expectAsRendered(host, kMenu, "", 1);
        return devicesMade() - before;
    };
    EXPECT_EQ(leaveAndReturn(20), 0) << "hidden: the device stays";
    EXPECT_EQ(leaveAndReturn(40), 1) << "in the background: it is made again";
}

TEST_F(AndroidHost, AnIntentSwitchesTheValidationLayerOn) {
    for (const bool wanted : {false, true}) {
        intentValidates = wanted;
        Host host(folder_, std::nullopt, kQuick);
        host.lowMemory();
        host.open(120, 160);
        ASSERT_TRUE(eventually([&] { return host.frames() > 0; }));
        EXPECT_EQ(validationAsked(), wanted);
    }
    intentValidates = false;
}

}  // namespace
}  // namespace nacre::test
