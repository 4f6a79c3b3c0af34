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

/// The ball around a contour by Mol*'s rules: around the box of the nodes that reach its level, plus one node on each
/// side. Higher values, or lower ones for a negative level. Empty if no node reaches it.
std::optional<Bounds> boundsOfContour(const DensityMap& map, double level);

}  // namespace nacre::app::mvs
