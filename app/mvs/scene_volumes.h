#pragma once
// Density maps of a scene: volume nodes and their representations.

#include <string>

#include "app/mvs/camera_nodes.h"
#include "app/mvs/scene_parts.h"

namespace nacre::app::mvs {

constexpr std::size_t kMostVolumes = 200;  ///< representations of maps, each with all its instances

/// Adds a volume node's representations to a scene's guide, and its focus nodes to the camera. Omits an unreadable map,
/// with a warning. @param uri  of the file @throws Error if the file is not there, or the scene is too large
void addVolume(const Node& node, const std::string& uri, SceneFiles& files, SceneGuide& guide, CameraNodes& camera,
               SceneWarnings& warnings);

}  // namespace nacre::app::mvs
