#pragma once
// The primitives of a scene: nodes `primitives` and `primitives_from_uri`.

#include <functional>
#include <optional>
#include <span>

#include "app/mvs/scene_parts.h"
#include "engine/scene/primitives.h"

namespace nacre::app::mvs {

/// The extent of a position: a point, or the atoms of an expression.
struct PlaceBounds {
    glm::dvec3 center{}, low{}, high{};
    double radius = 0;
};

/// Reads the primitives of a group. @param own  the structure that the group is of; null: none
/// @param structures  by whose `ref` expressions name them @throws Error
Primitives readPrimitives(const Node& group, const Structure* own, std::span<const Structure> structures,
                          SceneWarnings& warnings);

/// Primitives once per matrix of a group's `instances`; as they are if it has none. @throws Error
Primitives atInstances(const Node& group, Primitives primitives);

/// @throws Error with the node's place
[[noreturn]] void refusePrimitive(const Node& node, const std::string& why);

/// The label of some atoms, as Mol* sizes it: the cube root of how many they are.
/// @param atoms  of the structure, ascending, at least one @param depth  Å from its place to the farthest atom
Primitives::Label labelOf(const std::string& text, const std::vector<std::uint32_t>& atoms, const Structure& structure,
                          std::optional<std::uint32_t> color, double* depth = nullptr);

/// Where an atom of a structure stands first: by its copies, transforms and instances.
glm::dmat4x3 firstMotionOf(const Structure& structure);

/// Plain text as labels take it, safe from being read as markup.
std::string withoutMarkup(std::string_view text);

}  // namespace nacre::app::mvs
