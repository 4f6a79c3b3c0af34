#pragma once
// Translucent atoms and bonds of a scene's layer. Only triangles are blended, so these balls and sticks become
// triangles.

#include "engine/scene/build/representation.h"
#include "engine/scene/build/scene_guide.h"

namespace nacre {

/// More atoms than these are drawn opaque.
constexpr std::size_t kMostTranslucentAtoms = 20'000;

/// Turns the spheres and cylinders of a layer's translucent atoms into meshes. @param part  of the layer alone
void meshTranslucentAtoms(const SceneLayer& layer, Representation& part);

}  // namespace nacre
