#include "engine/self_test.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "engine/error.h"
#include "engine/frame/choose.h"
#include "engine/renderer.h"
#include "engine/self_test/kept_results.h"
#include "engine/self_test/scenes.h"

namespace nacre {
namespace {

/// The last one is a path of every device.
constexpr Visibility kPaths[] = {Visibility::encoded, Visibility::fragdepth, Visibility::rasterOrder, Visibility::tiles,
                                 Visibility::deferred};
constexpr const char* kOutcomes[] = {"right", "wrong", "failed", "unfinished"};
constexpr const char* kHeading = "nacre self-test 7";
constexpr std::uint32_t kPixels = 128, kTimedPixels = 720;
constexpr int kDirections = 48;  // of a bake: three batches; after the second, texels without light are dropped

std::string entryName(const std::string& key) { return kTestedPaths + key; }

/// "1.2 2.05 6.3"
std::string formatTimes(const PathResult& r, int digits) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits);
    for (const double& milliseconds : r.milliseconds)
        text << (&milliseconds == r.milliseconds.data() ? "" : " ") << milliseconds;
    return text.str();
}

std::string formatTest(const SelfTest& test) {
    std::ostringstream text;
    text << kHeading << '\n';
    for (const PathResult& r : test)
        text << visibilityName(r.visibility) << ' ' << kOutcomes[static_cast<int>(r.outcome)] << ' '
             << formatTimes(r, 6) << ' ' << r.tries << ' ' << r.subpasses << ' ' << r.carried << ' ' << r.transientBytes
             << ' ' << r.committedBytes << '\n';
    return text.str();
}

/// Empty for anything but the output of formatTest().
SelfTest read(const std::string& folder, const std::string& key) {
    const std::optional<std::string> text = keptResults(folder).read(entryName(key));
    if (!text) return {};
    std::istringstream lines(*text);
    std::string line, path, outcome;
    if (!std::getline(lines, line) || line != kHeading) return {};
    SelfTest test;
    for (PathResult r; std::getline(lines, line); test.push_back(r)) {
        std::istringstream words(line);
        words >> path >> outcome;
        for (double& milliseconds : r.milliseconds) words >> milliseconds;
        if (!(words >> r.tries >> r.subpasses >> r.carried >> r.transientBytes >> r.committedBytes)) return {};
        const auto visibility = std::ranges::find_if(kPaths, [&](Visibility v) { return path == visibilityName(v); });
        const auto found = std::find(std::begin(kOutcomes), std::end(kOutcomes), outcome);
        if (visibility == std::end(kPaths) || found == std::end(kOutcomes)) return {};
        r.visibility = *visibility;
        r.outcome = static_cast<PathResult::Outcome>(found - std::begin(kOutcomes));
    }
    return test;
}

void write(const std::string& folder, const std::string& key, const SelfTest& test) {
    const std::string text = formatTest(test);
    const std::string_view parts[] = {text};
    keptResults(folder).write(entryName(key), parts);
}

struct Stopped {};

/// Ends the test on request.
void check(const std::atomic<bool>* stop) {
    if (stop && *stop) throw Stopped();
}

/// Milliseconds of a frame, by the device's own clock if it has one.
double measureFrame(Renderer& renderer, const RenderSettings& settings) {
    const double waited = renderer.drawFrame(settings);
    double sum = 0;
    for (const PassTime& pass : renderer.stats().passTimes) sum += pass.milliseconds;
    return sum > 0 ? sum : waited;
}

/// Minimum time of several frames after a warm-up, in which pipelines are compiled and the device raises its frequency.
double timed(Renderer& renderer, const TimedScene& scene, const std::atomic<bool>* stop) {
    constexpr double kWarmUp = 60, kMeasured = 60;  // ms
    constexpr int kLeastFrames = 2;
    renderer.setScene(scene.representation);
    RenderSettings s = testSettings(scene.representation, scene.projection, std::min(kTimedPixels, renderer.maxSize()));
    s.lighting = true;
    s.tuning.timePasses = true;
    for (double spent = 0; spent < kWarmUp; spent += measureFrame(renderer, s)) check(stop);
    double least = 1e9, spent = 0;
    for (int frame = 0; frame < kLeastFrames || spent < kMeasured; ++frame) {
        check(stop);
        const double milliseconds = measureFrame(renderer, s);
        least = std::min(least, milliseconds);
        spent += milliseconds;
    }
    return least;
}

/// Whether a renderer draws the scene correctly. @param edges  also with samples at edges
bool draws(Renderer& renderer, const TestScene& scene, bool edges) {
    const Representation& r = scene.representation;
    renderer.setScene(r);
    RenderSettings s = testSettings(r, scene.projection, kPixels);
    if (!shows(renderer.render(s), r, s.view)) return false;
    if (edges) {
        s.supersample = RenderSettings::kEdges;
        if (!shows(renderer.render(s), r, s.view)) return false;
        s.supersample = 1;
    }
    if (scene.shows != TestScene::Shows::occlusion) return true;
    s.occlusion.directions = kDirections;
    return showsOcclusion(renderer.render(s), r, s.view, kDirections);
}

/// The driver's feedback on the path's frames.
void addFeedback(PathResult& result, const DriverFeedback& driver) {
    for (const MergedSubpasses& m : driver.merges)
        if (m.name.starts_with("opaque prepass")) {
            result.subpasses = static_cast<int>(m.planned);
            result.carried = static_cast<int>(m.carried);
        }
    for (const TransientImage& image : driver.transients) {
        result.transientBytes += image.bytes;
        result.committedBytes += image.committedBytes;
    }
}

PathResult tested(const DeviceOptions& options, Visibility path, const std::atomic<bool>* stop) {
    PathResult result{path, PathResult::Outcome::failed};
    try {
        DeviceOptions alone = options;
        alone.visibility = path;
        alone.surface = {};
        alone.selfTests.clear();
        Renderer renderer(alone);
        result.outcome = PathResult::Outcome::right;
        for (const TestScene& scene : selfTestScenes()) {
            check(stop);
            // Compute draws edges in passes of its own.
            if (!draws(renderer, scene, drawsByCompute(path))) result.outcome = PathResult::Outcome::wrong;
        }
        if (result.outcome == PathResult::Outcome::right) {
            const std::vector<TimedScene> scenes = timedScenes();
            for (std::size_t i = 0; i < scenes.size(); ++i)
                result.milliseconds.at(i) = timed(renderer, scenes[i], stop);
        }
        addFeedback(result, renderer.driverFeedback());
    } catch (const Error&) {
        check(stop);  // after a stop request, calls may fail because the system stops the program's work
        result.outcome = PathResult::Outcome::failed;
    }
    return result;
}

}  // namespace

SelfTest testPaths(const DeviceOptions& options, const DeviceInfo& device, const std::atomic<bool>* stop) {
    const std::string& key = device.driverKey;
    SelfTest test = read(options.selfTests, key);
    for (const Visibility path : kPaths) {
        if (!hasPath(path, device.rasterOrder)) continue;
        auto it = std::find_if(test.begin(), test.end(), [&](const PathResult& r) { return r.visibility == path; });
        if (it == test.end()) it = test.insert(it, {path, PathResult::Outcome::unfinished});
        if (it->known()) continue;
        const SelfTest before = test;
        ++it->tries;
        write(options.selfTests, key, test);  // written first, in case the driver ends the program
        try {
            check(stop);
            *it = tested(options, path, stop);
        } catch (const Stopped&) {
            write(options.selfTests, key, before);
            return before;
        }
    }
    write(options.selfTests, key, test);
    return test;
}

bool wantsSelfTest(const DeviceOptions& options, const DeviceInfo& device) {
    return !options.selfTests.empty() && isAutomatic(options.visibility) && device.type != "software";
}

bool lacksSelfTest(const DeviceOptions& options, const DeviceInfo& device) {
    return wantsSelfTest(options, device) && !keptSelfTest(options.selfTests, device.driverKey);
}

std::optional<SelfTest> keptSelfTest(const std::string& folder, const std::string& key) {
    SelfTest test = read(folder, key);
    const Visibility last = *std::rbegin(kPaths);
    const bool whole = std::ranges::any_of(test, [&](const PathResult& r) { return r.visibility == last; });
    if (!whole || !std::all_of(test.begin(), test.end(), [](const PathResult& r) { return r.known(); })) return {};
    return test;
}

void forgetSelfTest(const std::string& folder, const std::string& key) { keptResults(folder).remove(entryName(key)); }

namespace {

/// " (3 subpasses as 1, 0 of 41 kB committed)"
std::string tellsOfTile(const PathResult& r) {
    std::string text;
    if (r.carried > 0) text = std::to_string(r.subpasses) + " subpasses as " + std::to_string(r.carried);
    if (r.transientBytes > 0)
        text += (text.empty() ? "" : ", ") + std::to_string(r.committedBytes / 1000) + " of " +
                std::to_string(r.transientBytes / 1000) + " kB committed";
    return text.empty() ? "" : " (" + text + ")";
}

}  // namespace

std::string describe(const SelfTest& test) {
    std::ostringstream text;
    for (const PathResult& r : test) {
        text << (text.tellp() > 0 ? ", " : "") << visibilityName(r.visibility) << ' ';
        if (r.outcome == PathResult::Outcome::right)
            text << formatTimes(r, 2) << " ms" << tellsOfTile(r);
        else
            text << (r.outcome == PathResult::Outcome::unfinished ? "ends the program"
                                                                  : kOutcomes[static_cast<int>(r.outcome)]);
    }
    return text.str();
}

namespace {

/// Time of a path relative to another one's, for the scene size with the largest ratio.
double slowestShare(const PathResult& path, const PathResult& other) {
    double share = 0;
    for (std::size_t i = 0; i < path.milliseconds.size(); ++i)
        share = std::max(share, path.milliseconds[i] / std::max(other.milliseconds[i], 1e-6));
    return share;
}

}  // namespace

graph::TestedPath choosePath(const SelfTest& test, Visibility byCaps, const std::string& whyByCaps) {
    std::vector<const PathResult*> candidates;
    const PathResult* chosen = nullptr;
    bool tilesFail = false;
    for (const PathResult& r : test) {
        tilesFail = tilesFail || (drawsByCompute(r.visibility) && r.outcome != PathResult::Outcome::right);
        if (r.outcome != PathResult::Outcome::right) continue;
        if (r.visibility == byCaps) chosen = &r;
        candidates.push_back(&r);
    }
    if (candidates.empty()) return {Visibility::automatic, "no path draws right: " + describe(test), tilesFail};
    const PathResult& base = chosen ? *chosen : *candidates.front();
    const PathResult* fastest =
        *std::ranges::min_element(candidates, {}, [&](const PathResult* r) { return slowestShare(*r, base); });
    // Frequencies of phones' GPUs differ by a tenth to a seventh between steps (Adreno 650: 305 to 587 MHz in six,
    // Mali-G610 of RK3588: 300 to 1000 MHz in eight). One step between two tests makes a path look 1.2 times as fast.
    constexpr double kFasterByItself = 0.8;
    if (chosen && slowestShare(*fastest, *chosen) >= kFasterByItself) return {byCaps, whyByCaps, tilesFail};
    const std::string what =
        chosen ? "the fastest here: " : std::string(visibilityName(byCaps)) + " draws wrongly here: ";
    return {fastest->visibility, what + describe(test), tilesFail};
}

void addSelfTest(DeviceInfo& device, const std::string& folder) {
    const std::optional<SelfTest> kept = keptSelfTest(folder, device.driverKey);
    if (!kept) return;
    device.selfTest = describe(*kept);
    for (const Visibility path : kPaths)
        if (device.visibility == visibilityName(path)) {
            const graph::TestedPath taken = choosePath(*kept, path, device.why);
            const bool none = isAutomatic(taken.visibility);
            device.visibility = none ? "none" : visibilityName(taken.visibility);
            device.why = taken.why;
            return;
        }
}

}  // namespace nacre
