// What the device draws right is found out by drawing, on a phone whose driver may be wrong (tests/phone_layer).

#include "engine/self_test.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "engine/error.h"
#include "engine/renderer.h"
#include "engine/self_test/scenes.h"
#include "tests/support/temporary_folder.h"

namespace nacre::test {
namespace {

using Outcome = PathResult::Outcome;

/// A driver that is wrong in one way for as long as this lives.
struct Wrong {
    explicit Wrong(const char* how) { setenv("NACRE_PHONE_WRONG", how, 1); }
    ~Wrong() { unsetenv("NACRE_PHONE_WRONG"); }
};

DeviceInfo started(const TemporaryFolder& folder, int* tries = nullptr) {
    DeviceOptions options;
    if (tries) options.onSelfTest = [tries] { ++*tries; };
    options.validate = true;
    options.selfTests = folder / "devices";
    const Renderer renderer(options);
    for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
    return renderer.stats().device;
}

Outcome findOutcome(const SelfTest& test, Visibility path) {
    for (const PathResult& r : test)
        if (r.visibility == path) return r.outcome;
    ADD_FAILURE() << visibilityName(path) << " was not tried";
    return {};
}

TEST(SelfTest, IsForAutomaticPathsOfHardware) {
    DeviceOptions options;
    DeviceInfo device;
    device.type = "integrated";
    EXPECT_FALSE(wantsSelfTest(options, device)) << "nowhere to keep it";
    options.selfTests = "devices";
    EXPECT_TRUE(wantsSelfTest(options, device));
    options.visibility = Visibility::encoded;
    EXPECT_FALSE(wantsSelfTest(options, device)) << "asked for";
    options.visibility = Visibility::automatic;
    device.type = "software";
    EXPECT_FALSE(wantsSelfTest(options, device)) << "tested with the program";
}

TEST(SelfTest, DrawsEveryKindOfPrimitiveInBothProjectionsAndTimesThreeSizes) {
    bool triangles = false, sticks = false, all = false;
    for (const TestScene& scene : selfTestScenes()) {
        const Representation& r = scene.representation;
        const bool flat = scene.projection == Projection::orthographic, meshed = !r.triangles.empty();
        triangles = triangles || (flat && meshed && r.spheres.empty());
        sticks = sticks || (flat && !meshed && !r.cylinders.empty());
        all = all || (!flat && meshed && !r.cylinders.empty() && !r.spheres.empty());
    }
    EXPECT_TRUE(triangles);
    EXPECT_TRUE(sticks);
    EXPECT_TRUE(all) << "in perspective";
    const std::vector<TimedScene> timed = timedScenes();
    ASSERT_EQ(timed.size(), PathResult{}.milliseconds.size());
    ASSERT_EQ(timed.size(), 3u);
    EXPECT_EQ(timed[2].representation.spheres.size(), 8 * timed[0].representation.spheres.size());
    EXPECT_GT(timed[1].representation.triangles.size(), 1000u);
    EXPECT_EQ(timed[1].projection, Projection::perspective);
}

TEST(SelfTest, FindsEveryPathOfARightDriverRight) {
    const TemporaryFolder folder;
    int tries = 0;
    const DeviceInfo device = started(folder, &tries);
    EXPECT_EQ(tries, 1);  // whoever waits is told
    EXPECT_EQ(started(folder, &tries).selfTest, device.selfTest);
    EXPECT_EQ(tries, 1);
    const auto kept = keptSelfTest(folder / "devices", device.driverKey);
    ASSERT_TRUE(kept);
    const std::string_view phone = std::getenv("NACRE_PHONE");
    ASSERT_EQ(kept->size(), phone == "mali" ? 5u : 4u);  // the others read nothing in raster order
    for (const PathResult& r : *kept) {
        EXPECT_EQ(r.outcome, Outcome::right) << visibilityName(r.visibility);
        for (const double milliseconds : r.milliseconds) EXPECT_GT(milliseconds, 0);
    }
    EXPECT_EQ(device.selfTest, describe(*kept));
    const bool tells = phone != "moltenvk";  // of what it merges
    EXPECT_EQ(device.mergeFeedback, tells);
    EXPECT_NE(device.selfTest.find(tells ? " ms (3 subpasses as 1, 0 of " : " ms (0 of "), std::string::npos)
        << device.selfTest;
}

TEST(SelfTest, APathThatDrawsWronglyIsNeverTaken) {
    if (std::string_view(std::getenv("NACRE_PHONE")) == "mali") GTEST_SKIP() << "its encoded depth is not blended";
    const TemporaryFolder folder;
    std::string key;
    {
        const Wrong wrong("min");
        const DeviceInfo device = started(folder);
        key = device.driverKey;
        EXPECT_NE(device.visibility, "encoded");
        EXPECT_NE(device.selfTest.find("encoded wrong"), std::string::npos) << device.selfTest;
    }
    const auto kept = keptSelfTest(folder / "devices", key);
    ASSERT_TRUE(kept);
    EXPECT_EQ(findOutcome(*kept, Visibility::encoded), Outcome::wrong);
    EXPECT_EQ(findOutcome(*kept, Visibility::fragdepth), Outcome::right);
    EXPECT_EQ(findOutcome(*kept, Visibility::deferred), Outcome::right);
    // The answer is kept, not found out again: the driver is right by now.
    EXPECT_NE(started(folder).visibility, "encoded");
    // Whoever asks for it gets it.
    DeviceOptions asked{.visibility = Visibility::encoded, .selfTests = folder / "devices"};
    EXPECT_EQ(Renderer(asked).stats().device.visibility, "encoded");
}

TEST(SelfTest, ABakeThatComesOutWrongIsFound) {
    const TemporaryFolder folder;
    const Wrong wrong("dispatch");  // as if nothing had been asked: all is dark
    // A device without a correct path is refused, rather than that it draws wrongly; now and later.
    for (int start = 0; start < 2; ++start) try {
            started(folder);
            ADD_FAILURE() << "it draws";
        } catch (const Error& error) {
            const std::string why = error.what();
            EXPECT_EQ(why.find("unsuitable device: the least "), 0u) << why;
            for (const char* path : {"encoded wrong", "fragdepth wrong", "deferred wrong"})
                EXPECT_NE(why.find(path), std::string::npos) << why;
        }
    DeviceOptions asked{.visibility = Visibility::fragdepth, .selfTests = folder / "devices"};
    EXPECT_NO_THROW(Renderer{asked});
    DeviceInfo listed = Renderer(asked).stats().device;
    listed.visibility = "fragdepth";
    addSelfTest(listed, folder / "devices");
    EXPECT_EQ(listed.visibility, "none");
}

// Arm's driver reads attachments in order, and older ones do not promise it.
TEST(SelfTest, OrderThatNobodyPromisesIsTakenIfItIsFoundRight) {
    if (std::string_view(std::getenv("NACRE_PHONE")) != "android") GTEST_SKIP() << "Arm's without raster order alone";
    setenv("NACRE_PHONE_ARMS_DRIVER", "1", 1);
    const TemporaryFolder folder;
    DeviceOptions options;
    const DeviceInfo untested = Renderer(options).stats().device;
    EXPECT_EQ(untested.visibility, "encoded");
    EXPECT_EQ(untested.encodedFormat, "RGBA16F");  // by MIN
    EXPECT_TRUE(untested.rasterOrder);
    options.selfTests = folder / "devices";
    const DeviceInfo device = Renderer(options).stats().device;
    const std::optional<SelfTest> test = keptSelfTest(options.selfTests, device.driverKey);
    ASSERT_TRUE(test);
    // The software device below the layer keeps the order.
    EXPECT_EQ(findOutcome(*test, Visibility::rasterOrder), Outcome::right);
    const auto keep = [&](const std::string& order) {
        std::ofstream(folder / ("devices/paths-" + device.driverKey))
            << "nacre self-test 7\nencoded right 2 4 8 1 0 0 0 0\n"
            << order << "\ndeferred right 9 9 9 1 0 0 0 0\n";
        return Renderer(options).stats().device.visibility;
    };
    EXPECT_EQ(keep("raster-order right 1 2 4 1 0 0 0 0"), "raster-order");
    EXPECT_EQ(keep("raster-order right 1.8 3.6 7.2 1 0 0 0 0"), "encoded");
    EXPECT_EQ(keep("raster-order wrong 0 0 0 1 0 0 0 0"), "encoded");
    unsetenv("NACRE_PHONE_ARMS_DRIVER");
    EXPECT_FALSE(Renderer(DeviceOptions{}).stats().device.rasterOrder);
}

TEST(SelfTest, AnotherDriverIsTriedAnew) {
    const TemporaryFolder folder;
    int tries = 0;
    setenv("NACRE_PHONE_DRIVER", "the first", 1);
    const std::string key = started(folder, &tries).driverKey;
    setenv("NACRE_PHONE_DRIVER", "its update", 1);
    EXPECT_NE(started(folder, &tries).driverKey, key);
    EXPECT_EQ(tries, 2);
    setenv("NACRE_PHONE_DRIVER", "the first", 1);
    EXPECT_EQ(started(folder, &tries).driverKey, key);
    unsetenv("NACRE_PHONE_DRIVER");
    EXPECT_EQ(tries, 2);  // both answers are kept
}

TEST(SelfTest, APathThatEndedTheProgramTwiceIsNotTriedAgain) {
    const TemporaryFolder folder;
    const std::string key = started(folder).driverKey, file = folder / ("devices/paths-" + key);
    const auto keep = [&](const std::string& text) { std::ofstream(file) << text; };
    keep("nacre self-test 7\nencoded unfinished 0 0 0 1 0 0 0 0\n");
    EXPECT_EQ(started(folder).selfTest.find("ends the program"), std::string::npos);  // tried again
    keep("nacre self-test 7\nencoded unfinished 0 0 0 2 0 0 0 0\n");
    const DeviceInfo device = started(folder);
    EXPECT_EQ(device.selfTest.find("encoded ends the program, fragdepth "), 0u) << device.selfTest;
    EXPECT_NE(device.visibility, "encoded");
    keep("nacre self-test 7\ndeferred right 1 1 1 0 0 0 0 0\ntiles right 1 1 1 0 0 0 0 0\n");
    EXPECT_TRUE(keptSelfTest(folder / "devices", key));
    keep("nacre self-test 7\nencoded right 1 1 1 0 0 0 0 0\ntiles right 1 1 1 0 0 0 0 0\n");
    EXPECT_FALSE(keptSelfTest(folder / "devices", key));
    // What is no answer is none.
    for (const char* text :
         {"", "nacre self-test 6\nencoded right 1 0\n", "nacre self-test 7\nencoded fine 1 1 1 0 0 0 0 0\n",
          "nacre self-test 7\nencoded right 1 0\n", "nacre self-test 7\ndeferred right 1 1 1 0 0 0 0 0\nx"}) {
        keep(text);
        EXPECT_FALSE(keptSelfTest(folder / "devices", key)) << text;
    }
}

TEST(SelfTest, AnotherPathIsTakenWhereItIsFasterByFar) {
    const auto choose = [](SelfTest test) { return choosePath(test, Visibility::encoded, "by its caps"); };
    const auto right = [](Visibility path, double small, double middle, double large) {
        return PathResult{path, Outcome::right, {small, middle, large}};
    };
    const PathResult encoded = right(Visibility::encoded, 2, 4, 8);
    EXPECT_EQ(choose({encoded, right(Visibility::rasterOrder, 1.8, 3.6, 7.2)}).why, "by its caps");
    // Not where it is no faster for one size of scene.
    EXPECT_EQ(choose({encoded, right(Visibility::rasterOrder, 0.5, 1, 7.2)}).why, "by its caps");
    const graph::TestedPath faster = choose({encoded, right(Visibility::rasterOrder, 1.5, 3, 6)});
    EXPECT_EQ(faster.visibility, Visibility::rasterOrder);
    EXPECT_EQ(faster.why, "the fastest here: encoded 2.00 4.00 8.00 ms, raster-order 1.50 3.00 6.00 ms");
    const PathResult wrong{Visibility::rasterOrder, Outcome::wrong};
    EXPECT_EQ(choose({encoded, wrong}).visibility, Visibility::encoded);
    EXPECT_EQ(choose({right(Visibility::fragdepth, 2, 4, 8), right(Visibility::rasterOrder, 1, 2, 4)}).visibility,
              Visibility::rasterOrder);
    const PathResult tiles = right(Visibility::tiles, 0.1, 0.1, 0.1);
    EXPECT_EQ(choose({encoded, tiles}).visibility, Visibility::tiles);
    EXPECT_EQ(choosePath({encoded, tiles}, Visibility::tiles, "by its caps").why, "by its caps");
    EXPECT_FALSE(choose({encoded, tiles}).tilesFail);
    EXPECT_TRUE(choose({encoded, {Visibility::tiles, Outcome::wrong}}).tilesFail);
    const graph::TestedPath none = choose({{Visibility::encoded, Outcome::wrong}});
    EXPECT_EQ(none.visibility, Visibility::automatic);
    EXPECT_NE(none.why.find("no path draws right"), std::string::npos);
}

}  // namespace
}  // namespace nacre::test
