#include "app/headless/stats.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

namespace nacre::app {
namespace {

using Json = nlohmann::ordered_json;

std::int64_t peakResidentBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
    return usage.ru_maxrss;
#else
    return std::int64_t{usage.ru_maxrss} * 1024;  // Linux counts in KiB
#endif
}

const char* nameOf(Visibility visibility) {
    switch (visibility) {
        case Visibility::encoded:
            return "encoded";
        case Visibility::fragdepth:
            return "fragdepth";
        case Visibility::automatic:
            break;
    }
    return "auto";
}

/// Row by row, as it is written on paper; GLM stores columns.
Json rowsOf(const glm::dmat3& matrix) {
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row) rows.push_back({matrix[0][row], matrix[1][row], matrix[2][row]});
    return rows;
}

}  // namespace

std::string statsJson(const RunStats& run, const Representation& scene, const View& view, const FrameStats& frame) {
    Json json;
    json["view"] = {{"width", view.width},
                    {"height", view.height},
                    {"projection", view.projection == Projection::orthographic ? "ortho" : "perspective"},
                    {"center", {scene.center.x, scene.center.y, scene.center.z}},
                    {"radius", view.radius},
                    {"pixels_per_angstrom", view.pixelsPerAngstrom},
                    {"eye_distance", view.eyeDistance},
                    {"rotation", rowsOf(view.rotation)}};
    json["atoms"] = {{"read", run.atomsRead}, {"drawn", scene.drawnAtoms}, {"submitted", scene.spheres.size()}};
    json["bonds"] = {{"known", run.bondsKnown}, {"drawn", scene.drawnBonds}, {"cylinders", scene.cylinders.size()}};
    json["times"] = {{"load", run.loadMs},     {"scene", run.sceneMs},
                     {"bake", frame.bakeMs},   {"first_picture", frame.firstPictureMs},
                     {"frame", frame.frameMs}, {"total", run.totalMs}};
    json["covered_pixels"] = frame.coveredPixels;
    json["memory"] = {{"resident_peak", peakResidentBytes()}, {"device", frame.deviceMemory}};
    json["device"] = {{"name", frame.deviceName},
                      {"driver", frame.driver},
                      {"visibility", nameOf(frame.visibility)},
                      {"why", frame.visibilityWhy}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace nacre::app
