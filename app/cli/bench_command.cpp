// `nacre bench`: times of frames by path, and submitted geometry and lower bound of the default path.

#include <algorithm>
#include <ctime>
#include <iomanip>
#include <iterator>
#include <memory>
#include <optional>
#include <ostream>
#include <unordered_set>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "app/cli/stats.h"
#include "app/drawing/drawing.h"
#include "app/drawing/stereo.h"
#include "app/files/json_text.h"
#include "app/files/messages.h"
#include "engine/devices.h"
#include "engine/error.h"
#include "engine/milliseconds.h"
#include "engine/renderer.h"
#include "engine/scene/build/representation.h"

namespace nacre::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr Visibility kTimedPaths[] = {Visibility::encoded, Visibility::fragdepth, Visibility::deferred,
                                      Visibility::rasterOrder, Visibility::tiles};

/// Decides the number of rounds: as requested, or 20 limited by time.
class BenchRounds {
public:
    explicit BenchRounds(const BenchOptions& options) : options_(options) {}
    /// @param round  from 0; earlier ones are warm-up
    bool goesOn(int round) const {
        if (options_.frames) return round < *options_.frames;
        return round < kRounds && (round < kLeast || spent_ < kMilliseconds);
    }
    void spend(double milliseconds) { spent_ += milliseconds; }
    double share(int round) const {
        const double done = std::max(round, 0) / static_cast<double>(options_.frames.value_or(kRounds));
        return options_.frames ? done : std::max(done, spent_ / kMilliseconds);
    }

private:
    static constexpr int kRounds = 20, kLeast = 3;
    static constexpr double kMilliseconds = 3'000;
    const BenchOptions& options_;
    double spent_ = 0;
};

/// {"min", "median", "p99"} of times; at least one.
Json timesJson(std::vector<double> samples) {
    std::sort(samples.begin(), samples.end());
    return {{"min", samples.front()},
            {"median", samples[samples.size() / 2]},
            {"p99", samples[(samples.size() * 99 + 99) / 100 - 1]}};
}

/// The settings of a frame of a turn about the vertical axis. @param radius  of the scene @param frame  from 0
RenderSettings benchFrame(const BenchOptions& options, double radius, int frame) {
    Camera camera = options.picture.camera;
    camera.rotationDegrees.y += 5.0 * frame;
    return settingsOfEyes(options.picture, camera, radius);
}

/// Times of frames, milliseconds: by the clock, and CPU time of all cores.
struct Samples {
    std::vector<double> wall, processor;
};

/// A timed path.
struct Timed {
    Visibility path;
    std::unique_ptr<Renderer> renderer;
    Samples samples;
};

/// Draws a frame, and records pass times if wanted. @returns milliseconds of wall-clock time
double timeFrame(Renderer& renderer, const RenderSettings& settings, Samples* samples) {
    const std::clock_t before = std::clock();
    const double ms = renderer.drawFrame(settings);
    if (samples) {
        samples->processor.push_back(static_cast<double>(std::clock() - before) * 1e3 / CLOCKS_PER_SEC);
        samples->wall.push_back(ms);
    }
    return ms;
}

/// Renderers that show the scene by the requested paths, baked and drawn once. `lacks` lists paths that the device
/// lacks, unless it was the only one requested.
std::vector<Timed> timedPaths(const BenchOptions& options, const Representation& scene, Json& lacks,
                              Progress& progress) {
    std::vector<Timed> timed;
    const bool all = isAutomatic(options.picture.device.visibility);
    for (const Visibility path : kTimedPaths) {
        if (!all && path != options.picture.device.visibility) continue;
        DeviceOptions device = options.picture.device;
        device.visibility = path;
        try {
            timed.push_back({path, std::make_unique<Renderer>(device), {}});
        } catch (const Error& error) {
            if (!all) throw;
            lacks.push_back({{"visibility", visibilityName(path)}, {"why", error.what()}});
            continue;
        }
        timed.back().renderer->setScene(scene);
        RenderSettings settings = benchFrame(options, scene.radius, 0);
        const double before = static_cast<double>(timed.size() - 1);
        const double paths = all ? static_cast<double>(std::size(kTimedPaths)) : 1.0;
        settings.occlusion.onProgress = [&](double share) { progress.advance((before + share) / paths); };
        timed.back().renderer->render(settings);
    }
    return timed;
}

/// Times whole frames, from declaring the graph until the device is done; alternates the paths within a round, so that
/// disturbances affect all of them.
void timeFrames(const BenchOptions& options, double radius, std::vector<Timed>& timed, Progress& progress) {
    BenchRounds rounds(options);
    for (int frame = -3; rounds.goesOn(frame); ++frame) {
        progress.advance(rounds.share(frame));
        for (Timed& t : timed)
            rounds.spend(timeFrame(*t.renderer, benchFrame(options, radius, std::max(frame, 0)),
                                   frame >= 0 ? &t.samples : nullptr));
    }
}

/// Device time per pass of the first frame, from extra frames, since timestamps cost time. None without timestamps.
Json passTimesJson(const RenderSettings& settings, Renderer& renderer) {
    constexpr int kTimedFrames = 5;
    RenderSettings timed = settings;
    timed.tuning.timePasses = true;
    std::vector<std::vector<double>> samples;
    for (int frame = 0; frame < kTimedFrames; ++frame) {
        renderer.drawFrame(timed);
        const std::vector<PassTime>& times = renderer.stats().passTimes;
        samples.resize(times.size());
        for (std::size_t i = 0; i < times.size(); ++i) samples[i].push_back(times[i].milliseconds);
    }
    Json passes = Json::array();
    for (std::size_t i = 0; i < samples.size(); ++i)
        passes.push_back({{"name", renderer.stats().passTimes[i].name}, {"ms", timesJson(samples[i])}});
    return passes;
}

Json listsJson(const TileCounts& lists) {
    return {
        {"tiles", lists.tiles}, {"kept", lists.kept}, {"entries", lists.entries}, {"longest_list", lists.longestList}};
}

Json pathsJson(const BenchOptions& options, double radius, const std::vector<Timed>& timed) {
    Json paths = Json::array();
    for (const Timed& t : timed) {
        const Json passes = passTimesJson(benchFrame(options, radius, 0), *t.renderer);
        const FrameStats& stats = t.renderer->stats();
        paths.push_back({{"visibility", visibilityName(t.path)},
                         {"frame", timesJson(t.samples.wall)},
                         {"processor", timesJson(t.samples.processor)},
                         {"frames", t.samples.wall.size()},
                         {"samples_per_pixel", stats.samples},
                         {"bake", stats.bakeMilliseconds},
                         {"geometry", geometryJson(stats.geometry, stats.storesVaryings)},
                         {"tile_bytes_per_pixel", stats.tileBytesPerPixel},
                         {"memory_bytes", {{"loaded", stats.loadedBytes}, {"stored", stats.storedBytes}}},
                         {"passes", passes},
                         {"lists", stats.lists.tiles > 0 ? listsJson(stats.lists) : Json()}});
    }
    return paths;
}

using Seen = std::unordered_set<std::uint32_t>;

/// The scene with only the primitives of atoms that are visible in a pixel.
Representation visiblePart(const Representation& scene, const Seen& seen) {
    Representation part = scene;
    part.spheres.clear(), part.sphereLooks.clear(), part.cylinders.clear(), part.cylinderLooks.clear();
    // The model of a primitive matters only for occlusion.
    part.sphereModels.clear(), part.cylinderModels.clear(), part.triangleModels.clear();
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        if (seen.contains(scene.sphereLooks[i].atom))
            part.spheres.push_back(scene.spheres[i]), part.sphereLooks.push_back(scene.sphereLooks[i]);
    for (std::size_t i = 0; i < scene.cylinders.size(); ++i)
        if (seen.contains(scene.cylinderLooks[i].atomA) || seen.contains(scene.cylinderLooks[i].atomB))
            part.cylinders.push_back(scene.cylinders[i]), part.cylinderLooks.push_back(scene.cylinderLooks[i]);
    part.triangles.clear(), part.coarseTriangles.clear();
    const auto isSeen = [&](std::uint32_t v) {
        return seen.contains(scene.meshLooks[scene.meshVertices[v].look].atom);
    };
    const auto keep = [&](const std::vector<Triangle>& from, auto& run, std::vector<Triangle>& kept) {
        const auto first = static_cast<std::uint32_t>(kept.size());
        std::copy_if(from.begin() + run.first, from.begin() + run.first + run.count, std::back_inserter(kept),
                     [&](const Triangle& t) { return isSeen(t.a) || isSeen(t.b) || isSeen(t.c); });
        run.first = first;
        run.count = static_cast<std::uint32_t>(kept.size()) - first;
    };
    for (MeshRun& mesh : part.meshes) {
        mesh.closed = false;
        keep(scene.triangles, mesh, part.triangles);
        for (MeshRun::Level& level : mesh.levels) keep(scene.coarseTriangles, level, part.coarseTriangles);
    }
    return part;
}

/// Times the first frame with only visible atoms, alternating with the full one.
Json floorJson(const BenchOptions& options, const Representation& part, const Timed& timed) {
    const RenderSettings settings = benchFrame(options, part.radius, 0);
    DeviceOptions device = options.picture.device;
    device.visibility = timed.path;
    Renderer least(device);
    least.setScene(part);
    least.render(settings);
    Samples whole, floor;
    BenchRounds rounds(options);
    for (int frame = -2; rounds.goesOn(frame); ++frame) {
        rounds.spend(timeFrame(*timed.renderer, settings, frame >= 0 ? &whole : nullptr));
        rounds.spend(timeFrame(least, settings, frame >= 0 ? &floor : nullptr));
    }
    const auto ratio = [](const std::vector<double>& a, const std::vector<double>& b) {
        return *std::min_element(a.begin(), a.end()) / *std::min_element(b.begin(), b.end());
    };
    return {{"frame", timesJson(floor.wall)},
            {"ratio", ratio(whole.wall, floor.wall)},
            {"processor_ratio", ratio(whole.processor, floor.processor)}};
}

/// Contents of the first frame, and its lower bound. Copies of an assembly share their atoms, so visible ones are
/// unknown and there is no bound.
void tellOfFirstFrame(const BenchOptions& options, const Representation& scene, const Timed& timed, Json& report) {
    const std::vector<std::uint32_t> ids = timed.renderer->layers(benchFrame(options, scene.radius, 0)).id;
    const FrameStats& stats = timed.renderer->stats();
    Seen seen(ids.begin(), ids.end());
    seen.erase(0);
    report["covered_pixels"] = stats.coveredPixels;
    report["spheres"] = {{"submitted", stats.spheres},
                         {"kept", stats.lists.entries > 0 ? Json(stats.lists.keptSpheres) : Json()},
                         {"visible", nullptr}};
    report["cylinders"] = {{"submitted", stats.cylinders}};
    report["triangles"] = {{"submitted", stats.triangles}};
    report["atoms"]["visible"] = report["floor"] = nullptr;
    if (!scene.copies.transforms.empty() || seen.empty()) return;
    report["atoms"]["visible"] = seen.size();
    const Representation part = visiblePart(scene, seen);
    report["spheres"]["visible"] = part.spheres.size();
    report["floor"] = floorJson(options, part, timed);
}

/// Times frames by the requested paths, and adds to a report `paths`, `lacks`, `times`, `floor` and counts.
/// @throws Error if the device lacks the only path requested
void addFrames(const BenchOptions& options, const Representation& scene, Json& report, Progress& progress) {
    progress.begin("baking and drawing first frames");
    Json lacks = Json::array();
    std::vector<Timed> timed = timedPaths(options, scene, lacks, progress);
    progress.begin("timing frames");
    timeFrames(options, scene.radius, timed, progress);
    report["paths"] = pathsJson(options, scene.radius, timed);
    report["lacks"] = lacks;
    // The path that users get.
    const std::string used = deviceInfo(options.picture.device).visibility;
    const auto it = std::ranges::find_if(timed, [&](const Timed& t) { return visibilityName(t.path) == used; });
    const DeviceInfo& device = it->renderer->stats().device;
    report["device"] = {{"name", device.name}, {"driver", device.driver}, {"visibility", used}};
    report["times"]["bake"] = it->renderer->stats().bakeMilliseconds;
    report["times"]["frame"] = timesJson(it->samples.wall);
    report["times"]["frame_processor"] = timesJson(it->samples.processor);
    progress.begin("timing the floor");
    tellOfFirstFrame(options, scene, *it, report);
}

/// The report as a table.
void printFrames(const Json& report, std::ostream& out) {
    const auto table = out.flags();
    out << "\npath           frame ms: min   median      p99     CPU ms  vertices  bake ms  tile B/px\n";
    for (const Json& path : report["paths"])
        out << std::left << std::setw(15) << path["visibility"].get<std::string>() << std::right << std::setw(13)
            << path["frame"]["min"].get<double>() << std::setw(9) << path["frame"]["median"].get<double>()
            << std::setw(9) << path["frame"]["p99"].get<double>() << std::setw(11)
            << path["processor"]["min"].get<double>() << std::setw(10)
            << path["geometry"]["vertices"].get<std::uint64_t>() << std::setw(9) << path["bake"].get<double>()
            << std::setw(11) << path["tile_bytes_per_pixel"].get<std::uint32_t>() << "\n";
    for (const Json& path : report["paths"]) {
        const std::string name = path["visibility"];
        for (const Json& pass : path["passes"])
            out << name << ", " << pass["name"].get<std::string>() << ": " << pass["ms"]["median"].get<double>()
                << " ms of device time\n";
        if (path["lists"].is_null()) continue;
        out << name << ": ";
        if (path["lists"]["entries"] == 0)
            out << "the host drew the primitives, ";
        else
            out << path["lists"]["kept"] << " primitives in " << path["lists"]["entries"] << " entries of lists, ";
        out << path["lists"]["tiles"] << " tiles\n";
    }
    for (const Json& path : report["lacks"]) out << path["why"].get<std::string>() << "\n";
    out << report["spheres"]["submitted"] << " spheres, " << report["cylinders"]["submitted"] << " cylinders, "
        << report["triangles"]["submitted"] << " triangles submitted; " << report["covered_pixels"]
        << " pixels covered";
    if (!report["floor"].is_null())
        out << " by " << report["atoms"]["visible"] << " atoms; a frame of these atoms takes "
            << report["floor"]["frame"]["min"].get<double>() << " ms, the whole frame "
            << report["floor"]["ratio"].get<double>() << " times as long";
    out << "\n";
    out.flags(table);
}

void printTable(const Json& report, std::ostream& out) {
    out << report["input"].get<std::string>() << ": " << report["atoms"]["drawn"] << " atoms, " << report["size"][0]
        << "x" << report["size"][1] << ", " << report["device"]["name"].get<std::string>() << "\n"
        << std::fixed << std::setprecision(2);
    printFrames(report, out);
}

Json runBench(const BenchOptions& options, const InputOptions& input) {
    Progress progress;
    const auto start = Clock::now();
    PictureDescription picture = options.picture;
    picture.input = input;
    const Molecule molecule = readMoleculeAndMaps(picture, progress);
    const double load = millisecondsSince(start);
    progress.begin("building the scene");
    Drawing drawing(CameraBy::hand);
    drawing.build(molecule, picture);
    const Representation scene = drawing.joinedScene();
    Json report{{"input", input.path},
                {"atoms", {{"read", molecule.atoms.size()}, {"drawn", scene.drawnAtoms}}},
                {"size", {options.picture.size.width, options.picture.size.height}},
                {"device", Json::object()},
                {"times", {{"load", load}, {"scene", millisecondsSince(start) - load}}}};
    addFrames(options, scene, report, progress);
    report["memory"] = {{"resident_peak", peakResidentBytes()}};
    return report;
}

}  // namespace

void benchCommand(const BenchOptions& options, std::ostream& out) {
    Json reports = Json::array();
    std::optional<Error> failure;  // the last one; earlier ones are printed at once
    for (const std::string& path : options.paths) try {
            InputOptions input = options.picture.input;
            input.path = path;
            reports.push_back(runBench(options, input));
            if (options.json) continue;
            if (reports.size() > 1) out << "\n";
            printTable(reports.back(), out);
        } catch (const Error& error) {
            if (failure) sayError(failure->what());
            failure = error;
        }
    if (options.json && !reports.empty()) out << jsonText(options.paths.size() > 1 ? reports : reports.front());
    if (failure) throw *failure;
}

}  // namespace nacre::app
