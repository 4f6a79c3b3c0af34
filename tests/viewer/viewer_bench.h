#pragma once
// The viewer on a screen that only counts, and a clock that a test moves.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/viewer/viewer.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"

namespace nacre::app::test {

class CountingScreen : public Screen {
public:
    std::vector<WindowFrame> frames;
    std::vector<RenderSettings> settings;
    int scenes = 0;
    double occlusion = 0;
    std::uint32_t atom = 0;
    FrameOutcome outcome = FrameOutcome::shown;
    double milliseconds = 0, millisecondsOfWhole = 0;  ///< of a frame; of one at full resolution
    int awaited = 0;

    int failures = 0;  ///< of the calls that follow
    std::string loss;

    void mayFail() {
        if (!loss.empty()) throw Error("the device was lost", "", "");
        if (failures == 0) return;
        --failures;
        throw Error("out of memory", "the screen", "it was too much");
    }
    void setScene(Representation) override {
        mayFail();
        ++scenes;
        occlusion = 0;
    }
    std::vector<OcclusionPace> paces;
    double advanceOcclusion(const RenderSettings&, const OcclusionPace& pace) override {
        mayFail();
        paces.push_back(pace);
        return occlusion = std::min(occlusion + 0.125, 1.0);
    }
    std::string deviceLoss() const override { return loss; }
    FrameOutcome present(const RenderSettings& s, const WindowFrame& frame) override {
        mayFail();
        if (outcome == FrameOutcome::shown) frames.push_back(frame), settings.push_back(s);
        return outcome;
    }
    PixelSize windowSize() const override { return {640, 480}; }
    void awaitFrame() override { ++awaited; }
    double frameMilliseconds() const override {
        if (millisecondsOfWhole == 0 || frames.empty()) return milliseconds;
        return millisecondsOfWhole * frames.back().scale * frames.back().scale;
    }
    std::uint32_t atomAt(const RenderSettings&, double, double, double) override {
        mayFail();
        return atom;
    }
    int count(WindowFrame::Quality quality) const {
        return static_cast<int>(
            std::count_if(frames.begin(), frames.end(), [&](const WindowFrame& f) { return f.quality == quality; }));
    }
};

inline Sources sampleSources() {
    return {[](const PictureDescription& v) {
        if (v.input.path == "bad") throw Error("cannot read molecule", "bad", "it is bad");
        return sampleMolecule(v.input.path.substr(7));
    }};
}

struct Bench {
    CountingScreen screen;
    Viewer viewer;
    double now = 100;

    explicit Bench(const char* input = "sample:glucose") : viewer(screen, sampleSources(), makeView(input), {}) {
        viewer.frames().resize({640, 480}, 1, now);
        load();
    }
    static PictureDescription makeView(const char* input) {
        PictureDescription v;
        v.input.path = input;
        return v;
    }
    void load() {
        viewer.reading().loader().wait();
        step();
    }
    double step(double frame = 1.0 / 60) {
        now += frame;
        return viewer.update(now);
    }
    /// As a shell does: draws as often as it is asked to, waits where it may.
    void run(double seconds, double frame = 1.0 / 60) {
        const double end = now + seconds;
        while (now < end) {
            const double wake = viewer.update(now);
            now = std::min(std::max(now + frame, std::isinf(wake) ? end : wake), end);
        }
    }
};

using Quality = WindowFrame::Quality;

}  // namespace nacre::app::test
