#include "engine/occlusion/moving_atoms.h"

#include <algorithm>

namespace nacre::occlusion {

OcclusionSettings settingsForMotion(const OcclusionSettings& settings, const Representation& scene) {
    constexpr float kSmall = 0.8f;  // mean radius, weighted by area, Å
    constexpr std::uint32_t kTexelsOfAtoms = 9, kTexelsOfSmall = 3;
    constexpr int kDirectionsOfAtoms = 32, kDirectionsOfSmall = 12;
    if (!settings.moving) return settings;
    float radii = 0, weights = 0;
    for (const Sphere& s : scene.spheres) {
        radii += s.radius * s.radius * s.radius;
        weights += s.radius * s.radius;
    }
    OcclusionSettings few = settings;
    const bool small = radii < kSmall * weights;
    few.directions = std::min(settings.directions, small ? kDirectionsOfSmall : kDirectionsOfAtoms);
    few.detail = std::min(settings.detail, small ? kTexelsOfSmall : kTexelsOfAtoms);
    return few;
}

}  // namespace nacre::occlusion
