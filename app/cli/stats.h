#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/drawing/run_stats.h"
#include "engine/results.h"
#include "engine/scene/view/camera.h"

namespace nacre::app {

/// A frame's passes. Counted ones have `shaded_fragments`. `ms` is device time. A pass alone in its render pass has it
/// in its own entry; passes that share one have an extra entry under their joined names. All `ms` add up to the
/// frame's.
nlohmann::ordered_json passesJson(const std::vector<PassCount>& counts, const std::vector<PassTime>& times);

nlohmann::ordered_json copyLevelsJson(const std::vector<CopyLevelCount>& levels);
nlohmann::ordered_json meshLevelsJson(const std::vector<MeshLevelCount>& levels);
/// Each decision on a frame by its name: `is` and `why`.
nlohmann::ordered_json choiceJson(const std::vector<Decision>& decisions);
/// Vertex output of the passes: `varying_bytes`, which go through memory (`memory_bytes`) on GPUs that store them.
nlohmann::ordered_json geometryJson(const std::vector<PassGeometry>& passes, bool stored);

/// Peak resident memory of this program so far.
std::int64_t peakResidentBytes();

/// JSON text; the keys are stable: snake_case, times in milliseconds, bytes as whole numbers.
std::string statsJson(const RunStats& run, const View& view, const FrameStats& frame);

}  // namespace nacre::app
