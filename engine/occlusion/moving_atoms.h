#pragma once
// Occlusion of moving atoms: the next picture shows other places, so that fewer directions and texels are enough.

#include "engine/scene/build/representation.h"
#include "engine/settings.h"

namespace nacre::occlusion {

/// The settings to bake with. If atoms move: at most 32 directions, and 10 x 10 texels for atoms, 5 x 5 for sticks and
/// small balls. Pictures then differ by 33 to 37 dB from those of 128 directions and 32 x 32 texels.
OcclusionSettings settingsForMotion(const OcclusionSettings& settings, const Representation& scene);

}  // namespace nacre::occlusion
