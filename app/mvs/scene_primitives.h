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

/// Reads the primitives of a group. @param own  the structure that the group is of; null: none
/// Leaves out faulty primitives, with a warning. @param structures  expressions name them by their `ref`
Primitives readPrimitives(const Node& group, const Structure* own, std::span<const Structure> structures,
                          SceneWarnings& warnings);

/// Primitives once per matrix of a group's `instances`; as they are if it has none. @throws std::invalid_argument
Primitives atInstances(const Node& group, Primitives primitives);

}  // namespace nacre::app::mvs
