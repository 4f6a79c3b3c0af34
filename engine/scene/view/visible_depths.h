#pragma once
// How deep what a view shows is.

#include <optional>
#include <vector>

#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre {

/// Depths of what is nearest to the viewer in the cells of a coarse grid over the scene, Å from the centre away from
/// the viewer, ascending. Of sticks and meshes by their atoms and vertices. Empty without any.
/// @param balls  from drawnBalls()
std::vector<double> visibleDepths(const std::vector<glm::dvec4>& balls, const View& view);

/// The range of depths over which fog tells near from far, for a scene whose visible part is in front of its centre, as
/// the front of a closed shell is; nothing for others, whose depth goes on behind it.
struct DepthRange {
    double near = 0, far = 0;
};
std::optional<DepthRange> frontRange(const std::vector<double>& depths, double radius);

}  // namespace nacre
