// `nacre xr` with a headset of our own: the pictures of both eyes, and the life of its sessions.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "app/xr/xr_session.h"
#include "engine/error.h"
#include "engine/srgb.h"
#include "tests/support/error_text.h"
#include "tests/support/no_cache.h"
#include "tests/xr_runtime/runtime.h"

namespace nacre::app {
namespace {

using xr_runtime::runtime;
using xr_runtime::ShownFrame;

constexpr float kHalfEyes = 0.032f;

/// Eyes at eye height of the room's origin that look ahead.
std::array<XrView, 2> eyesAt(XrVector3f head, float canted = 0) {
    std::array<XrView, 2> eyes{};
    for (std::size_t i = 0; i < 2; ++i) {
        const float side = i == 0 ? -1.0f : 1.0f;
        eyes[i].type = XR_TYPE_VIEW;
        eyes[i].pose.orientation = {0, std::sin(-side * canted / 2), 0, std::cos(-side * canted / 2)};
        eyes[i].pose.position = {head.x + side * kHalfEyes, head.y, head.z};
        eyes[i].fov = {i == 0 ? -0.65f : -0.5f, i == 0 ? 0.5f : 0.65f, 0.55f, -0.6f};
    }
    return eyes;
}

class HeadsetTest : public testing::Test {
protected:
    HeadsetTest() {
        setenv("XR_RUNTIME_JSON", NACRE_XR_RUNTIME, 1);
        setenv("NACRE_MULTIVIEW", "1", 1);  // so that lavapipe draws both eyes in one frame, too
        runtime().reset();
        runtime().eyes = [](XrTime) { return eyesAt({0, 0, 0}); };
        first.input.path = "sample:dna";
        first.occlusion.directions = 0;
        first.device.validate = true;
        first.device.multisampling = Multisampling::off;
        first.device.visibility = Visibility::fragdepth;
    }
    ~HeadsetTest() override {
        EXPECT_EQ(runtime().faults, std::vector<std::string>());
        EXPECT_EQ(runtime().sessions, sessions);
    }

    /// Steps until the molecule is there with all of its occlusion, and for some frames more.
    static void show(HeadsetSession& session, int more = 3) {
        const auto done = [&] { return session.viewer().document() && session.viewer().frames().occlusion() >= 1; };
        for (int i = 0; i < 5000 && !done(); ++i) ASSERT_TRUE(session.step());
        for (int i = 0; i < more; ++i) ASSERT_TRUE(session.step());
        EXPECT_EQ(session.renderer()->validationMessages(), std::vector<std::string>());
    }

    /// What nacre draws as a picture, of the eyes that the headset had.
    static std::array<std::vector<std::uint8_t>, 2> pictures(HeadsetSession& session, const std::array<XrView, 2>& eyes,
                                                             const PictureDescription& first) {
        std::array<EyePose, 2> poses;
        for (std::size_t i = 0; i < 2; ++i) {
            const auto& [o, p] = eyes[i].pose;
            poses[i].position = {p.x, p.y, p.z};
            poses[i].orientation = glm::normalize(glm::dquat(o.w, o.x, o.y, o.z));
            const auto tangent = [](float angle) { return std::tan(static_cast<double>(angle)); };
            poses[i].left = tangent(eyes[i].fov.angleLeft), poses[i].right = tangent(eyes[i].fov.angleRight);
            poses[i].down = tangent(eyes[i].fov.angleDown), poses[i].up = tangent(eyes[i].fov.angleUp);
        }
        RenderSettings settings = session.viewer().frames().settings();
        Placement placement{{0, 0, -HeadsetSession::kMetresAhead},
                            settings.view.rotation,
                            HeadsetSession::kMetresAcross * settings.view.pixelsPerAngstrom / 1000,
                            settings.view.radius};
        settings.supersample = 1;
        Renderer renderer(first.device);
        renderer.setScene(session.viewer().document()->drawing.joinedScene());
        std::array<std::vector<std::uint8_t>, 2> bytes;
        const EyeViews views = makeViews(placement, poses, runtime().width, runtime().height);
        for (std::size_t i = 0; i < 2; ++i) {
            settings.view = views.views[i];
            const Picture picture = renderer.render(settings);
            for (std::size_t p = 0; p < picture.rgba.size(); ++p)
                bytes[i].push_back(toByte(p % 4 == 3 ? picture.rgba[p] : linearToSrgb(picture.rgba[p])));
        }
        return bytes;
    }

    /// Mean place of pixels that are no background.
    static glm::dvec2 middle(const std::vector<std::uint8_t>& pixels) {
        glm::dvec2 sum(0);
        double count = 0;
        for (std::uint32_t p = 0; p < pixels.size() / 4; ++p) {
            if (pixels[4 * p] == 255 && pixels[4 * p + 1] == 255 && pixels[4 * p + 2] == 255) continue;
            sum += glm::dvec2(p % runtime().width + 0.5, p / runtime().width + 0.5);
            ++count;
        }
        return sum / count;
    }

    PictureDescription first;
    int sessions = 1;
};

using Layers = std::array<std::vector<std::uint8_t>, 2>;

/// By how much channels of pixels differ at most; 256: in size.
int largestDifference(const Layers& a, const Layers& b) {
    int most = 0;
    for (std::size_t eye = 0; eye < 2; ++eye) {
        if (a[eye].size() != b[eye].size()) return 256;
        for (std::size_t i = 0; i < a[eye].size(); ++i) most = std::max(most, std::abs(a[eye][i] - b[eye][i]));
    }
    return most;
}

/// Lavapipe codes sRGB for attachments otherwise than Nacre for pictures.
int rounding(const HeadsetSession& session) {
    return session.renderer()->stats().device.name.starts_with("llvmpipe") ? 1 : 0;
}

TEST_F(HeadsetTest, BothLayersAreThePicturesOfTheirCameras) {
    for (const Visibility path : {Visibility::encoded, Visibility::fragdepth, Visibility::deferred}) {
        first.device.visibility = path;
        const auto eyes = eyesAt({0.05f, -0.03f, 0.02f});
        runtime().reset();
        runtime().eyes = [&](XrTime) { return eyes; };
        HeadsetSession session(first);
        show(session);
        const ShownFrame& shown = runtime().frames.back();
        ASSERT_TRUE(shown.layered);
        EXPECT_LE(largestDifference(shown.pixels, pictures(session, eyes, first)), rounding(session))
            << visibilityName(path);
    }
}

/// On a device that takes fragment density maps (tests/phone_layer/density.h): what it is told of them.
class Foveation : public HeadsetTest {
protected:
    Foveation() {
        std::filesystem::remove(told);
        setenv("NACRE_PHONE_DENSITY", told.c_str(), 1);
    }
    ~Foveation() override {
        std::filesystem::remove(told);
        std::filesystem::remove(made());
    }

    std::set<std::string> maps() const {
        std::ifstream file(told);
        std::set<std::string> lines;
        for (std::string line; std::getline(file, line);) lines.insert(line);
        return lines;
    }

    std::filesystem::path made() const { return told.string() + ".made"; }
    std::ptrdiff_t mapsMade() const {
        std::ifstream file(made());
        return std::count(std::istreambuf_iterator<char>(file), {}, '\n');
    }

    using Lines = std::set<std::string>;
    const std::filesystem::path told =
        std::filesystem::temp_directory_path() / ("nacre_density_" + std::to_string(getpid()));
};

TEST_F(Foveation, OneMapForBothEyesAndThePicturesOfTheirCameras) {
    for (const Visibility path : {Visibility::encoded, Visibility::fragdepth, Visibility::deferred}) {
        first.device.visibility = path;
        runtime().reset();
        runtime().eyes = [](XrTime) { return eyesAt({0.05f, -0.03f, 0.02f}); };
        std::filesystem::remove(told);
        HeadsetSession session(first);
        show(session);
        EXPECT_LE(largestDifference(runtime().frames.back().pixels, pictures(session, runtime().eyes(0), first)), 1);
        EXPECT_EQ(maps(), Lines{"map 3x3, 2 layers from 0, 2 views"}) << visibilityName(path);
    }
}

TEST_F(Foveation, EachCantedEyeHasItsLayer) {
    runtime().eyes = [](XrTime) { return eyesAt({0, 0, 0}, 0.1f); };
    HeadsetSession session(first);
    show(session);
    EXPECT_LE(largestDifference(runtime().frames.back().pixels, pictures(session, runtime().eyes(0), first)), 1);
    EXPECT_EQ(maps(), (Lines{"map 3x3, 1 layers from 0, 0 views", "map 3x3, 1 layers from 1, 0 views"}));
}

TEST_F(Foveation, EyesWithOtherAnglesGetAnotherMap) {
    float wider = 0;
    runtime().eyes = [&](XrTime) {
        auto eyes = eyesAt({0, 0, 0});
        for (XrView& eye : eyes) eye.fov.angleLeft -= wider;
        return eyes;
    };
    HeadsetSession session(first);
    show(session);
    for (int i = 0; i < 4; ++i) {
        wider += 0.05f;
        show(session);
        show(session);
    }
    EXPECT_EQ(mapsMade(), 5);  // eyes that stay keep theirs
    EXPECT_LE(largestDifference(runtime().frames.back().pixels, pictures(session, runtime().eyes(0), first)), 1);
}

TEST_F(Foveation, CanBeSwitchedOff) {
    setenv("NACRE_NO_FOVEATION", "1", 1);
    {
        HeadsetSession session(first);
        show(session);
    }
    unsetenv("NACRE_NO_FOVEATION");
    EXPECT_EQ(maps(), Lines());
}

TEST_F(HeadsetTest, OcclusionIsBakedBesideTheFrames) {
    first.occlusion.directions = 16;
    HeadsetSession session(first);
    show(session);
    const auto baked = pictures(session, runtime().eyes(0), first);
    // A bake in slices rounds elsewhere.
    EXPECT_LE(largestDifference(runtime().frames.back().pixels, baked), 1);
}

TEST_F(HeadsetTest, CantedEyesHaveAFrameEachAndTheSamePictures) {
    const auto eyes = eyesAt({0, 0, 0}, 0.1f);
    runtime().eyes = [&](XrTime) { return eyes; };
    runtime().format = VK_FORMAT_B8G8R8A8_SRGB;
    HeadsetSession session(first);
    show(session);
    EXPECT_LE(largestDifference(runtime().frames.back().pixels, pictures(session, eyes, first)), rounding(session));
}

TEST_F(HeadsetTest, TheMoleculeIsWhereBothEyesMeet) {
    first.input.path = "sample:buckyball";
    HeadsetSession session(first);
    show(session);
    const ShownFrame& shown = runtime().frames.back();
    for (std::size_t i = 0; i < 2; ++i) {
        // 0.8 m ahead of the room's origin, by the pose and the angles that the program states.
        const XrPosef& pose = shown.poses[i];
        const XrFovf& fov = shown.fovs[i];
        const double x = -pose.position.x / HeadsetSession::kMetresAhead, y = 0;
        const double left = std::tan(fov.angleLeft), right = std::tan(fov.angleRight);
        const double down = std::tan(fov.angleDown), up = std::tan(fov.angleUp);
        const glm::dvec2 at = middle(shown.pixels[i]);
        EXPECT_NEAR(at.x, (x - left) / (right - left) * runtime().width, 0.5);
        EXPECT_NEAR(at.y, (up - y) / (up - down) * runtime().height, 0.5);
    }
}

TEST_F(HeadsetTest, PosesAreThoseOfTheTimeWhenTheFrameIsSeen) {
    const auto headAt = [](XrTime time) { return static_cast<float>(time % 1'000'000'000) * 1e-10f; };
    runtime().eyes = [&](XrTime time) { return eyesAt({headAt(time), 0, 0}); };
    HeadsetSession session(first);
    show(session);
    for (const ShownFrame& frame : runtime().frames) {
        if (!frame.layered) continue;
        EXPECT_NEAR(frame.poses[0].position.x, headAt(frame.time) - kHalfEyes, 1e-6);
    }
}

TEST_F(HeadsetTest, OneHandTurnsAndScales) {
    bool held = false;
    float angle = 0, nearer = 0;
    runtime().hands = [&](XrTime) {
        std::array<xr_runtime::Hand, 2> hands;
        hands[1].tracked = true;
        hands[1].select = held;
        hands[1].pose = {{0, std::sin(angle / 2), 0, std::cos(angle / 2)}, {0, 0, -0.5f + nearer}};
        return hands;
    };
    HeadsetSession session(first);
    show(session);
    const Camera before = session.viewer().view().camera;
    angle = 0.3f;
    session.step();
    EXPECT_EQ(session.viewer().view().camera.orientation, before.orientation);  // it does not hold
    held = true;
    session.step();
    angle = 0.8f, nearer = 0.1f;
    session.step();
    const Camera& after = session.viewer().view().camera;
    const glm::dquat turned = glm::angleAxis(0.5, glm::dvec3(0, 1, 0)) * before.orientation;
    EXPECT_NEAR(std::abs(glm::dot(after.orientation, turned)), 1, 1e-6);
    EXPECT_NEAR(after.zoom / before.zoom, std::sqrt(2.0), 1e-4);
    session.step();
    EXPECT_GT(largestDifference(runtime().frames.back().pixels, runtime().frames[runtime().frames.size() - 4].pixels),
              0);
}

TEST_F(HeadsetTest, AHeadThatIsNotTrackedSeesNothingUntilItIs) {
    HeadsetSession session(first);
    show(session);
    runtime().tracked = false;
    session.step();
    EXPECT_FALSE(runtime().frames.back().layered);
    runtime().tracked = true;
    session.step();
    EXPECT_TRUE(runtime().frames.back().layered);
}

TEST_F(HeadsetTest, TheRuntimeEndsIt) {
    HeadsetSession session(first);
    show(session);
    runtime().stop();
    const std::size_t frames = runtime().frames.size();
    session.loop();
    EXPECT_EQ(runtime().frames.size(), frames);
}

TEST_F(HeadsetTest, SoDoesTheUser) {
    HeadsetSession session(first);
    show(session);
    session.loop([] { return true; });
}

TEST_F(HeadsetTest, AnotherSessionFollowsALostOne) {
    sessions = 2;
    HeadsetSession session(first);
    show(session);
    const auto before = runtime().frames.back().pixels;
    runtime().loseSession();
    session.step();
    show(session, 4);
    EXPECT_EQ(largestDifference(runtime().frames.back().pixels, before), 0);
}

TEST_F(HeadsetTest, SessionsThatAreAlwaysLostEndIt) {
    sessions = HeadsetSession::kMostLosses + 1;
    runtime().before = [](int) { runtime().loseSession(); };
    const auto run = [&] { HeadsetSession(first).loop(); };
    EXPECT_EQ(test::errorText(run), "cannot show in a headset: OpenXR: the session was lost 4 times");
}

TEST_F(HeadsetTest, WhatIsMissingIsSaidInALine) {
    sessions = 0;
    const auto open = [&] { HeadsetSession session(first); };
    setenv("XR_RUNTIME_JSON", "/nowhere/runtime.json", 1);
    EXPECT_EQ(test::errorText(open),
              "cannot show in a headset: OpenXR: no runtime is active: start the headset's software, such as Monado, "
              "SteamVR or WiVRn");
    setenv("XR_RUNTIME_JSON", NACRE_XR_RUNTIME, 1);
    runtime().connected = false;
    EXPECT_EQ(test::errorText(open),
              "cannot show in a headset: OpenXR: the runtime finds no headset: is it connected and switched on?");
    runtime().vulkan = false;
    EXPECT_EQ(
        test::errorText(open),
        "cannot show in a headset: OpenXR: the runtime cannot show what Vulkan draws: it has no XR_KHR_vulkan_enable2");
}

}  // namespace
}  // namespace nacre::app
