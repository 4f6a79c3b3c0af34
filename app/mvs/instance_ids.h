#pragma once
// Ids of copies, as selectors name them: "ASM-1" and "ASM-X0-5" by the operators of an assembly, "3_655" by the
// operation and the cells of a crystal, "1_555" of a model.

#include <set>
#include <string>

#include "app/mvs/scene_parts.h"

namespace nacre::app::mvs {

/// The ids in all selectors and annotations of a scene. @throws Error if there are too many
std::set<std::string> namedInstances(const Node& root, SceneFiles& files);

/// Splits the copies of a structure into groups, so that each id means whole groups. @param node  of the structure
/// @throws Error if they have too many atoms
void splitInstances(const Node& node, const std::set<std::string>& ids, Structure& structure, SceneFiles& files);

}  // namespace nacre::app::mvs
