#pragma once
// The curve along which a cartoon's cross-sections are swept, and their orientation.

#include <glm/vec3.hpp>
#include <vector>

#include "engine/mesh/cartoon_trace.h"

namespace nacre {

/// Position and orientation of a cross-section.
struct Frame {
    glm::dvec3 center{};
    glm::dvec3 tangent{};  ///< unit, towards the C terminus or 3' end
    glm::dvec3 side{};     ///< unit: the direction of a ribbon's width
    glm::dvec3 normal{};   ///< tangent x side: a ribbon's face
};

/// Splits helices whose axis turns by over 46 degrees from one residue to the next.
std::vector<FoldRun> splitAtKinks(const Trace& trace, std::vector<FoldRun> runs);

/// Frames at u = k / segments, for every k from 0 to (points - 1) * segments, cubic between points. In helices the
/// curve is round (always at the alpha carbons' radius), with the width along the axis; strands are smoothed to remove
/// their zigzag, with the width along the carbonyls (or else across the zigzag), oriented so that it never flips. In
/// between, frames rotate as little as possible. Helices not drawn as ribbons follow their axis.
/// @param runs  foldRuns(); ignored if `plain`, for putty
std::vector<Frame> cartoonFrames(const Trace& trace, const std::vector<FoldRun>& runs, HelixForm helices, bool plain,
                                 int segments);

}  // namespace nacre
