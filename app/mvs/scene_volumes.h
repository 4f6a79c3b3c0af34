#pragma once
// Density maps of a scene: volume nodes and what represents them.

#include <string>

#include "app/mvs/camera_nodes.h"
#include "app/mvs/scene_parts.h"

namespace nacre::app::mvs {

constexpr std::size_t kMostVolumes = 200;  ///< representations of maps, each with all its instances

/// Adds what a volume node shows to a scene's guide, and its focus nodes to the camera. A map that cannot be read is
/// left out with a warning. @param uri  of the file @throws Error if the file is not there, or the scene is too large
void addVolume(const Node& node, const std::string& uri, SceneFiles& files, SceneGuide& guide, CameraNodes& camera,
               SceneWarnings& warnings);

/// The ball about what a contour encloses, as Mol* has it: the box of the nodes that reach its level, and one more on
/// each side. Higher values; lower ones for a negative level. Nothing if no node reaches it.
std::optional<Bounds> boundsOfContour(const DensityMap& map, double level);

}  // namespace nacre::app::mvs
