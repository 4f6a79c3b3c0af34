#pragma once
// How a picture is looked at where the host finds out what its parts may show: the arithmetic of the shaders, rounded
// differently.

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace nacre {

/// How a picture is looked at, in the numbers that shaders get (ViewConstants in shaders/common/layout.h): Å, pixels.
struct TileView {
    std::uint32_t width = 0, height = 0;  ///< pixels of the image
    bool perspective = false;
    int quarterTurns = 0;                            ///< as in View
    glm::vec2 axis{};                                ///< pixel of the view axis
    float pixels = 1;                                ///< per Å at z = 0
    float origin = 0;                                ///< Z is origin - z; in perspective the eye stands there
    float nearest = 0;                               ///< Z of the nearest depth
    float range = 1;                                 ///< from there to the farthest, Å
    static constexpr float kNoPlane = 1e30f;         ///< Z of a far plane that cuts nothing; a near one's is -kNoPlane
    float clipNear = -kNoPlane, clipFar = kNoPlane;  ///< Z that planes cut at
    float contour = 0;                               ///< width of the line about a primitive, Å at z = 0
    /// Pixels are asked at their centres alone: triangles that lie between them are left out, and, where one layer is
    /// asked for, such as lie behind others at all of them; pixels begin with the nearest.
    bool centers = false;
    float wireScale = 1;       ///< pixels across one of the picture, by which wires are wide
    std::uint32_t layers = 1;  ///< how many of the nearest primitives a pixel shows

    bool clips() const { return clipNear > -kNoPlane || clipFar < kNoPlane; }
};

/// Primitives of a stream at one place.
struct TileCall {
    const glm::vec4* rows = nullptr;  ///< three: into view space
    std::uint32_t first = 0, count = 0;
    std::uint32_t number = 0;  ///< of the stream's first primitive there
};

inline glm::vec3 placed(const glm::vec4* rows, const glm::vec3& p) {
    return {rows[0].x * p.x + rows[0].y * p.y + rows[0].z * p.z + rows[0].w,
            rows[1].x * p.x + rows[1].y * p.y + rows[1].z * p.z + rows[1].w,
            rows[2].x * p.x + rows[2].y * p.y + rows[2].z * p.z + rows[2].w};
}

/// From the plane z = 0 to the image, whose rows run downwards.
inline glm::vec2 pixelOf(const TileView& view, glm::vec2 q) {
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

/// Of a ball that holds a sphere with its contour line (shaders/common/view.glsl).
inline float reachOf(const TileView& view, float z, float radius) {
    if (!view.perspective) return radius + view.contour;
    return radius + view.contour * (view.origin - z + radius) / (view.origin - view.contour);
}

/// A disc on the plane z = 0 that holds a sphere's picture. In perspective about the ellipse that is its image
/// (shaders/common/outline.glsl).
struct Disc {
    glm::vec2 center;
    float radius;
};
inline Disc discOf(const TileView& view, const glm::vec3& center, float radius) {
    if (!view.perspective) return {glm::vec2(center), radius};
    const float E = view.origin, D = E - center.z;
    const float rho = glm::length(glm::vec2(center));
    const float under = D * D - radius * radius;
    const float a = E * radius * std::sqrt(under + rho * rho) / under;
    return {glm::vec2(center) * (E * D / under), a + 4e-6f * (rho + a) * E / D};
}

}  // namespace nacre
