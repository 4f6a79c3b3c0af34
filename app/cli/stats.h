#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/drawing/run_stats.h"
#include "engine/results.h"
#include "engine/scene/camera.h"

namespace nacre::app {

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
