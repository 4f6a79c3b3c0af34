#include "engine/frame/foveation.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nacre {
namespace {

constexpr double kDegree = 0.017453292519943295;
// The finest detail that an eye sees grows evenly with the distance from where it looks: B. Guenter et al., Foveated 3D
// Graphics, ACM Transactions on Graphics 31 (2012), 164, the more careful of two slopes (1.32 minutes per degree).
constexpr double kFinest = kDegree / 48, kSlope = 1.32 / 60;

/// The byte whose reciprocal is not below a fragment's side: a driver may draw smaller fragments only.
std::uint8_t toDensity(std::uint32_t side) { return static_cast<std::uint8_t>(255 / side); }

/// Pixels per side of fragments that an eye does not tell from single pixels: 1, 2 or 4.
/// @param tangent  of the angle to the eye's axis @param pixels  per tangent at the axis
std::uint32_t fragmentSide(double tangent, double pixels) {
    const double angle = std::atan(tangent), beyond = std::max(0.0, angle - kGaze * kDegree);
    const double pixel = std::cos(angle) / pixels;  // the side along which pixels shrink least, radians
    const double seen = kFinest + kSlope * beyond;
    return seen >= 4 * pixel ? 4 : seen >= 2 * pixel ? 2 : 1;
}

}  // namespace

graph::ImageDesc densityMapFor(graph::Extent image, std::uint32_t views, std::uint32_t texel) {
    const auto texels = [&](std::uint32_t pixels) { return (pixels + texel - 1) / texel; };
    graph::ImageDesc map{VK_FORMAT_R8G8_UNORM, {texels(image.width), texels(image.height)}};
    map.layers = views;
    return map;
}

EyeAxis findAxis(const View& v) {
    const double pixels = v.pixelsPerAngstrom;
    return {{v.width, v.height},
            glm::dvec2(v.width, v.height) / 2.0 + glm::dvec2(v.pan.x, -v.pan.y) * pixels,
            pixels * v.eyeDistance};
}

bool alike(const EyeAxis& a, const EyeAxis& b) {
    return a.image == b.image && glm::distance(a.place, b.place) < 0.5 && std::abs(a.pixels - b.pixels) < 0.5;
}

std::vector<std::uint8_t> fragmentDensities(std::span<const EyeAxis> eyes, std::uint32_t texel) {
    std::vector<std::uint8_t> bytes;
    for (const EyeAxis& eye : eyes)
        for (std::uint32_t y = 0; y < eye.image.height; y += texel)
            for (std::uint32_t x = 0; x < eye.image.width; x += texel) {
                // Of the texel's places the nearest to the axis needs the finest fragments.
                const glm::dvec2 low(x, y), nearest = glm::clamp(eye.place, low, low + double(texel));
                const double tangent = glm::distance(nearest, eye.place) / eye.pixels;
                bytes.insert(bytes.end(), 2, toDensity(fragmentSide(tangent, eye.pixels)));
            }
    return bytes;
}

}  // namespace nacre
