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

/// The caps of a scene, with the scene's centre and atom numbers. They are valid for one view and plane. Each point of
/// a cap has the colour and number of the nearest atom: for a surface from Representation::surfaceAtoms, for other
/// meshes from the vertices of the outline.
/// Shaders recognise caps by their distance from the plane, kCapRise (shaders/common/hit.glsl).
Representation meshCaps(const Representation& scene, const View& view, const Clip& clip);

}  // namespace nacre
