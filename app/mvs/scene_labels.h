#pragma once
// Labels of a structure's atoms.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/mvs/scene_parts.h"
#include "engine/scene/primitives.h"

namespace nacre::app::mvs {

constexpr double kEmOfSize = 0.6;  ///< em of a label of size 1, Å: measured in Mol*'s pictures

/// The label of some atoms, as Mol* sizes it: the cube root of how many they are.
/// @param atoms  of the structure, ascending, at least one @param depth  Å from its place to the farthest atom
Primitives::Label labelOf(const std::string& text, const std::vector<std::uint32_t>& atoms, const Structure& structure,
                          std::optional<std::uint32_t> color, double* depth = nullptr);

/// Where an atom of a structure stands first: by its copies, transforms and instances.
glm::dmat4x3 firstMotionOf(const Structure& structure);

/// Plain text as labels take it, safe from being read as markup.
std::string withoutMarkup(std::string_view text);

}  // namespace nacre::app::mvs
