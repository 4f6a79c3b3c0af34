#include <algorithm>
#include <iomanip>
#include <memory>
#include <ostream>
#include <unordered_set>
#include <vector>

#include "app/cli/bench_occlusion.h"
#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/download/load_molecule.h"
#include "app/shared/json_text.h"
#include "app/shared/molecules.h"
#include "engine/device_plan.h"
#include "engine/error.h"
#include "engine/renderer.h"

namespace nacre::app {
namespace {

constexpr Visibility kTimedPaths[] = {Visibility::encoded, Visibility::fragdepth, Visibility::deferred,
                                      Visibility::rasterOrder, Visibility::tiles};
// Milliseconds of a part after which no further round of it begins.
constexpr double kPartMilliseconds = 5'000;

struct Variant {
    const char* plates;
    PlateShape plateShape;
    const char* impostor;
    ImpostorShape impostorShape;
};
constexpr Variant kVariants[] = {{"off", PlateShape::none, "octagon", ImpostorShape::octagon},
                                 {"square", PlateShape::square, "octagon", ImpostorShape::octagon},
                                 {"octagon", PlateShape::octagon, "octagon", ImpostorShape::octagon},
                                 {"dome of 2", PlateShape::dome2, "octagon", ImpostorShape::octagon},
                                 {"dome of 3", PlateShape::dome3, "octagon", ImpostorShape::octagon},
                                 {"octagon", PlateShape::octagon, "pyramid", ImpostorShape::pyramid},
                                 {"dome of 2", PlateShape::dome2, "pyramid", ImpostorShape::pyramid},
                                 {"dome of 3", PlateShape::dome3, "pyramid", ImpostorShape::pyramid},
                                 {"off", PlateShape::none, "square", ImpostorShape::square},
                                 {"square", PlateShape::square, "square", ImpostorShape::square},
                                 {"octagon", PlateShape::octagon, "square", ImpostorShape::square}};

/// The settings of one frame of a turn about the vertical axis.
RenderSettings frameSettings(const BenchOptions& options, double radius, int frame) {
    Camera camera = options.camera;
    camera.rotationDegrees.y += 5.0 * frame;
    RenderSettings settings;
    settings.view = viewOf(camera, radius, options.size.width, options.size.height);
    settings.occlusion.directions = options.occlusion.directions;
    settings.occlusion.bytes = options.occlusion.bytes();
    return settings;
}

/// A path that is timed.
struct Timed {
    Visibility path;
    std::unique_ptr<Renderer> renderer;
    std::vector<double> samples;
};

/// Renderers that show the scene by the paths that were asked for, baked and drawn once. A path that the device lacks
/// is told in `lacks`, unless it is the one that was asked for.
std::vector<Timed> timedPaths(const BenchOptions& options, const Representation& scene, Json& lacks) {
    std::vector<Timed> timed;
    const bool all = options.device.visibility == Visibility::automatic;
    for (const Visibility path : kTimedPaths) {
        if (!all && path != options.device.visibility) continue;
        DeviceOptions device = options.device;
        device.visibility = path;
        try {
            timed.push_back({path, std::make_unique<Renderer>(device), {}});
        } catch (const Error& error) {
            if (!all) throw;
            lacks.push_back({{"visibility", visibilityName(path)}, {"why", error.what()}});
            continue;
        }
        timed.back().renderer->setScene(scene);
        timed.back().renderer->render(frameSettings(options, scene.radius, 0));
    }
    return timed;
}

/// Times whole frames, from declaring the graph to the device being done; every path in turn within a round, so that
/// the machine's moods meet all of them.
void timeFrames(const BenchOptions& options, double radius, std::vector<Timed>& timed, Progress& progress) {
    double spent = 0;
    for (int frame = -3; frame < options.frames && (frame < 3 || spent < kPartMilliseconds); ++frame) {
        progress.advance(std::max({frame / static_cast<double>(options.frames), spent / kPartMilliseconds, 0.0}));
        for (Timed& t : timed) {
            const double ms = t.renderer->drawFrame(frameSettings(options, radius, std::max(frame, 0)));
            if (frame >= 0) t.samples.push_back(ms);
            spent += ms;
        }
    }
}

/// What the device takes for each pass of the first frame, by its own clock: of some frames more, since the stamps cost
/// time themselves. None where the device has no clock.
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

Json pathsJson(const BenchOptions& options, double radius, const std::vector<Timed>& timed) {
    Json paths = Json::array();
    for (const Timed& t : timed) {
        const Json passes = passTimesJson(frameSettings(options, radius, 0), *t.renderer);
        const FrameStats& stats = t.renderer->stats();
        paths.push_back({{"visibility", visibilityName(t.path)},
                         {"frame", timesJson(t.samples)},
                         {"frames", t.samples.size()},
                         {"bake", stats.bakeMilliseconds},
                         {"tile_bytes_per_pixel", stats.tileBytesPerPixel},
                         {"memory_bytes", {{"loaded", stats.loadedBytes}, {"stored", stats.storedBytes}}},
                         {"passes", passes}});
    }
    return paths;
}

/// The scene with only what belongs to atoms that own a pixel.
Representation visiblePart(const Representation& scene, const std::vector<std::uint32_t>& ids) {
    const std::unordered_set<std::uint32_t> seen(ids.begin(), ids.end());
    Representation part = scene;
    part.spheres.clear(), part.sphereLooks.clear(), part.cylinders.clear(), part.cylinderLooks.clear();
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        if (seen.contains(scene.sphereLooks[i].atom))
            part.spheres.push_back(scene.spheres[i]), part.sphereLooks.push_back(scene.sphereLooks[i]);
    for (std::size_t i = 0; i < scene.cylinders.size(); ++i)
        if (seen.contains(scene.cylinderLooks[i].atomA) || seen.contains(scene.cylinderLooks[i].atomB))
            part.cylinders.push_back(scene.cylinders[i]), part.cylinderLooks.push_back(scene.cylinderLooks[i]);
    std::erase_if(part.triangles, [&](const Triangle& t) {
        const auto isSeen = [&](std::uint32_t v) {
            return seen.contains(scene.meshLooks[scene.meshVertices[v].look].atom);
        };
        return !isSeen(t.a) && !isSeen(t.b) && !isSeen(t.c);
    });
    return part;
}

/// What the first frame shows, and its floor: the same frame of only the atoms that own a pixel in it, in turns with
/// the whole one. Copies of an assembly share their atoms, and have no floor.
void tellOfFirstFrame(const BenchOptions& options, const Representation& scene, const Timed& timed, Json& report) {
    const RenderSettings settings = frameSettings(options, scene.radius, 0);
    const std::vector<std::uint32_t> ids = timed.renderer->layers(settings).id;
    const FrameStats stats = timed.renderer->stats();
    std::unordered_set<std::uint32_t> visible(ids.begin(), ids.end());
    visible.erase(0);
    report["covered_pixels"] = stats.coveredPixels;
    report["spheres"] = {{"submitted", stats.spheres}};
    report["cylinders"] = {{"submitted", stats.cylinders}};
    report["triangles"] = {{"submitted", stats.triangles}};
    if (!scene.copies.transforms.empty() || visible.empty()) return;
    report["atoms"]["visible"] = visible.size();
    DeviceOptions device = options.device;
    device.visibility = timed.path;
    Renderer least(device);
    least.setScene(visiblePart(scene, ids));
    least.render(settings);
    std::vector<double> whole, floor;
    double spent = 0;
    for (int frame = -2; frame < options.frames && (frame < 3 || spent < kPartMilliseconds / 2); ++frame) {
        const double a = timed.renderer->drawFrame(settings), b = least.drawFrame(settings);
        if (frame >= 0) whole.push_back(a), floor.push_back(b);
        spent += a + b;
    }
    report["floor"] = {
        {"frame", timesJson(floor)},
        {"ratio", *std::min_element(whole.begin(), whole.end()) / *std::min_element(floor.begin(), floor.end())}};
}

/// Shaded fragments of each pass of the encoded path, and its frame times, for every shape of plates and impostors.
Json compareShapes(const BenchOptions& options, const Representation& scene, Renderer& encoded) {
    Json rows = Json::array();
    for (const Variant& variant : kVariants) {
        RenderSettings settings = frameSettings(options, scene.radius, 0);
        settings.tuning.plates = variant.plateShape;
        settings.tuning.impostor = variant.impostorShape;
        settings.tuning.countFragments = true;
        encoded.render(settings);
        const FrameStats stats = encoded.stats();
        Json passes = Json::array();
        for (const PassCount& pass : stats.passes)
            passes.push_back({{"name", pass.name}, {"shaded_fragments", pass.shadedFragments}});
        rows.push_back({{"plates", variant.plates},
                        {"impostor", variant.impostor},
                        {"visible", stats.coveredPixels},
                        {"passes", passes}});
    }
    // In turns, so that the machine's moods meet all of them.
    std::vector<std::vector<double>> samples(std::size(kVariants));
    double spent = 0;
    for (int frame = -1; frame < options.frames && (frame < 2 || spent < kPartMilliseconds); ++frame)
        for (std::size_t i = 0; i < std::size(kVariants); ++i) {
            RenderSettings settings = frameSettings(options, scene.radius, std::max(frame, 0));
            settings.tuning.plates = kVariants[i].plateShape;
            settings.tuning.impostor = kVariants[i].impostorShape;
            const double ms = encoded.drawFrame(settings);
            if (frame >= 0) samples[i].push_back(ms);
            spent += ms;
        }
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i]["frame"] = timesJson(samples[i]);
    return rows;
}

void printPaths(const Json& report, std::ostream& out) {
    out << "\npath         frame ms min   median      p99     bake ms  tile B/px\n";
    for (const Json& path : report["paths"])
        out << std::left << std::setw(13) << path["visibility"].get<std::string>() << std::right << std::setw(12)
            << path["frame"]["min"].get<double>() << std::setw(9) << path["frame"]["median"].get<double>()
            << std::setw(9) << path["frame"]["p99"].get<double>() << std::setw(12) << path["bake"].get<double>()
            << std::setw(11) << path["tile_bytes_per_pixel"].get<std::uint32_t>() << "\n";
    for (const Json& path : report["paths"])
        for (const Json& pass : path["passes"])
            out << path["visibility"].get<std::string>() << ", " << pass["name"].get<std::string>() << ": "
                << pass["ms"]["median"].get<double>() << " ms on the device\n";
    for (const Json& path : report["lacks"]) out << path["why"].get<std::string>() << "\n";
    out << report["covered_pixels"] << " pixels covered";
    if (report.contains("floor"))
        out << " by " << report["atoms"]["visible"] << " atoms; with those alone "
            << report["floor"]["frame"]["min"].get<double>() << " ms, of which the frame takes "
            << report["floor"]["ratio"].get<double>() << " times";
    out << "\n";
}

void printShapes(const Json& shapes, std::ostream& out) {
    out << "\nshaded fragments per visible pixel, encoded path\nplates      impostor  prepass  encoding  colour  cut "
           "by  frame ms min\n";
    double off = 0;
    for (const Json& row : shapes) {
        const double visible = std::max(row["visible"].get<double>(), 1.0);
        const auto shaded = [&](std::string_view name) {
            for (const Json& pass : row["passes"])
                if (pass["name"] == name) return pass["shaded_fragments"].get<double>() / visible;
            return 0.0;  // a prepass of no plates is none
        };
        const double prepass = shaded("opaque prepass"), encoding = shaded("depth encoding"),
                     color = shaded("impostor colour"), costly = encoding + color;
        if (off == 0) off = costly;
        out << std::left << std::setw(12) << row["plates"].get<std::string>() << std::setw(8)
            << row["impostor"].get<std::string>() << std::right << std::setw(7) << prepass << std::setw(10) << encoding
            << std::setw(8) << color << std::setw(8) << off / costly << std::setw(14)
            << row["frame"]["min"].get<double>() << "\n";
    }
}

void printTable(const Json& report, std::ostream& out) {
    out << report["input"].get<std::string>() << ": " << report["atoms"]["drawn"] << " atoms, " << report["size"][0]
        << "x" << report["size"][1] << ", " << report["device"]["name"].get<std::string>() << "\n"
        << std::fixed << std::setprecision(2);
    if (report.contains("paths")) printPaths(report, out);
    if (report.contains("shapes")) printShapes(report["shapes"], out);
    if (report.contains("occlusion")) printOcclusion(report["occlusion"], out);
}

void addFrames(const BenchOptions& options, const Representation& scene, Json& report, Progress& progress) {
    progress.begin("baking and drawing first frames");
    Json lacks = Json::array();
    std::vector<Timed> timed = timedPaths(options, scene, lacks);
    progress.begin("timing frames");
    timeFrames(options, scene.radius, timed, progress);
    report["paths"] = pathsJson(options, scene.radius, timed);
    report["lacks"] = lacks;
    // The path that a user gets.
    const Visibility used = options.device.visibility == Visibility::automatic ? planOf(options.device).visibility
                                                                               : options.device.visibility;
    const auto it = std::find_if(timed.begin(), timed.end(), [&](const Timed& t) { return t.path == used; });
    report["device"]["visibility"] = visibilityName(used);
    report["times"] = {{"frame", timesJson(it->samples)}, {"bake", it->renderer->stats().bakeMilliseconds}};
    progress.begin("timing the floor");
    tellOfFirstFrame(options, scene, *it, report);
}

}  // namespace

void benchCommand(const BenchOptions& options, std::ostream& out) {
    using Part = BenchOptions::Part;
    Progress progress;
    progress.begin("reading");
    const Molecule molecule = loadMolecule(options.input, downloadProgress(progress));
    const Representation scene = sceneOf(molecule, options.input.path, options.drawn, options.look);
    Json report{{"input", options.input.path},
                {"atoms", {{"read", molecule.atoms.size()}, {"drawn", scene.drawnAtoms}}},
                {"size", {options.size.width, options.size.height}}};
    const auto wants = [&](Part part) { return options.only == Part::all || options.only == part; };
    DeviceOptions encoded = options.device;
    encoded.visibility = Visibility::encoded;
    Renderer renderer(encoded);
    const DeviceInfo device = renderer.stats().device;
    report["device"] = {{"name", device.name}, {"driver", device.driver}};
    if (wants(Part::frames)) addFrames(options, scene, report, progress);
    if (wants(Part::shapes) || wants(Part::bake)) renderer.setScene(scene);
    progress.begin("comparing shapes");
    if (wants(Part::shapes)) report["shapes"] = compareShapes(options, scene, renderer);
    progress.begin("comparing bakes");
    if (wants(Part::bake)) report["occlusion"] = compareMaps(frameSettings(options, scene.radius, 0), renderer);
    if (options.json)
        out << jsonText(report);
    else
        printTable(report, out);
}

}  // namespace nacre::app
