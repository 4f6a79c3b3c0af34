#pragma once
// Cuts a scene's own geometry by clipping planes, so that chosen atoms can stay whole.

#include <vector>

#include "engine/effects.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre {

/// Cuts meshes and sticks at the planes, with the caps of mesh_caps.h, and omits atoms whose centre is beyond them.
/// Chosen atoms stay whole. Draw the result without clipping planes, in this view only.
/// @param chosen  one value per atom of the file @returns false, and changes nothing, for the copies of an assembly
bool cutScene(Representation& scene, const View& view, const Clip& clip, const std::vector<bool>& chosen);

}  // namespace nacre
