#include "engine/software/sphere_boxes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "engine/scene/build/chunks.h"

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
SphereBox makeBox(const Corners& corners, std::span<const Sphere> spheres) {
    if (spheres.empty()) return {};
    const glm::vec3 middle = corners.low * 0.5f + corners.high * 0.5f;
    float ball = 0;
    for (const Sphere& s : spheres) ball = std::max(ball, glm::distance(s.center, middle));
    return {middle, corners.radius, glm::max(corners.high - middle, middle - corners.low), ball};
}

struct Place {
    glm::vec3 at{};
    std::uint32_t number = 0;
};

/// Halves places across their longest side until each box has its own places. Gives smaller boxes than Morton order.
/// @param first, end  in the stream. Cuts at a multiple of the largest possible power of two boxes, so that the boxes
/// of a group are neighbours.
void halve(Place* places, std::uint32_t first, std::uint32_t end) {
    std::uint32_t cut = first, size = SphereBoxes::kSpheres;
    while (size < end && (end - 1) / size * size > first) {
        cut = (end - 1) / size * size;
        size *= 2;
    }
    if (cut == first) {
        std::sort(places, places + (end - first), [](const Place& a, const Place& b) { return a.number < b.number; });
        return;
    }
    glm::vec3 low(std::numeric_limits<float>::max()), high(-std::numeric_limits<float>::max());
    for (const Place* p = places; p < places + (end - first); ++p) {
        low = glm::min(low, p->at);
        high = glm::max(high, p->at);
    }
    const glm::vec3 extent = high - low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    std::nth_element(places, places + (cut - first), places + (end - first), [axis](const Place& a, const Place& b) {
        return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.number < b.number;
    });
    halve(places, first, cut);
    halve(places + (cut - first), cut, end);
}

/// Numbers of spheres in an order that makes boxes small; runs stay separate.
std::vector<std::uint32_t> orderInBoxes(const std::vector<Sphere>& stream, const std::vector<std::uint32_t>& starts) {
    std::vector<Place> places(stream.size());
    for (std::uint32_t i = 0; i < stream.size(); ++i) {
        const glm::vec3 at = stream[i].center;
        const bool number = std::isfinite(at.x + at.y + at.z);
        places[i] = {number ? at : glm::vec3(0), i};
    }
    for (std::size_t run = 0; run + 1 < starts.size(); ++run)
        if (starts[run] < starts[run + 1]) halve(places.data() + starts[run], starts[run], starts[run + 1]);
    std::vector<std::uint32_t> order(stream.size());
    std::transform(places.begin(), places.end(), order.begin(), [](const Place& p) { return p.number; });
    return order;
}

}  // namespace

SphereBoxes makeSphereBoxes(std::span<const Sphere> spheres) {
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
            all.boxes.push_back(makeBox(corners, spheres.subspan(begin, end - begin)));
        }
        all.groups.push_back(makeBox(group, spheres.subspan(first, std::min(kOfGroup, spheres.size() - first))));
    }
    for (const Sphere& s : spheres) {
        const float reach =
            std::max({std::abs(s.center.x), std::abs(s.center.y), std::abs(s.center.z), std::abs(s.radius)});
        const bool number = std::isfinite(s.center.x + s.center.y + s.center.z + s.radius);
        all.reach = number ? std::max(all.reach, reach) : std::numeric_limits<float>::infinity();
    }
    return all;
}

/// Copies are drawn often, and have few spheres: an own order pays. The stream keeps its order, which decides which of
/// two equally near spheres is shown.
SphereBoxes makeSphereBoxes(const Representation& r) {
    if (r.copies.transforms.empty()) return makeSphereBoxes(r.spheres);
    std::vector<std::uint32_t> starts = runStarts(r.copies.spheres, r.sphereModels, r.spheres.size());
    std::vector<std::uint32_t> numbers = orderInBoxes(r.spheres, starts);
    std::vector<Sphere> spheres(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) spheres[i] = r.spheres[numbers[i]];
    SphereBoxes boxes = makeSphereBoxes(spheres);
    boxes.spheres = std::move(spheres);
    boxes.numbers = std::move(numbers);
    boxes.starts = std::move(starts);
    return boxes;
}

}  // namespace nacre
