// No submission of a bake takes as long as phones stop them for, however slow the device turns out to be or becomes.
// Its clock goes by the work that is asked of it (tests/phone_layer/clock.h), not by the machine's.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <numeric>

#include "tests/renderer/scenes.h"
#include "tests/support/temporary_folder.h"

namespace nacre::test {
namespace {

/// A phone on which a corner of a draw takes so long, for as long as this lives.
class SlowPhone {
public:
    explicit SlowPhone(const char* nanoseconds) {
        setenv("NACRE_PHONE_WORK", file_.c_str(), 1);
        become(nanoseconds);
    }
    ~SlowPhone() {
        unsetenv("NACRE_PHONE_WORK");
        unsetenv("NACRE_PHONE_NANOSECONDS");
    }
    static void become(const char* nanoseconds) { setenv("NACRE_PHONE_NANOSECONDS", nanoseconds, 1); }
    /// Of each submission so far.
    std::vector<double> milliseconds() const {
        std::ifstream lines(file_);
        std::vector<double> all;
        for (double each = 0; lines >> each;) all.push_back(each);
        return all;
    }

private:
    TemporaryFolder folder_;
    std::string file_ = folder_ / "work";
};

/// 19,440 atoms: DNA side by side.
Representation manyAtoms() {
    Molecule m = molecule("sample:dna");
    std::vector<glm::vec3> places;
    for (int i = 0; i < 40; ++i) places.emplace_back(30 * (i % 5), 30 * (i / 5 % 2), 80 * (i / 10));
    addCopies(m, places);
    RepresentationOptions options{.style = Style::spacefill, .color = ColorScheme::element, .assembly = "1"};
    return represent(m, drawnAtoms(m), options);
}

/// A bake of 24 directions, on a phone that becomes hot on its way. @returns milliseconds of each submission
std::vector<double> bakeOn(const char* nanoseconds, const char* whenHot) {
    const SlowPhone phone(nanoseconds);
    ValidatedRenderer renderer(Visibility::encoded, ValidatedRenderer::fresh);
    const Representation r = manyAtoms();
    EXPECT_GT(r.drawnAtoms, 19'000u);
    renderer->setScene(r);
    RenderSettings s = settings(r, 16, Projection::orthographic);
    s.occlusion.directions = 24;
    s.occlusion.onProgress = [&](double share) {
        if (share > 0.5) SlowPhone::become(whenHot);
    };
    renderer->render(s);
    EXPECT_EQ(renderer->stats().occlusion.done, 24);
    std::vector<double> all = phone.milliseconds();
    all.pop_back();  // the picture
    return all;
}

TEST(BakeSlices, NoneTakesAsLongAsPhonesStopThemFor) {
    for (const auto& [cold, hot] : {std::pair{"2", "4"}, {"20", "50"}, {"80", "160"}, {"300", "300"}}) {
        const std::vector<double> all = bakeOn(cold, hot);
        std::string told;
        for (const double each : all) told += std::to_string(each) + " ";
        EXPECT_LE(*std::max_element(all.begin(), all.end()), 70) << cold << " ns, then " << hot << ": " << told;
        // Five corners and more in each map: the clock did go.
        EXPECT_GE(std::accumulate(all.begin(), all.end(), 0.0), 19'440 * 24 * 5 * std::atof(cold) * 1e-6);
    }
}

}  // namespace
}  // namespace nacre::test
