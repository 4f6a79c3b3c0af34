#include <algorithm>
#include <iomanip>
#include <ostream>
#include <vector>

#include "app/cli/bench_occlusion.h"
#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/download/load_molecule.h"
#include "app/shared/json_text.h"
#include "app/shared/molecules.h"
#include "engine/renderer.h"

namespace nacre::app {
namespace {

struct NamedPath {
    const char* name;
    Visibility visibility;
};
constexpr NamedPath kPaths[] = {{"encoded", Visibility::encoded},
                                {"fragdepth", Visibility::fragdepth},
                                {"deferred", Visibility::deferred},
                                {"raster-order", Visibility::rasterOrder},
                                {"tiles", Visibility::tiles}};
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
    Camera camera;
    camera.rotationDegrees = {0, 5.0 * frame, 0};
    RenderSettings settings;
    settings.view = viewOf(camera, radius, options.size.width, options.size.height);
    settings.occlusion.directions = options.occlusion.directions;
    settings.occlusion.bytes = options.occlusion.bytes();
    return settings;
}

/// Times whole frames, from declaring the graph to the device being done; every path in turn within a round, so that
/// the machine's moods meet all of them.
Json timeFrames(const BenchOptions& options, const Representation& scene, std::vector<Renderer>& renderers) {
    for (Renderer& renderer : renderers) renderer.render(frameSettings(options, scene.radius, 0));  // bakes
    std::vector<std::vector<double>> samples(renderers.size());
    for (int frame = -3; frame < options.frames; ++frame)
        for (std::size_t i = 0; i < renderers.size(); ++i) {
            const double ms = renderers[i].drawFrame(frameSettings(options, scene.radius, std::max(frame, 0)));
            if (frame >= 0) samples[i].push_back(ms);
        }
    Json paths = Json::array();
    for (std::size_t i = 0; i < renderers.size(); ++i) {
        const FrameStats& stats = renderers[i].stats();
        paths.push_back({{"visibility", kPaths[i].name},
                         {"frame", timesJson(samples[i])},
                         {"bake", stats.bakeMilliseconds},
                         {"tile_bytes_per_pixel", stats.tileBytesPerPixel},
                         {"memory_bytes", {{"loaded", stats.loadedBytes}, {"stored", stats.storedBytes}}}});
    }
    return paths;
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
    for (int frame = -1; frame < options.frames; ++frame)
        for (std::size_t i = 0; i < std::size(kVariants); ++i) {
            RenderSettings settings = frameSettings(options, scene.radius, std::max(frame, 0));
            settings.tuning.plates = kVariants[i].plateShape;
            settings.tuning.impostor = kVariants[i].impostorShape;
            const double ms = encoded.drawFrame(settings);
            if (frame >= 0) samples[i].push_back(ms);
        }
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i]["frame"] = timesJson(samples[i]);
    return rows;
}

void printTable(const Json& report, std::ostream& out) {
    out << report["input"].get<std::string>() << ": " << report["atoms"]["drawn"] << " atoms, " << report["size"][0]
        << "x" << report["size"][1] << ", " << report["device"]["name"].get<std::string>() << "\n\n"
        << std::fixed << std::setprecision(2) << "path         frame ms min   median     bake ms  tile B/px\n";
    for (const Json& path : report["paths"])
        out << std::left << std::setw(13) << path["visibility"].get<std::string>() << std::right << std::setw(12)
            << path["frame"]["min"].get<double>() << std::setw(9) << path["frame"]["median"].get<double>()
            << std::setw(13) << path["bake"].get<double>() << std::setw(11)
            << path["tile_bytes_per_pixel"].get<std::uint32_t>() << "\n";
    out << "\nshaded fragments per visible pixel, encoded path\nplates      impostor  prepass  encoding  colour  cut "
           "by  frame ms min\n";
    double off = 0;
    for (const Json& row : report["shapes"]) {
        const double visible = std::max(row["visible"].get<double>(), 1.0);
        const auto shaded = [&](std::size_t pass) {
            return row["passes"][pass]["shaded_fragments"].get<double>() / visible;
        };
        const double costly = shaded(1) + shaded(2);
        if (off == 0) off = costly;
        out << std::left << std::setw(12) << row["plates"].get<std::string>() << std::setw(8)
            << row["impostor"].get<std::string>() << std::right << std::setw(7) << shaded(0) << std::setw(10)
            << shaded(1) << std::setw(8) << shaded(2) << std::setw(8) << off / costly << std::setw(14)
            << row["frame"]["min"].get<double>() << "\n";
    }
    printOcclusion(report["occlusion"], out);
}

}  // namespace

void benchCommand(const BenchOptions& options, std::ostream& out) {
    const Molecule molecule = [&] {
        Progress progress;
        progress.begin("reading");
        return loadMolecule(options.input, downloadProgress(progress));
    }();
    const Representation scene = sceneOf(molecule, options.input.path, options.drawn, options.look);
    std::vector<Renderer> renderers;
    for (const NamedPath& path : kPaths) {
        DeviceOptions device = options.device;
        device.visibility = path.visibility;
        renderers.emplace_back(device);
        renderers.back().setScene(scene);
    }
    const DeviceInfo device = renderers.front().stats().device;
    Json report{{"input", options.input.path},
                {"atoms", {{"read", molecule.atoms.size()}, {"drawn", scene.drawnAtoms}}},
                {"size", {options.size.width, options.size.height}},
                {"frames", options.frames},
                {"device", {{"name", device.name}, {"driver", device.driver}}}};
    report["paths"] = timeFrames(options, scene, renderers);
    report["shapes"] = compareShapes(options, scene, renderers.front());
    report["occlusion"] = compareMaps(frameSettings(options, scene.radius, 0), renderers.front());
    if (options.json)
        out << jsonText(report);
    else
        printTable(report, out);
}

}  // namespace nacre::app
