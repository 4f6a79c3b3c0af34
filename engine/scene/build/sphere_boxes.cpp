#include "engine/scene/build/sphere_boxes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace nacre {
namespace {

struct Corners {
    glm::vec3 low{std::numeric_limits<float>::max()}, high{-std::numeric_limits<float>::max()};
    float radius = 0;

    void add(const Sphere& s) {
        low = glm::min(low, s.center);
        high = glm::max(high, s.center);
        radius = std::max(radius, s.radius);
    }
    void add(const Corners& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
        radius = std::max(radius, other.radius);
    }
};

/// @param corners  of the spheres
SphereBox boxOf(const Corners& corners, std::span<const Sphere> spheres) {
    if (spheres.empty()) return {};
    const glm::vec3 middle = corners.low * 0.5f + corners.high * 0.5f;
    float ball = 0;
    for (const Sphere& s : spheres) ball = std::max(ball, glm::distance(s.center, middle));
    return {middle, corners.radius, glm::max(corners.high - middle, middle - corners.low), ball};
}

}  // namespace

SphereBoxes sphereBoxesOf(std::span<const Sphere> spheres) {
    constexpr std::size_t kOfGroup = std::size_t{SphereBoxes::kSpheres} * SphereBoxes::kBoxes;
    SphereBoxes all;
    for (std::size_t first = 0; first < spheres.size(); first += kOfGroup) {
        Corners group;
        for (std::uint32_t b = 0; b < SphereBoxes::kBoxes; ++b) {
            const std::size_t begin = std::min(first + b * SphereBoxes::kSpheres, spheres.size());
            const std::size_t end = std::min<std::size_t>(begin + SphereBoxes::kSpheres, spheres.size());
            Corners corners;
            for (std::size_t i = begin; i < end; ++i) corners.add(spheres[i]);
            group.add(corners);
            all.boxes.push_back(boxOf(corners, spheres.subspan(begin, end - begin)));
        }
        all.groups.push_back(boxOf(group, spheres.subspan(first, std::min(kOfGroup, spheres.size() - first))));
    }
    for (const Sphere& s : spheres) {
        const float reach =
            std::max({std::abs(s.center.x), std::abs(s.center.y), std::abs(s.center.z), std::abs(s.radius)});
        const bool number = std::isfinite(s.center.x + s.center.y + s.center.z + s.radius);
        all.reach = number ? std::max(all.reach, reach) : std::numeric_limits<float>::infinity();
    }
    return all;
}

}  // namespace nacre
