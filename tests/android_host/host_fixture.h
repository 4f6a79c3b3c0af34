#pragma once
// A folder of its own for each test, pictures to compare, and every fault a failure.

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/android/render_thread.h"
#include "tests/android_host/expected.h"
#include "tests/android_host/host.h"

namespace nacre::test {

/// What SwiftShader draws in no time.
inline constexpr const char* kBaked = R"({"input": "sample:glucose", "occlusion": 32})";
inline constexpr const char* kQuick = R"({"input": "sample:glucose", "occlusion": "off"})";

inline constexpr Covered kMenu{100, 75};  // where the button stands, in a window of one pixel a point

inline void sleep(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

class AndroidHost : public testing::Test {
protected:
    AndroidHost() {
        char name[] = "/tmp/nacre-android-XXXXXX";
        folder_ = mkdtemp(name);
        app::mainThreadPatience = 600;  // tests of other patience say so
    }
    ~AndroidHost() override {
        for (const std::string& fault : Faults::take()) ADD_FAILURE() << fault;
        std::filesystem::remove_all(folder_);
    }

    /// Waits until the window shows the view that the activity would save, to the last pixel.
    static void expectAsRendered(Host& host, Covered covered = kMenu, const char* what = "",
                                 std::uint32_t samples = app::ViewerOptions{}.mostSamples) {
        EXPECT_TRUE(eventually([&] { return host.picture().width > 0; })) << what << ": there is no picture";
        const app::PictureDescription view = host.view();
        const WindowPicture first = host.picture();
        const WindowPicture expected = expectedPicture(view, first.width, first.height, samples);
        Difference d;
        for (int i = 0; i < 100; ++i) {
            d = measureDifference(host.picture(), expected, covered);
            if (d.small()) break;
            sleep(0.2);
        }
        EXPECT_TRUE(d.small()) << what << " differs in " << d.pixels << " of " << d.coloured << " by up to "
                               << d.largest << ", " << d.mean << " on average";
        EXPECT_GT(d.coloured, static_cast<int>(first.width * first.height / 60)) << what;
        if (d.small()) return;
        writePpm(host.picture(), "/tmp/nacre-android-shown.ppm");
        writePpm(expected, "/tmp/nacre-android-expected.ppm");
    }

    /// Waits for a condition: a minute, in case other programs are busy.
    template <typename Condition>
    static bool eventually(Condition condition) {
        for (int i = 0; i < 1200; ++i) {
            if (condition()) return true;
            sleep(0.05);
        }
        return false;
    }

    std::filesystem::path folder_;
};

/// Whether the text box low in the window is there.
inline bool saysSomething(const WindowPicture& p) {
    if (p.rgb.empty()) return false;
    const std::size_t at = std::size_t{3} * (std::size_t{p.height - 20} * p.width + p.width / 2 - 40);
    return p.rgb[at] < 40 && p.rgb[at + 1] < 40 && p.rgb[at + 2] < 50;
}

}  // namespace nacre::test
