#pragma once
// Facts about a pass that vendors' profilers ask for, derived from how it uses images.

#include <cstdint>

#include "engine/graph/graph.h"

namespace nacre {

/// Bytes that a pass fetches per primitive, or, if `perPixel`, per covered pixel.
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
    const char* why = "";        ///< reason for `depth`
    Fetch binning;               ///< positions only, to find a primitive's tiles
    Fetch shading;               ///< the rest, for visible primitives
    const char* precision = "";  ///< what may use 16 bits, and what must not
};

/// @param pass          of the screen frame
/// @param conservative  PlanCaps::conservativeDepth
PassNotes describePass(const graph::PassDecl& pass, bool conservative);

}  // namespace nacre
