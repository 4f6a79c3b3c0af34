#pragma once
// The camera for the host's visibility tests: the arithmetic of shaders, rounded differently.

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace nacre {

/// The camera, in the shaders' numbers (ViewConstants in shaders/common/layout.h): Å, pixels.
struct ScreenView {
    std::uint32_t width = 0, height = 0;  ///< of the image, pixels
    bool perspective = false;
    int quarterTurns = 0;                            ///< as in View
    glm::vec2 axis{};                                ///< position of the view axis, pixels
    float pixels = 1;                                ///< per Å at z = 0
    float pixel = 1;                                 ///< its reciprocal
    float origin = 0;                                ///< Z is origin - z; in perspective the eye is there
    float nearest = 0;                               ///< Z of the nearest depth
    float range = 1;                                 ///< from nearest to farthest, Å
    float perRange = 1;                              ///< its reciprocal
    static constexpr float kNoPlane = 1e30f;         ///< Z of a far plane that clips nothing; of a near one -kNoPlane
    float clipNear = -kNoPlane, clipFar = kNoPlane;  ///< Z of clipping planes
    float contour = 0;                               ///< outline width of primitives, Å at z = 0

    bool clips() const { return clipNear > -kNoPlane || clipFar < kNoPlane; }
};

inline glm::vec3 placed(const glm::vec4* rows, const glm::vec3& p) {
    return {rows[0].x * p.x + rows[0].y * p.y + rows[0].z * p.z + rows[0].w,
            rows[1].x * p.x + rows[1].y * p.y + rows[1].z * p.z + rows[1].w,
            rows[2].x * p.x + rows[2].y * p.y + rows[2].z * p.z + rows[2].w};
}

/// From the plane z = 0 to the image, whose rows run downwards.
inline glm::vec2 toPixel(const ScreenView& view, glm::vec2 q) {
    const glm::vec2 p = glm::vec2(q.x, -q.y) * view.pixels;
    switch (view.quarterTurns & 3) {
        case 1:
            return view.axis + glm::vec2(-p.y, p.x);
        case 2:
            return view.axis - p;
        case 3:
            return view.axis + glm::vec2(p.y, -p.x);
        default:
            return view.axis + p;
    }
}

/// The first pixel whose centre is not before a coordinate, and one past the last whose centre is not behind it.
/// @param first, end  bounds of the result
inline std::uint32_t pixelAt(float place, std::uint32_t first, std::uint32_t end) {
    const float at = place + 0.5f;
    if (!(at > static_cast<float>(first))) return first;
    return at < static_cast<float>(end) ? static_cast<std::uint32_t>(at) : end;
}

/// Radius of a ball that holds a sphere with its outline (shaders/common/view.glsl).
inline float outlinedRadius(const ScreenView& view, float z, float radius) {
    if (!view.perspective) return radius + view.contour;
    return radius + view.contour * (view.origin - z + radius) / (view.origin - view.contour);
}

/// A disc on the plane z = 0 that holds a sphere's picture. In perspective that picture is an ellipse
/// (shaders/common/outline.glsl).
struct Disc {
    glm::vec2 center;
    float radius;
};
inline Disc boundingDisc(const ScreenView& view, const glm::vec3& center, float radius) {
    if (!view.perspective) return {glm::vec2(center), radius};
    const float E = view.origin, D = E - center.z;
    const float rho = glm::length(glm::vec2(center));
    const float under = D * D - radius * radius;
    const float a = E * radius * std::sqrt(under + rho * rho) / under;
    return {glm::vec2(center) * (E * D / under), a + 4e-6f * (rho + a) * E / D};
}

}  // namespace nacre
