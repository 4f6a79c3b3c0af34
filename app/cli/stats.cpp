#include "app/cli/stats.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "app/files/json_text.h"
#include "engine/frame/geometry.h"
#include "engine/scene/build/mesh_streams.h"
#include "engine/scene/color/palettes.h"

namespace nacre::app {
namespace {

using Json = nlohmann::ordered_json;

/// By rows; GLM stores columns.
Json toRows(const glm::dmat3& matrix) {
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row) rows.push_back({matrix[0][row], matrix[1][row], matrix[2][row]});
    return rows;
}

Json legendJson(const std::vector<Legend>& legends) {
    Json list = Json::array();
    for (const Legend& legend : legends) {
        Json entries = Json::array();
        for (const LegendEntry& entry : legend.entries)
            entries.push_back({{"label", entry.label}, {"color", colorText(entry.color)}});
        list.push_back({{"selection", legend.selection}, {"scheme", legend.scheme}, {"entries", entries}});
    }
    return list;
}

}  // namespace

std::int64_t peakResidentBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
    return usage.ru_maxrss;
#else
    return std::int64_t{usage.ru_maxrss} * 1024;  // Linux counts in KiB
#endif
}

Json meshLevelsJson(const std::vector<MeshLevelCount>& levels) {
    Json list = Json::array();
    for (const MeshLevelCount& level : levels)
        // Avoids the spurious digits of a float as a double.
        list.push_back(
            {{"error", std::round(level.error * 1e4) / 1e4}, {"triangles", level.triangles}, {"drawn", level.drawn}});
    return list;
}

Json copyLevelsJson(const std::vector<CopyLevelCount>& levels) {
    Json list = Json::array();
    for (const CopyLevelCount& level : levels)
        list.push_back(
            {{"error", std::round(level.error * 1e4) / 1e4}, {"copies", level.copies}, {"spheres", level.spheres}});
    return list;
}

Json choiceJson(const std::vector<Decision>& decisions) {
    Json json = {{"long_lists", nullptr}, {"views", nullptr}};  // some frames lack these
    for (const Decision& decision : decisions) {
        std::string key = decision.what;
        std::ranges::replace(key, ' ', '_');
        json[key] = {{"is", decision.how}, {"why", decision.why}};
    }
    return json;
}

Json geometryJson(const std::vector<PassGeometry>& passes, bool stored) {
    Json list = Json::array();
    for (const PassGeometry& pass : passes)
        list.push_back({{"name", pass.name},
                        {"vertices", pass.vertices},
                        {"triangles", pass.triangles},
                        {"varying_bytes", pass.varyingBytes}});
    const PassGeometry sum = sumGeometry(passes);
    const std::uint64_t bytes = stored ? sum.varyingBytes : 0;
    return {{"vertices", sum.vertices},
            {"triangles", sum.triangles},
            {"varying_bytes", sum.varyingBytes},
            {"memory_bytes", {{"loaded", bytes}, {"stored", bytes}}},
            {"passes", list}};
}

Json passesJson(const std::vector<PassCount>& counts, const std::vector<PassTime>& times) {
    Json passes = Json::array();
    for (const PassCount& pass : counts)
        passes.push_back({{"name", pass.name}, {"shaded_fragments", pass.shadedFragments}, {"ms", nullptr}});
    for (const PassTime& time : times) {
        const auto it =
            std::find_if(passes.begin(), passes.end(), [&](const Json& p) { return p["name"] == time.name; });
        if (it != passes.end())
            (*it)["ms"] = time.milliseconds;
        else
            passes.push_back({{"name", time.name}, {"shaded_fragments", nullptr}, {"ms", time.milliseconds}});
    }
    return passes;
}

namespace {

/// The driver's feedback on the frame; empty lists if there is none.
Json driverJson(const DriverFeedback& driver) {
    Json merges = Json::array(), transients = Json::array();
    for (const MergedSubpasses& m : driver.merges)
        merges.push_back(
            {{"name", m.name}, {"planned_subpasses", m.planned}, {"carried_out", m.carried}, {"why", m.why}});
    for (const TransientImage& image : driver.transients)
        transients.push_back({{"name", image.name}, {"bytes", image.bytes}, {"committed", image.committedBytes}});
    return {{"merges", merges}, {"transient_images", transients}};
}

Json stereoJson(const Stereo& stereo) {
    if (!stereo.on()) return {};
    return {{"mode", Stereo::kNames[static_cast<std::size_t>(stereo.mode)]},
            {"eye_distance", *stereo.eyeDistance},
            {"screen_distance", *stereo.screenDistance}};
}

}  // namespace

std::string statsJson(const RunStats& run, const View& view, const FrameStats& frame) {
    const glm::dquat q = glm::normalize(glm::quat_cast(view.rotation));
    Json json;
    json["view"] = {{"width", view.width},
                    {"height", view.height},
                    {"projection", view.projection == Projection::orthographic ? "ortho" : "perspective"},
                    {"center", {run.center.x, run.center.y, run.center.z}},
                    {"radius", view.radius},
                    {"pixels_per_angstrom", view.pixelsPerAngstrom},
                    {"eye_distance", view.eyeDistance},
                    {"rotation", toRows(view.rotation)},
                    {"orientation", {q.w, q.x, q.y, q.z}},
                    {"zoom", run.zoom},
                    {"clip", run.clip},
                    {"pan", {view.pan.x, view.pan.y}},
                    {"stereo", stereoJson(run.stereo)},
                    {"uncover", run.uncovers.empty() ? Json() : Json(run.uncovers)}};
    const Uncovered& u = run.uncovered;
    json["uncovered"] = run.uncovers.empty() ? Json()
                                             : Json{{"seen_before", u.before},
                                                    {"seen", u.after},
                                                    {"spheres_left_out", u.spheres},
                                                    {"cylinders_left_out", u.cylinders},
                                                    {"triangles_left_out", u.triangles}};
    json["atoms"] = {{"read", run.atomsRead},
                     {"drawn", run.atomsDrawn},
                     {"submitted", frame.spheres},
                     {"copies", frame.copies},
                     {"levels", copyLevelsJson(frame.copyLevels)}};
    json["bonds"] = {{"known", run.bondsKnown}, {"drawn", run.bondsDrawn}, {"cylinders", frame.cylinders}};
    json["mesh"] = {{"triangles", run.triangles},
                    {"vertices", run.vertices},
                    {"bytes", run.triangles * sizeof(Triangle) + run.vertices * sizeof(MeshVertex)},
                    {"submitted", frame.triangles},
                    {"levels", meshLevelsJson(frame.meshLevels)}};
    json["legend"] = legendJson(run.legends);
    json["warnings"] = run.warnings;
    json["times"] = {{"load", run.loadMs},
                     {"scene", run.sceneMs},
                     {"bake", frame.bakeMilliseconds},
                     {"bounce", frame.bounceMilliseconds},
                     {"first_picture", run.firstPictureMs},
                     {"frame", frame.frameMilliseconds},
                     {"total", run.totalMs}};
    json["covered_pixels"] = frame.coveredPixels;
    json["antialiasing"] = {{"samples", frame.samples}, {"frames", frame.frames}};
    json["parts"] = run.parts;
    json["passes"] = passesJson(frame.passes, frame.passTimes);
    const OcclusionStats& occlusion = frame.occlusion;
    json["occlusion"] = {{"directions", occlusion.directions},
                         {"cached", occlusion.cached},
                         {"patch_texels", occlusion.patchTexels},
                         {"texels", occlusion.texels},
                         {"maps", occlusion.maps},
                         {"map_pixels", occlusion.mapPixels},
                         {"maps_per_batch", occlusion.mapsPerBatch},
                         {"bytes", occlusion.bytes},
                         {"never_seen", occlusion.neverSeen}};
    json["geometry"] = geometryJson(frame.geometry, frame.storesVaryings);
    json["tile_bytes_per_pixel"] = frame.tileBytesPerPixel;
    json["memory"] = {{"resident_peak", peakResidentBytes()},
                      {"device", frame.deviceBytes},
                      {"loaded", frame.loadedBytes},
                      {"stored", frame.storedBytes}};
    json["driver_feedback"] = driverJson(run.driver);
    json["choice"] = choiceJson(run.choice);
    json["device"] = {{"name", frame.device.name},
                      {"driver", frame.device.driver},
                      {"api_version", frame.device.apiVersion},
                      {"visibility", frame.device.visibility},
                      {"why", frame.device.why},
                      {"encoded_format", frame.device.encodedFormat}};
    return jsonText(json);
}

}  // namespace nacre::app
