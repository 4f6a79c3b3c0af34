#pragma once
// Depths of the visible parts of a scene.

#include <optional>
#include <vector>

#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre {

/// Depth of the nearest ball in each covered cell of a coarse grid over the scene: Å from the centre away from the
/// viewer, ascending. Atoms and vertices represent sticks and meshes.
/// @param balls  from drawnBalls()
std::vector<double> visibleDepths(const std::vector<glm::dvec4>& balls, const View& view);

/// The range of depths for fog in a scene whose visible part lies in front of its centre, such as a closed shell;
/// nothing for other scenes.
struct DepthRange {
    double near = 0, far = 0;
};
std::optional<DepthRange> frontRange(const std::vector<double>& depths, double radius);

}  // namespace nacre
