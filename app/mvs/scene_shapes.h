#pragma once
// The shape nodes of a scene: meshes of files.

#include "app/mvs/camera_nodes.h"
#include "app/mvs/scene_parts.h"

namespace nacre::app::mvs {

/// Adds the mesh of a shape node. A file that cannot be read is left out, with a warning. @param parse  the node above
/// @throws Error if the file cannot be fetched
void addShape(const Node& parse, const Node& node, const std::string& uri, SceneFiles& files, SceneGuide& guide,
              CameraNodes& camera, SceneWarnings& warnings);

}  // namespace nacre::app::mvs
