#include <iomanip>
#include <optional>
#include <ostream>

#include "app/cli/bench_frames.h"
#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/cli/stats.h"
#include "app/drawing/drawing.h"
#include "app/files/json_text.h"
#include "app/files/messages.h"
#include "engine/error.h"
#include "engine/milliseconds.h"

namespace nacre::app {
namespace {

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
