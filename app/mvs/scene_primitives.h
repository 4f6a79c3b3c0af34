#pragma once
// The primitives of a scene: nodes `primitives` and `primitives_from_uri`.

#include <span>

#include "app/mvs/scene_parts.h"
#include "engine/scene/build/primitives.h"

namespace nacre::app::mvs {

/// The extent of a position: a point, or the atoms of an expression.
struct PlaceBounds {
    glm::dvec3 center{}, low{}, high{};
    double radius = 0;
};

/// Reads the primitives of a group. Omits faulty ones, with a warning. @param own  the group's structure; null: none
/// @param structures  expressions name them by their `ref`
Primitives readPrimitives(const Node& group, const Structure* own, std::span<const Structure> structures,
                          SceneWarnings& warnings);

/// Copies primitives for each matrix of a group's `instances`; unchanged without any. @throws std::invalid_argument
Primitives atInstances(const Node& group, Primitives primitives);

}  // namespace nacre::app::mvs
