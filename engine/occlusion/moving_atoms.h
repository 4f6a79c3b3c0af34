#pragma once
// Occlusion of moving atoms: the next picture shows other places, so that fewer directions and texels are enough.

#include "engine/scene/build/representation.h"
#include "engine/settings.h"

namespace nacre::occlusion {

/// The settings to bake with. If atoms move: at most 32 directions and 9 x 9 texels for atoms, 12 and 3 x 3 for
/// sticks and small balls. docs/ambient_occlusion.md states the difference.
OcclusionSettings settingsForMotion(const OcclusionSettings& settings, const Representation& scene);

}  // namespace nacre::occlusion
