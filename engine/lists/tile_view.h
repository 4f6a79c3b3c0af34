#pragma once
// The camera for visibility tests on the host: the arithmetic of the shaders, rounded differently.

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace nacre {

/// Which quarters of a picture's tiles are wanted: squares of 4 x 4 pixels, row by row.
struct TileMask {
    static constexpr std::uint32_t kSide = 4;  ///< of a quarter, pixels
    std::uint32_t across = 0;
    std::vector<std::uint8_t> wanted;
    bool wants(std::uint32_t x, std::uint32_t y) const {
        const std::size_t at = std::size_t{y} * across + x;
        return x < across && at < wanted.size() && wanted[at] != 0;
    }
    /// A bit for each quarter of a tile that is not wanted: 1 left, 2 right, 4 and 8 below them.
    std::uint32_t unwanted(std::uint32_t tileX, std::uint32_t tileY) const {
        std::uint32_t bits = 0;
        for (std::uint32_t i = 0; i < 4; ++i) bits |= wants(2 * tileX + i % 2, 2 * tileY + i / 2) ? 0u : 1u << i;
        return bits;
    }
};

/// The camera in the numbers that shaders get (ViewConstants in shaders/common/layout.h): Å, pixels.
struct TileView {
    std::uint32_t width = 0, height = 0;  ///< of the image, pixels
    bool perspective = false;
    int quarterTurns = 0;                            ///< as in View
    glm::vec2 axis{};                                ///< position of the view axis, pixels
    float pixels = 1;                                ///< per Å at z = 0
    float origin = 0;                                ///< Z is origin - z; in perspective the eye is there
    float nearest = 0;                               ///< Z of the nearest depth
    float range = 1;                                 ///< from nearest to farthest, Å
    static constexpr float kNoPlane = 1e30f;         ///< Z of a far plane that clips nothing; for a near plane
                                                     ///< -kNoPlane
    float clipNear = -kNoPlane, clipFar = kNoPlane;  ///< Z of clipping planes
    float contour = 0;                               ///< outline width of primitives, Å at z = 0
    /// Pixels are sampled at their centres only: triangles between centres are dropped and, with one layer, those
    /// hidden at every centre; pixels begin with the nearest.
    bool centers = false;
    /// Pixels are sampled at their centres first, and then between them: those begin with the nearest triangle, too,
    /// and triangles behind all around them are dropped.
    bool edges = false;
    float small = 0;                 ///< primitives of a lesser half width may lie between centres, pixels
    bool frontsOnly = false;         ///< triangles are invisible from behind
    float wireScale = 1;             ///< pixels per pixel of the picture, for the width of wires
    const TileMask* mask = nullptr;  ///< null: all tiles are drawn
    std::uint32_t layers = 1;        ///< number of nearest primitives per pixel

    bool clips() const { return clipNear > -kNoPlane || clipFar < kNoPlane; }
};

/// Primitives of a stream with one transform.
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

/// Radius of a ball that holds a sphere with its outline (shaders/common/view.glsl).
inline float reachOf(const TileView& view, float z, float radius) {
    if (!view.perspective) return radius + view.contour;
    return radius + view.contour * (view.origin - z + radius) / (view.origin - view.contour);
}

/// A disc on the plane z = 0 that holds a sphere's picture. In perspective that picture is an ellipse
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
