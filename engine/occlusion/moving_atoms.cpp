#include "engine/occlusion/moving_atoms.h"

#include <algorithm>

namespace nacre::occlusion {

OcclusionSettings settingsForMotion(const OcclusionSettings& settings, const Representation& scene) {
    constexpr float kSmall = 0.8f;  // mean radius, weighted by area, Å
    constexpr std::uint32_t kOfAtoms = 10, kOfSmall = 5;
    if (!settings.moving) return settings;
    float radii = 0, weights = 0;
    for (const Sphere& s : scene.spheres) {
        radii += s.radius * s.radius * s.radius;
        weights += s.radius * s.radius;
    }
    OcclusionSettings few = settings;
    few.directions = std::min(settings.directions, OcclusionSettings::kMovingDirections);
    few.detail = std::min(settings.detail, radii < kSmall * weights ? kOfSmall : kOfAtoms);
    return few;
}

}  // namespace nacre::occlusion
