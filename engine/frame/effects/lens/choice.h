#pragma once

#include "engine/settings.h"

namespace nacre {

/// Whether pictures by these settings are drawn through a lens.
inline bool hasLens(const RenderSettings& settings) {
    return settings.effects.depthOfField.strength > 0 && settings.debug == DebugView::none;
}

}  // namespace nacre
