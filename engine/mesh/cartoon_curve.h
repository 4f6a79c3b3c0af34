#pragma once
// The curve that a cartoon's cross-sections are carried along, and which way they lie.

#include <glm/vec3.hpp>
#include <vector>

#include "engine/mesh/cartoon_trace.h"

namespace nacre {

/// Where a cross-section stands.
struct Frame {
    glm::dvec3 center{};
    glm::dvec3 tangent{};  ///< unit, towards the C terminus or 3' end
    glm::dvec3 side{};     ///< unit: the direction of a ribbon's width
    glm::dvec3 normal{};   ///< tangent x side: a ribbon's face
};

/// Parts helices whose axis turns by over 46 degrees from one residue to the next: they are two, though nothing stands
/// between them.
std::vector<FoldRun> splitAtKinks(const Trace& trace, std::vector<FoldRun> runs);

/// Frames at u = k / segments, for every k from 0 to (points - 1) * segments. Cubic from point to point.
/// In helices the curve is round (the alpha carbons' radius all the way), and the width lies along the axis; strands
/// are smoothed to be without their zigzag, with the width along the carbonyls (or, without those, across the zigzag),
/// turned so that it never flips. In between, frames turn as little as they can. Helices that are no ribbons follow
/// their axis.
/// @param runs  foldRuns(); ignored where `plain`, as a putty has it
std::vector<Frame> cartoonFrames(const Trace& trace, const std::vector<FoldRun>& runs, HelixForm helices, bool plain,
                                 int segments);

}  // namespace nacre
