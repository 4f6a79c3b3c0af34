#pragma once
// What vendors' profilers ask of a pass, as it follows from what the pass does to its images.

#include <cstdint>

#include "engine/graph/graph.h"

namespace nacre {

/// Bytes that a pass fetches for each primitive, or, if `perPixel`, for each pixel that one covers.
struct Fetch {
    std::uint32_t sphere = 0, cylinder = 0, triangle = 0;
    bool perPixel = false;
};

/// When a pass's depth test runs.
enum class DepthTiming : std::uint8_t { none, early, conservative, late };
/// "none", "early", "conservative" or "late"
const char* depthTimingName(DepthTiming timing);

struct PassNotes {
    DepthTiming depth{};
    const char* why = "";        ///< of `depth`
    Fetch binning;               ///< positions alone, to find a primitive's tiles
    Fetch shading;               ///< what visible primitives need after that
    const char* precision = "";  ///< what may be 16 bits wide, and what must not
};

/// @param pass          of the screen frame
/// @param conservative  PlanCaps::conservativeDepth
PassNotes notesOf(const graph::PassDecl& pass, bool conservative);

}  // namespace nacre
