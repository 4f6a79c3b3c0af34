#pragma once

#include <cstdint>

#include "engine/settings.h"

namespace nacre {

/// Draws depth as seen from the light.
constexpr const char* kShadowPass = "shadow map";

/// Width of the shadow map, pixels; 0: no shadows.
inline std::uint32_t shadowPixels(const RenderSettings& settings) {
    if (settings.effects.shadow.strength <= 0 || !settings.lighting) return 0;
    constexpr double kLarge = 80;  // Å
    return settings.view.radius > kLarge ? 2048 : 1024;
}

}  // namespace nacre
