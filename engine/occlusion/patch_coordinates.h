#pragma once
// Coordinates within the patches of an occlusion atlas, as in shaders/common/patch.glsl.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace nacre {

/// Octahedral map of a unit vector to [0, 1]^2.
inline glm::vec2 octahedralCoordinate(const glm::vec3& n) {
    glm::vec2 p = glm::vec2(n) / (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    if (n.z < 0) p = {(1 - std::abs(p.y)) * (p.x >= 0 ? 1.0f : -1.0f), (1 - std::abs(p.x)) * (p.y >= 0 ? 1.0f : -1.0f)};
    return p * 0.5f + 0.5f;
}
inline glm::vec3 octahedralNormal(const glm::vec2& uv) {
    const glm::vec2 p = uv * 2.0f - 1.0f;
    glm::vec3 n(p, 1.0f - std::abs(p.x) - std::abs(p.y));
    if (n.z < 0.0f) {
        n.x = (1.0f - std::abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f);
        n.y = (1.0f - std::abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f);
    }
    return glm::normalize(n);
}

/// Two unit vectors that form a frame with the unit vector w (Duff et al. 2017, JCGT 6(1)).
inline void frameAbout(const glm::vec3& w, glm::vec3& u, glm::vec3& v) {
    const float s = w.z >= 0.0f ? 1.0f : -1.0f;
    const float a = -1.0f / (s + w.z), b = w.x * w.y * a;
    u = {1.0f + s * w.x * w.x * a, s * b, -s * w.x};
    v = {b, s + w.y * w.y * a, -w.y};
}
/// Angle of a direction about the axis w, as 0..1 around.
inline float angleAbout(const glm::vec3& w, const glm::vec3& n) {
    glm::vec3 u, v;
    frameAbout(w, u, v);
    return std::atan2(glm::dot(n, v), glm::dot(n, u)) / (2 * std::numbers::pi_v<float>)+0.5f;
}
inline glm::vec3 directionAbout(const glm::vec3& w, float around) {
    glm::vec3 u, v;
    frameAbout(w, u, v);
    const float angle = (around - 0.5f) * 2.0f * std::numbers::pi_v<float>;
    return u * std::cos(angle) + v * std::sin(angle);
}

}  // namespace nacre
