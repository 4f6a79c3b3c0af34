// What a step of a map's level costs in a window: level_benchmark MODEL MAP [AROUND [STYLE]] opens both, as `nacre view
// MODEL --map MAP --map-around AROUND --map-style STYLE` does, turns the wheel ten times by 0.1 sigma from 1 sigma on,
// and says what a step took in processor time of all threads: the contour, the scene that is put on the device, and the
// first frame of it (640x480). level_benchmark N takes a map of N cubed nodes instead, drawn whole as a surface.
// Processor time of a software device is in the frame, and in the scene what it copies.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>

#include "app/input/map_input.h"
#include "app/picture/options.h"
#include "app/viewer/viewer.h"
#include "engine/molecule/read.h"
#include "engine/renderer.h"
#include "engine/scene/build/representation.h"

namespace {

using namespace nacre;

double processorMs() { return static_cast<double>(std::clock()) * 1e3 / CLOCKS_PER_SEC; }

/// A renderer that tells what it took.
class TimedScreen : public app::Screen {
public:
    void setScene(Representation scene) override {
        const double began = processorMs();
        renderer_.setScene(scene);
        sceneMs += processorMs() - began;
        primitives = scene.wires.size() + scene.triangles.size();
    }
    double advanceOcclusion(const RenderSettings&, const OcclusionPace&) override { return 1; }
    FrameOutcome present(const RenderSettings& settings, const WindowFrame&) override {
        const double began = processorMs();
        renderer_.drawFrame(settings);
        frameMs += processorMs() - began;
        return FrameOutcome::shown;
    }
    PixelSize windowSize() const override { return {640, 480}; }
    std::uint32_t atomAt(const RenderSettings&, double, double, double) override { return 0; }

    double sceneMs = 0, frameMs = 0;
    std::size_t primitives = 0;

private:
    Renderer renderer_{DeviceOptions{}};
};

/// Sixty blobs, as in a cryo-EM map.
void keepBlobs(const std::string& name, int nodes) {
    std::vector<float> values(static_cast<std::size_t>(nodes) * nodes * nodes);
    std::srand(1);
    const auto random = [&](double low, double high) { return low + (high - low) * std::rand() / RAND_MAX; };
    for (int blob = 0; blob < 60; ++blob) {
        const glm::dvec3 at(random(0.2, 0.8) * nodes, random(0.2, 0.8) * nodes, random(0.2, 0.8) * nodes);
        const double width = random(0.02, 0.05) * nodes;
        const int reach = static_cast<int>(4 * width);
        const auto first = glm::max(glm::ivec3(at) - reach, 0), last = glm::min(glm::ivec3(at) + reach, nodes - 1);
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x) {
                    const glm::dvec3 off = glm::dvec3(x, y, z) - at;
                    values[(static_cast<std::size_t>(z) * nodes + y) * nodes + x] +=
                        static_cast<float>(std::exp(-glm::dot(off, off) / (2 * width * width)));
                }
    }
    app::keepMap(name,
                 std::make_shared<const DensityMap>(mapOfValues(
                     name, glm::ivec3(nodes), {glm::dvec3(nodes), glm::dvec3(90)}, {}, false, std::move(values))));
}

struct Cost {
    double contour = 0, scene = 0, frame = 0;
    double step() const { return contour + scene; }
};

/// A step of the wheel, until it is seen.
Cost turn(app::Viewer& viewer, TimedScreen& screen, double& now) {
    screen.sceneMs = screen.frameMs = 0;
    const double began = processorMs();
    viewer.changeLevel(1, now += 2);
    viewer.reading().loader().wait();
    viewer.update(now += 0.02);
    return {processorMs() - began - screen.sceneMs - screen.frameMs, screen.sceneMs, screen.frameMs};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return std::fprintf(stderr, "level_benchmark MODEL MAP [AROUND [STYLE]] | N\n"), 2;
    app::PictureDescription view;
    const int nodes = std::atoi(argv[1]);
    std::string map = argc > 2 ? argv[2] : "blobs";
    if (nodes > 0) keepBlobs(map, nodes);
    view.input.path = nodes > 0 ? "sample:glucose" : argv[1];
    const auto set = [&](const char* key, const std::string& value) { setOption(app::option(key), value, view); };
    set("map", map);
    set("map-level", "1sigma");
    if (nodes > 0) set("map-style", "surface");
    if (argc > 3) set("map-around", argv[3]);
    if (argc > 4) set("map-style", argv[4]);
    TimedScreen screen;
    const app::Sources sources{[](const app::PictureDescription& v) {
        return v.input.path.starts_with("sample:") ? sampleMolecule(v.input.path.substr(7))
                                                   : readMoleculeFile(v.input.path);
    }};
    app::Viewer viewer(screen, sources, view, {});
    double now = 100;
    viewer.frames().resize({640, 480}, 1, now);
    viewer.reading().loader().wait();
    viewer.update(now += 1);
    turn(viewer, screen, now);  // compiles what it needs
    constexpr int kTurns = 10;
    Cost sum, most;
    std::size_t primitives = 0;
    for (int i = 0; i < kTurns; ++i) {
        const Cost cost = turn(viewer, screen, now);
        sum = {sum.contour + cost.contour, sum.scene + cost.scene, sum.frame + cost.frame};
        if (cost.step() > most.step()) most = cost;
        primitives = std::max(primitives, screen.primitives);
    }
    std::printf(
        "%s, %zu lines or triangles at most: %.1f ms of processor time per step of the level (at most %.1f): contour "
        "%.1f, scene %.1f; its first frame %.1f\n",
        map.c_str(), primitives, sum.step() / kTurns, most.step(), sum.contour / kTurns, sum.scene / kTurns,
        sum.frame / kTurns);
}
