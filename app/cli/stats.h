#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/cli/options.h"
#include "engine/results.h"
#include "engine/scene/camera.h"
#include "engine/scene/uncover.h"

namespace nacre::app {

/// What `render --stats` says beside what the renderer measured.
struct RunStats {
    std::size_t atomsRead = 0, bondsKnown = 0;
    std::size_t atomsDrawn = 0, bondsDrawn = 0;
    std::size_t triangles = 0, vertices = 0;  ///< of cartoons and surfaces, stored once for all copies
    glm::dvec3 center{};                      ///< of the view, Å
    double zoom = 1;                          ///< of the view
    std::string clip;                         ///< as --clip takes it
    std::string uncovers;                     ///< the selection that is to be seen whole; empty: none
    Uncovered uncovered;
    std::vector<Legend> legends;
    std::vector<std::string> warnings;  ///< of the file and of the rules
    double loadMs = 0;                  ///< reading, inflating, bonds
    double sceneMs = 0;                 ///< choosing atoms, building the streams
    double firstPictureMs = 0;          ///< from the command's start to the first picture in memory
    DriverFeedback driver;              ///< after the picture
    std::uint64_t parts = 1;            ///< that the picture was drawn in
    double totalMs = 0;                 ///< from the command's start until only this file is left to write
};

/// A frame's passes. Counted ones have `shaded_fragments`. `ms` is what the device took: of a pass that is alone in its
/// render pass in its own entry; passes that share one have an entry of their own beside theirs, by their names joined.
/// What has `ms` adds up to the frame.
nlohmann::ordered_json passesJson(const std::vector<PassCount>& counts, const std::vector<PassTime>& times);

/// What the passes hand from vertices to fragments: `varying_bytes`, which go to memory and back (`memory_bytes`) where
/// a GPU stores them.
nlohmann::ordered_json meshLevelsJson(const std::vector<MeshLevelCount>& levels);
nlohmann::ordered_json geometryJson(const std::vector<PassGeometry>& passes, bool stored);

/// The most memory that this program has had resident so far.
std::int64_t peakResidentBytes();

/// JSON text; the keys are stable: snake_case, times in milliseconds, bytes as whole numbers.
std::string statsJson(const RunStats& run, const View& view, const FrameStats& frame);

}  // namespace nacre::app
