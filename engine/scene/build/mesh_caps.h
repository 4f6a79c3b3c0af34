#pragma once
// Flat caps where the near clipping plane cuts closed meshes: triangles on the plane, inside the meshes' outlines
// there.

#include "engine/effects.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre {

/// Clip::capColor, packed; 0: empty.
std::uint32_t packedCapColor(const Clip& clip);

/// Whether there is a near clipping plane, and a mesh that gets caps: closed and opaque.
bool needsCaps(const Representation& scene, const Clip& clip);

/// The caps of a scene, with the scene's centre and atom numbers. They hold for one view and plane: rebuild them when
/// these change. A cap has the colours and numbers of the atoms nearest to each of its points:
/// Representation::surfaceAtoms of a surface, the outline's vertices of other meshes.
/// Shaders know caps by their distance from the plane, kCapRise (shaders/common/hit.glsl).
Representation meshCaps(const Representation& scene, const View& view, const Clip& clip);

}  // namespace nacre
