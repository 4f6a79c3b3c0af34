#include "engine/baked_occlusion.h"

#include <algorithm>
#include <glm/vec2.hpp>

#include "engine/occlusion/patch_coordinates.h"
#include "shaders/common/layout.h"

namespace nacre {

float BakedOcclusion::texel(std::uint64_t x, std::uint64_t y) const {
    return static_cast<float>(texels[y * width + x]) / 255.0f;
}

/// Interpolates linearly between four texels; u and v run from the first to the last texel.
float BakedOcclusion::patch(std::uint64_t left, std::uint64_t top, float u, float v, std::uint32_t w,
                            std::uint32_t h) const {
    const auto cell = [](float at, std::uint32_t texelsAcross) {
        const float scaled = std::clamp(at, 0.0f, 1.0f) * static_cast<float>(texelsAcross - 1);
        const auto first = std::min(static_cast<std::uint32_t>(scaled), texelsAcross < 2 ? 0 : texelsAcross - 2);
        return std::pair(first, scaled - static_cast<float>(first));
    };
    const auto [x, right] = cell(u, w);
    const auto [y, down] = cell(v, h);
    const std::uint64_t x1 = left + std::min(x + 1, w - 1), y1 = top + std::min(y + 1, h - 1);
    const float above = texel(left + x, top + y) * (1 - right) + texel(x1, top + y) * right;
    const float below = texel(left + x, y1) * (1 - right) + texel(x1, y1) * right;
    return above * (1 - down) + below * down;
}

float BakedOcclusion::ofSphere(std::uint32_t sphere, const glm::vec3& normal) const {
    if (texels.empty()) return 1;
    const std::uint32_t inRow = width / sphereEdge;
    const glm::vec2 uv = octahedralCoordinate(normal);
    return patch(std::uint64_t{sphere % inRow} * sphereEdge, std::uint64_t{sphere / inRow} * sphereEdge, uv.x, uv.y,
                 sphereEdge, sphereEdge);
}

float BakedOcclusion::ofCylinder(std::uint32_t cylinder, const glm::vec3& axis, const glm::vec3& normal,
                                 float share) const {
    if (texels.empty()) return 1;
    const std::uint32_t inRow = width / around;
    return patch(std::uint64_t{cylinder % inRow} * around, sphereRows + std::uint64_t{cylinder / inRow} * along,
                 angleAbout(axis, normal), share, around, along);
}

float BakedOcclusion::ofVertex(std::uint32_t vertex, bool inner) const {
    if (texels.empty()) return 1;
    const std::uint64_t at = 2 * std::uint64_t{vertex} + (inner ? 1 : 0);
    return texel(at % width, std::uint64_t{sphereRows} + cylinderRows + at / width);
}

float reachingLight(const glm::vec3& base, float open) {
    const float albedo = (base.r + base.g + base.b) / 3, closed = std::max(2 * layout::kLeastLight - open, 0.0f);
    const float o = open + closed * closed * (0.25f / layout::kLeastLight);
    const float bounced = o * (o * 2.0404f - 4.7951f) + 2.7552f, first = o * (o * -0.3324f + 0.6417f) + 0.6903f;
    return o * std::max(albedo * bounced + first, 1.0f);
}

}  // namespace nacre
