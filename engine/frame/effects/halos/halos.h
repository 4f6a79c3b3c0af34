#pragma once
// Halos around foreground shapes, denser the farther the background lies behind. The pass of outlines draws them
// (effects/outlines): the denser rim of a pixel stays.

#include "engine/frame/effects/outlines/outlines.h"
#include "engine/frame/picture.h"

namespace nacre {

/// Halos of a view, for shaders.
inline void addHalos(layout::EffectConstants& c, const RenderSettings& settings) {
    const Halos& halos = settings.effects.halos;
    c.halo = linearColor(halos.color, halos.strength);
    c.haloWidth = makeRims(settings).halo;
    c.perHaloDepth = static_cast<float>(1.0 / halos.depth);
}

}  // namespace nacre
