// The session of the phones' apps on a window that nobody sees, as their systems would lead it: SwiftShader, which has
// VK_EXT_headless_surface.

#include "app/phone/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "engine/devices.h"
#include "engine/error.h"
#include "engine/scene/build/representation.h"
#include "engine/self_test.h"
#include "engine/self_test/start_guard.h"
#include "tests/fault_layer/faults.h"
#include "tests/phone/run_to_rest.h"
#include "tests/support/headless_surface.h"
#include "tests/support/temporary_folder.h"

namespace nacre::app {
namespace {

// What a layer says of every surface: SwiftShader's 1280 x 720 take sixteen times as long to draw.
constexpr PixelSize kSize{320, 180};
constexpr double kScale = 1;  // pixels a point

/// Programs' layers are those of the environment: one stands above the driver for as long as this lives.
struct Layer {
    Layer(const char* folder, const char* name) {
        setenv("VK_ADD_LAYER_PATH", folder, 1);
        setenv("VK_INSTANCE_LAYERS", name, 1);
    }
    ~Layer() {
        for (const char* name :
             {"VK_ADD_LAYER_PATH", "VK_INSTANCE_LAYERS", "NACRE_PHONE", "NACRE_PHONE_WRONG", "NACRE_PHONE_FIRST"})
            unsetenv(name);
    }
};

/// A small window on a phone whose driver is wrong in one way.
struct Phone : Layer {
    explicit Phone(const char* wrong)
        : Layer(NACRE_FAULT_LAYER_FOLDER ":" NACRE_PHONE_LAYER_FOLDER, "VK_LAYER_NACRE_faults:VK_LAYER_NACRE_phone") {
        setenv("NACRE_PHONE", "android", 1);
        setenv("NACRE_PHONE_WRONG", wrong, 1);
        setenv("NACRE_PHONE_FIRST", "1", 1);
    }
};

/// The system's part: a surface, a file, a clock.
class Host {
public:
    Host() { faults::setWindowSize(kSize.width, kSize.height); }
    PhoneHost lend() {
        PhoneHost host;
        host.validate = true;
        host.surface = test::headlessSurface();
        host.surface.create = [this, create = host.surface.create](VkInstance instance) {
            ++surfaces;
            return create(instance);
        };
        host.readFile = [](const std::string& path) -> std::string {
            if (path == "/far/water.xyz") return "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n";
            if (path == "/far/pair.pdb")
                return "ATOM      1  C   GLY A   1       0.000   0.000   0.000  1.00  0.00           C\n"
                       "ATOM      2  O   GLY A   1       1.230   0.000   0.000  1.00  0.00           O\n"
                       "ATOM      3  C   GLY B   1       0.000   5.000   0.000  1.00  0.00           C\n"
                       "ATOM      4  O   GLY B   1       1.230   5.000   0.000  1.00  0.00           O\n";
            if (path == "/far/touch.pdb")
                return "ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00  0.00           C\n"
                       "ATOM      2  CB  ALA A   1       1.530   0.000   0.000  1.00  0.00           C\n"
                       "HETATM    3  C1  LIG B   1       1.530   3.800   0.000  1.00  0.00           C\n"
                       "HETATM    4  C2  LIG B   1       0.000   3.800   0.000  1.00  0.00           C\n";
            throw Error("cannot read molecule", path, "it is gone");
        };
        host.wake = [] {};
        host.clock = [this] { return now; };
        host.cache = folder / "cache";
        return host;
    }

    void run(PhoneSession& session, double quiet = 5) { test::runToRest(session, now, quiet); }

    int surfaces = 0;
    const Layer layer{NACRE_FAULT_LAYER_FOLDER, "VK_LAYER_NACRE_faults"};
    const test::TemporaryFolder folder;
    double now = 100;
};

PictureDescription makeView(const std::string& input) {
    PictureDescription view;
    view.input.path = input;
    view.look.style = Style::spacefill;
    view.occlusion.directions = 4;
    return view;
}

std::uint64_t countFrames(const PhoneSession& session) { return session.renderer()->stats().windowFrames; }

void expectValid(const PhoneSession& session) {
    for (const std::string& message : session.renderer()->validationMessages()) ADD_FAILURE() << message;
}

/// A window, and refinements of one sample: SwiftShader takes a second for sixteen.
void begin(PhoneSession& session) {
    session.resize(kSize, kScale);
    session.setSeen(true);
    session.viewer().frames().setMostSamples(1);
}

TEST(PhoneSession, DrawsComesToRestAndPicks) {
    Host host;
    PhoneSession session(host.lend(), makeView("/far/water.xyz"));
    begin(session);
    host.run(session);
    ASSERT_TRUE(session.viewer().document());
    const std::uint64_t drawn = countFrames(session);
    EXPECT_GT(drawn, 0u);
    host.now += 60;
    EXPECT_TRUE(std::isinf(session.step()));
    EXPECT_EQ(countFrames(session), drawn) << "a picture that stands still is not drawn again";

    // A tap in the middle; the display link wakes for the time that a second one would take.
    session.viewer().touch({1, TouchPhase::began, {160, 90}}, host.now);
    session.viewer().touch({1, TouchPhase::ended, {160, 90}}, host.now + 0.05);
    host.now += 0.05;
    host.run(session);
    ASSERT_EQ(session.viewer().picking().picks().size(), 1u);
    EXPECT_EQ(spokenValue(session.viewer().picking().annotations()).substr(0, 6), "Oxygen");

    // A twist of a trackpad.
    const std::string before = session.state();
    session.viewer().gesture(Gesture{.kind = Gesture::Kind::transform, .turn = 0.5}, host.now);
    EXPECT_NE(session.state(), before);
    EXPECT_TRUE(std::filesystem::exists(host.folder / "cache/pipelines.bin"));
    expectValid(session);
}

TEST(PhoneSession, TheDebugPageTellsWhatTheRendererDoes) {
    Host host;
    PhoneSession session(host.lend(), makeView("/far/water.xyz"));
    session.setSeen(true);
    session.resize(kSize, 0.125);  // all of the panel has room
    session.viewer().frames().setMostSamples(1);
    host.run(session);
    for (const auto& [role, name] : {std::pair("button", "Menu"), {"tab", "More"}, {"button", "For developers"}}) {
        session.press(role, name);
        host.run(session, 0.5);
    }
    const auto told = [&] {
        const std::string& device = session.renderer()->stats().device.name;
        for (const Control& control : session.spoken())
            if (control.role == "text" && control.name.starts_with(device)) return control.name;
        return std::string();
    };
    const FrameStats& stats = session.renderer()->stats();
    // It is laid out before the frame that shows it.
    const std::string frames = std::to_string(stats.windowFrames - 1);
    std::string expected =
        stats.device.name + "\n" + stats.device.visibility + ", " + frames + " frames, display 60 Hz";
    if (const std::string driver = describe(session.renderer()->driverFeedback()); !driver.empty())
        expected += "\n" + driver;
    EXPECT_EQ(told(), expected);
    session.viewer().schedule().setDisplayInterval(1 / 120.0);
    session.viewer().schedule().overlayChanged();
    host.run(session, 0.5);
    EXPECT_NE(told().find("display 120 Hz"), std::string::npos) << told();
    EXPECT_NE(told().find(", " + std::to_string(stats.windowFrames - 1) + " frames"), std::string::npos) << told();
    expectValid(session);
}

TEST(PhoneSession, SubmitsNothingInTheBackgroundAndComesBackWithWhatItHad) {
    Host host;
    PhoneSession session(host.lend(), makeView("sample:glucose"));
    begin(session);
    host.run(session);
    const PictureBytes before = session.picture(1);
    const std::string state = session.state();

    session.setSeen(false);
    const std::uint64_t drawn = countFrames(session);
    session.viewer().run(ViewerCommand::autoRotate, host.now);
    for (int i = 0; i < 10; ++i, host.now += 1) EXPECT_TRUE(std::isinf(session.step()));
    EXPECT_EQ(countFrames(session), drawn);
    session.viewer().run(ViewerCommand::autoRotate, host.now);

    session.lowMemory();
    EXPECT_FALSE(session.renderer());
    EXPECT_TRUE(std::isinf(session.step()));
    session.lowMemory();
    EXPECT_EQ(session.state(), state);
    session.setSeen(true);
    host.run(session);
    EXPECT_EQ(host.surfaces, 2);
    EXPECT_GT(countFrames(session), 0u);
    EXPECT_EQ(session.picture(1).rgba, before.rgba);
    expectValid(session);

    // And in the foreground it keeps what it draws with.
    session.lowMemory();
    EXPECT_TRUE(session.renderer());
}

TEST(PhoneSession, WaitsForSubmittedWorkInTheBackgroundAndNoLonger) {
    Host host;
    PhoneSession session(host.lend(), makeView("sample:glucose"));
    EXPECT_TRUE(session.awaitSubmitted(1)) << "without a device there is nothing to wait for";
    begin(session);
    host.run(session);
    session.viewer().resume(host.now);
    session.step();
    session.setSeen(false);
    EXPECT_TRUE(session.awaitSubmitted(600));
    const std::uint64_t fences = faults::count("vkWaitForFences");
    EXPECT_TRUE(session.awaitSubmitted(600)) << "again, when nothing is submitted";
    EXPECT_GT(faults::count("vkWaitForFences"), fences);
    // A device that goes on: the wait ends, and the session lives.
    faults::fail("vkWaitForFences", 2, VK_TIMEOUT);
    EXPECT_FALSE(session.awaitSubmitted(0.001));
    session.setSeen(true);
    host.run(session);
    expectValid(session);
    faults::reset();
}

TEST(PhoneSession, IsRestoredFromItsState) {
    Host host;
    PictureBytes picture;
    std::string state;
    {
        PhoneSession session(host.lend(), makeView("/far/water.xyz"));
        begin(session);
        host.run(session);
        session.viewer().run(ViewerCommand::rotateLeft, host.now);
        session.viewer().run(ViewerCommand::licorice, host.now);
        host.run(session);
        state = session.state();
        picture = session.picture(1);
        EXPECT_EQ(session.shareName(), "water");
    }
    PhoneSession session(host.lend(), parseSavedView(state, "state"));
    begin(session);
    host.run(session);
    EXPECT_EQ(session.picture(1).rgba, picture.rgba);
    // Not a blank sheet: white about the molecule, opaque, and not white on it.
    ASSERT_EQ(picture.rgba.size(), 4u * kSize.width * kSize.height);
    EXPECT_EQ(picture.rgba[0], 255);
    EXPECT_EQ(picture.rgba[3], 255);
    EXPECT_GT(std::count_if(picture.rgba.begin(), picture.rgba.end(), [](std::uint8_t v) { return v < 200; }), 100);
}

TEST(PhoneSession, DrawsInteractions) {
    Host host;
    std::vector<std::uint8_t> plain;
    for (const bool shown : {false, true}) {
        PictureDescription view = makeView("/far/touch.pdb");
        view.look.style = Style::licorice;
        if (shown) view.look.contacts.of = parseSelection("chain B");
        PhoneSession session(host.lend(), view);
        begin(session);
        host.run(session);
        ASSERT_TRUE(session.viewer().document());
        EXPECT_EQ(session.viewer().document()->drawing.scene().contacts.empty(), !shown);
        const std::vector<std::uint8_t> picture = session.picture(1).rgba;
        EXPECT_NE(picture, plain);
        plain = picture;
        expectValid(session);
    }
}

TEST(PhoneSession, ALostDeviceIsReplacedAndTheLossIsSaid) {
    Host host;
    PhoneSession session(host.lend(), makeView("/far/water.xyz"));
    begin(session);
    host.run(session);
    const PictureBytes shown = session.picture(1);
    faults::fail("vkQueueSubmit", 1, VK_ERROR_DEVICE_LOST);
    session.viewer().resume(host.now);
    for (int steps = 0; steps < 1000 && host.surfaces < 2; ++steps, host.now += 1.0 / 60) session.step();
    EXPECT_EQ(host.surfaces, 2);
    EXPECT_TRUE(spokenValue(session.viewer().picking().annotations()).find("the device was lost") != std::string::npos)
        << spokenValue(session.viewer().picking().annotations());
    host.run(session);
    EXPECT_EQ(session.picture(1).rgba, shown.rgba);
    expectValid(session);

    // Again and again within a minute: no picture comes of that, and the app says so.
    try {
        for (int loss = 0; loss < 6; ++loss) {
            faults::fail("vkQueueSubmit", 1, VK_ERROR_DEVICE_LOST);
            session.viewer().resume(host.now);
            for (int steps = 0, before = host.surfaces; steps < 1000 && host.surfaces == before;
                 ++steps, host.now += 1.0 / 60)
                session.step();
        }
        ADD_FAILURE() << "it goes on and on";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).rfind("drawing was given up: ", 0), 0u) << error.what();
    }
    faults::reset();
}

/// What is below the phone's layer is no phone: without validation.
PhoneHost onPhone(Host& host, const std::string& cache) {
    PhoneHost lent = host.lend();
    lent.validate = false;
    lent.cache = cache;
    return lent;
}

void awaitTest(const PhoneSession& session) {
    for (int waited = 0; session.testing() && waited < 60'000; ++waited)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_FALSE(session.testing());
}

TEST(PhoneSession, ShowsAPictureBeforeItTestsTheDeviceAndUsesTheResultAtTheNextStart) {
    const test::TemporaryFolder folder;
    for (int start = 0; start < 2; ++start) {
        Host host;
        const Phone phone("min");
        PhoneSession session(onPhone(host, folder / "cache"), makeView("/far/water.xyz"));
        begin(session);
        host.run(session);
        const DeviceInfo device = session.renderer()->stats().device;
        EXPECT_EQ(device.name, "the least phone");
        if (start == 1) {
            EXPECT_FALSE(session.testing());
            EXPECT_NE(device.visibility, "encoded");
            EXPECT_NE(device.selfTest.find("encoded wrong"), std::string::npos) << device.selfTest;
            continue;
        }
        EXPECT_EQ(device.visibility, "encoded") << "by the table of drivers";
        EXPECT_EQ(device.selfTest, "");
        EXPECT_TRUE(session.testing());
        session.setSeen(false);  // an app in the background draws nothing
        awaitTest(session);
        EXPECT_FALSE(keptSelfTest(folder / "cache/devices", device.driverKey));
        session.setSeen(true);
        host.run(session);
        EXPECT_TRUE(session.testing());
        awaitTest(session);
        EXPECT_TRUE(keptSelfTest(folder / "cache/devices", device.driverKey));
    }
}

TEST(PhoneSession, GivesUpADeviceWhereNoPathDrawsRight) {
    const test::TemporaryFolder folder;
    Host host;
    const Phone phone("dispatch");
    PhoneSession session(onPhone(host, folder / "cache"), makeView("/far/water.xyz"));
    begin(session);
    std::string why;
    try {
        host.run(session);
        EXPECT_GT(countFrames(session), 0u) << "no picture before the test";
        EXPECT_TRUE(session.testing());
        awaitTest(session);
        host.run(session);
    } catch (const Error& error) {
        why = error.what();
    }
    EXPECT_NE(why.find("no path draws right"), std::string::npos) << why;
}

/// One start of the program, by the next test.
TEST(PhoneStart, InTheFolderThatIsNamed) {
    const char* folder = std::getenv("NACRE_START_IN");
    if (!folder) GTEST_SKIP() << "PhoneStart.SurvivesADriverThatEndsTheProgram runs this";
    Host host;
    const Phone phone("cache");
    PhoneSession session(onPhone(host, folder), makeView("/far/water.xyz"));
    begin(session);
    for (int steps = 0; steps < 1000 && (!session.renderer() || countFrames(session) < 3);
         ++steps, host.now += 1.0 / 60)
        session.step();
    EXPECT_GE(countFrames(session), 3u);
}

TEST(PhoneStart, SurvivesADriverThatEndsTheProgram) {
    const test::TemporaryFolder folder;
    const std::string start = "NACRE_START_IN=" + (folder / "cache") + " " +
                              std::filesystem::read_symlink("/proc/self/exe").string() +
                              " --gtest_filter=PhoneStart.InThe* >" + (folder / "log") + " 2>&1";
    // vkCreatePipelineCache crashes. One death may have any cause; two are the driver's.
    std::string outcomes;
    for (int i = 0; i < 6; ++i) outcomes += std::system(start.c_str()) == 0 ? "shown " : "died ";
    EXPECT_EQ(outcomes, "died shown died shown shown shown ");
}

TEST(PhoneStart, TakesFewerRisksEachTimeAndSaysSoInTheEnd) {
    const test::TemporaryFolder folder;
    const std::string devices = folder / "devices";
    { StartGuard(devices).done("key"); }
    const auto keep = [&](const std::string& text) { std::ofstream(devices + "/start") << "nacre start 1\n" << text; };
    keep("key\n1 0 0\n0 0\n");
    EXPECT_EQ(StartGuard(devices).mode(), StartMode::withoutCache);
    EXPECT_EQ(StartGuard(devices).mode(), StartMode::usual) << "a start that was given up is no death";
    keep("key\n1 1 0\n1 0\n");
    EXPECT_EQ(StartGuard(devices).mode(), StartMode::plainPath);
    keep("key\n2 1 0\n-1 0\n");
    EXPECT_EQ(StartGuard(devices).mode(), StartMode::withoutCache);
    { StartGuard(devices).done("another driver's"); }
    EXPECT_EQ(StartGuard(devices).mode(), StartMode::usual);
    keep("key\n2 2 2\n2 0\n");
    EXPECT_THROW(StartGuard{devices}, Error);
    EXPECT_EQ(StartGuard(devices).mode(), StartMode::usual) << "whoever tries again is let";
    keep("no note");
    EXPECT_EQ(StartGuard(devices).mode(), StartMode::usual);
    // Deaths are forgiven after 20 starts that worked: one more try, and one more death is blamed on the driver again.
    keep("key\n2 0 0\n-1 0\n");
    for (int start = 0; start < 20; ++start) {
        StartGuard guard(devices);
        EXPECT_EQ(guard.mode(), StartMode::withoutCache) << start;
        guard.done("key");
    }
    EXPECT_EQ(StartGuard(devices).mode(), StartMode::usual);
    keep("key\n2 0 0\n0 0\n");
    EXPECT_EQ(StartGuard(devices).mode(), StartMode::withoutCache);
    keep("no note");
    const StartGuard first(devices);
    EXPECT_EQ(StartGuard(devices).mode(), StartMode::usual) << "another window of a living program";
    EXPECT_EQ(StartGuard("").mode(), StartMode::usual);
}

TEST(PhoneSession, SaysWhyAFileIsNotShown) {
    Host host;
    PhoneSession session(host.lend(), makeView("sample:glucose"));
    begin(session);
    host.run(session);
    session.viewer().reading().open("/far/gone.pdb", host.now);
    session.viewer().reading().loader().wait();
    session.step();
    EXPECT_NE(spokenValue(session.viewer().picking().annotations()).find("it is gone"), std::string::npos);
    EXPECT_EQ(session.viewer().document()->view.input.path, "sample:glucose");
    EXPECT_EQ(session.shareName(), "glucose");
}

TEST(PhoneSession, OcclusionTakesAPartOfTheMemoryThatMayBeUsed) {
    EXPECT_EQ(occlusionBytes(64 << 20, 0), 64u << 20) << "a device that does not tell";
    EXPECT_EQ(occlusionBytes(64 << 20, std::uint64_t{4} << 30), 64u << 20);
    EXPECT_EQ(occlusionBytes(64 << 20, 256 << 20), 32u << 20);
    EXPECT_EQ(occlusionBytes(64 << 20, 1 << 20), 4u << 20) << "one value per atom has room in that";
}

TEST(PhoneSession, APointerThatTouchesNothingNamesTheAtomBelow) {
    Host host;
    PhoneSession session(host.lend(), makeView("/far/water.xyz"));
    begin(session);
    host.run(session);
    session.hover(glm::dvec2(160, 90));
    host.now += 1;
    host.run(session, 0.5);
    EXPECT_EQ(session.viewer().picking().annotations().hover.substr(0, 6), "Oxygen");
    session.hover(std::nullopt);
    host.run(session, 0.5);
    EXPECT_EQ(session.viewer().picking().annotations().hover, "");
}

TEST(PhoneSession, VoiceOverHearsAndMovesEveryControl) {
    Host host;
    PhoneHost lent = host.lend();
    std::vector<std::string> shared;
    lent.sharePicture = [&](const PictureBytes& picture, const std::string& name) {
        EXPECT_EQ(picture.rgba.size(), 4u * kSize.width * kSize.height);
        shared.push_back(name);
    };
    lent.shareText = [&](const std::string& text, const std::string& name) {
        EXPECT_EQ(parseSavedView(text, name).input.path, "pair.pdb") << "another device has it elsewhere";
        shared.push_back(name);
    };
    PhoneSession session(std::move(lent), makeView("/far/pair.pdb"));
    begin(session);
    session.resize(kSize, 0.25);  // as large as a tablet
    host.run(session);
    const auto value = [&](const std::string& role, const std::string& name) {
        for (const Control& c : session.spoken())
            if (c.role == role && c.name == name) return c.value;
        return std::string("it is not there");
    };
    const auto press = [&](const std::string& role, const std::string& name) {
        session.press(role, name);
        host.run(session);
    };
    EXPECT_EQ(session.spoken().front().role, "image");
    EXPECT_EQ(session.spoken().front().name, "pair.pdb - Nacre");
    press("button", "Menu");
    EXPECT_EQ(value("tab", "Look"), "on");
    press("choice", "Licorice");
    EXPECT_EQ(session.viewer().view().look.style, Style::licorice);
    EXPECT_EQ(value("choice", "Licorice"), "on");
    press("button", "Undo");
    EXPECT_EQ(session.viewer().view().look.style, Style::spacefill);
    press("button", "Save");
    session.run(ViewerCommand::saveView);
    EXPECT_EQ(shared, (std::vector<std::string>{"pair.png", "pair.view.json"}));
    // A slider, a tenth of its way at a time.
    PictureDescription look = session.viewer().view();
    look.look.style = Style::surface;
    session.viewer().setLook(look, host.now);
    host.run(session);
    EXPECT_EQ(value("slider", "Surface opacity"), "1.00");
    session.adjust("Surface opacity", false);
    host.run(session);
    EXPECT_NEAR(session.viewer().view().look.surfaceOpacity, 0.91, 0.05);
    session.viewer().undo(host.now);
    session.viewer().undo(host.now);
    press("tab", "Parts");
    press("button", "Hide Chain A");
    EXPECT_EQ(session.viewer().document()->drawing.scene().drawnAtoms, 2u);
    session.run(ViewerCommand::undo);  // as a shake does
    host.run(session);
    EXPECT_EQ(session.viewer().document()->drawing.scene().drawnAtoms, 4u);
    for (const Control& c : session.spoken()) EXPECT_NE(c.name, "") << c.role;
    expectValid(session);
}

}  // namespace
}  // namespace nacre::app
