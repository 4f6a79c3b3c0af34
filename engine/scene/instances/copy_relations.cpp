#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <map>

#include "engine/scene/instances/copies.h"

namespace nacre {
namespace {

constexpr std::size_t kMostPairs = 1'000'000;

glm::dmat4x3 inverse(const glm::dmat4x3& transform) {
    const glm::dmat3 back = glm::transpose(glm::dmat3(transform[0], transform[1], transform[2]));
    return {back[0], back[1], back[2], -(back * transform[3])};
}

/// Applies `first`, then `second`.
glm::dmat4x3 after(const glm::dmat4x3& second, const glm::dmat4x3& first) {
    glm::dmat4x3 result;
    for (int i = 0; i < 4; ++i) result[i] = second * glm::dvec4(first[i], i == 3 ? 1.0 : 0.0);
    return result;
}

/// Relations that are equal up to rounding have the same key, except on the border of two keys, where they are searched
/// twice. Files state five to ten digits.
std::array<long long, 12> makeKey(const glm::dmat4x3& image, const glm::dvec3& centre) {
    std::array<long long, 12> key{};
    const glm::dvec3 moved = image * glm::dvec4(centre, 1.0);
    for (int i = 0; i < 9; ++i) key[static_cast<std::size_t>(i)] = std::llround(image[i / 3][i % 3] * 2000);
    for (int i = 0; i < 3; ++i) key[static_cast<std::size_t>(9 + i)] = std::llround(moved[i] * 20);
    return key;
}

}  // namespace

std::optional<std::vector<CopyRelation>> copyRelations(const std::vector<glm::dmat4x3>& transforms,
                                                       const Bounds& sphere, double reach) {
    if (transforms.size() > kMostRelatedCopies) return std::nullopt;
    std::vector<glm::dvec3> centers;
    for (const glm::dmat4x3& transform : transforms) centers.push_back(transform * glm::dvec4(sphere.center, 1.0));
    std::vector<CopyRelation> relations;
    std::map<std::array<long long, 12>, std::size_t> known;
    std::size_t pairs = 0;
    for (std::uint32_t a = 0; a < transforms.size(); ++a)
        for (std::uint32_t b = a + 1; b < transforms.size(); ++b) {
            if (glm::distance(centers[a], centers[b]) > 2 * sphere.radius + reach) continue;
            if (++pairs > kMostPairs) return std::nullopt;
            const glm::dmat4x3 forth = after(inverse(transforms[a]), transforms[b]);
            if (const auto found = known.find(makeKey(forth, sphere.center)); found != known.end()) {
                relations[found->second].pairs.emplace_back(a, b);
            } else if (const auto back = known.find(makeKey(inverse(forth), sphere.center)); back != known.end()) {
                relations[back->second].pairs.emplace_back(b, a);
            } else {
                if (relations.size() == kMostRelations) return std::nullopt;
                known.emplace(makeKey(forth, sphere.center), relations.size());
                relations.push_back({forth, {{a, b}}});
            }
        }
    return relations;
}

}  // namespace nacre
