#include "engine/occlusion/nearest_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/scene/build/translucency.h"

namespace nacre {
namespace {

std::optional<SurfacePoint> meetSphere(const Sphere& s, const glm::vec3& start, const glm::vec3& direction) {
    const glm::vec3 d = start - s.center;
    const float middle = -glm::dot(d, direction), square = middle * middle - glm::dot(d, d) + s.radius * s.radius;
    if (!(square >= 0)) return {};
    const float distance = middle - std::sqrt(square);
    if (!(distance > 0)) return {};
    return SurfacePoint{.distance = distance, .normal = (d + direction * distance) / s.radius};
}

/// With flat ends.
std::optional<SurfacePoint> meetCylinder(const Cylinder& c, const glm::vec3& start, const glm::vec3& direction) {
    const glm::vec3 span = c.b - c.a, d = start - c.a;
    const float length = glm::length(span);
    if (!(length > 0)) return {};
    const glm::vec3 axis = span / length;
    const float lean = glm::dot(direction, axis), height = glm::dot(d, axis);
    const glm::vec3 across = direction - axis * lean, away = d - axis * height;
    const float a = glm::dot(across, across), b = glm::dot(across, away);
    const float square = b * b - a * (glm::dot(away, away) - c.radius * c.radius);
    if (square >= 0 && a > 0) {
        const float distance = (-b - std::sqrt(square)) / a, at = height + lean * distance;
        if (distance > 0 && at >= 0 && at <= length)
            return SurfacePoint{
                .distance = distance, .normal = (away + across * distance) / c.radius, .share = at / length};
    }
    if (lean == 0) return {};
    const float end = lean > 0 ? 0 : length, distance = (end - height) / lean;
    const glm::vec3 there = away + across * distance;
    if (distance <= 0 || glm::dot(there, there) > c.radius * c.radius) return {};
    // A cap has no texels of its own: those of the side next to it.
    const float off = glm::length(there);
    const glm::vec3 any = std::abs(axis.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 side = off > 0 ? there / off : glm::normalize(glm::cross(axis, any));
    return SurfacePoint{.distance = distance, .normal = side, .share = end / length};
}

/// Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997).
std::optional<SurfacePoint> meetTriangle(const Representation& r, const Triangle& t, const glm::vec3& start,
                                         const glm::vec3& direction) {
    const glm::vec3 a = decodePosition(r.meshVertices[t.a], t.step());
    const glm::vec3 ab = decodePosition(r.meshVertices[t.b], t.step()) - a,
                    ac = decodePosition(r.meshVertices[t.c], t.step()) - a;
    const glm::vec3 p = glm::cross(direction, ac);
    const float determinant = glm::dot(ab, p);
    if (determinant == 0) return {};
    const glm::vec3 d = start - a, q = glm::cross(d, ab);
    const float u = glm::dot(d, p) / determinant, v = glm::dot(direction, q) / determinant;
    const float distance = glm::dot(ac, q) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1 && distance > 0)) return {};
    return SurfacePoint{.distance = distance, .shares = {1 - u - v, u, v}, .inner = determinant < 0};
}

}  // namespace

NearestSurface::NearestSurface(const Representation& r) : r_(r), tree_(r, PrimitiveTree::Of::everything) {
    const TranslucentParts parts = translucentParts(r);
    if (parts.empty()) return;
    const std::size_t solids = r.spheres.size() + r.cylinders.size();
    translucent_.resize(solids + r.triangles.size());
    const auto mark = [&](std::size_t first, const TranslucentRuns& runs) {
        for (const TranslucentRun& run : runs)
            // Runs of triangles go on into the coarser ones, which rays do not meet.
            for (std::size_t i = first + run.first; i < std::min(first + run.first + run.count, translucent_.size());
                 ++i)
                translucent_[i] = true;
    };
    mark(0, parts.spheres);
    mark(r.spheres.size(), parts.cylinders);
    mark(solids, parts.triangles);
}

bool NearestSurface::buries(std::uint32_t self, const glm::vec3& point) const {
    bool buried = false;
    tree_.near(self, [&](std::uint32_t item) {
        if (!isOpaque(item) || item >= r_.spheres.size()) return true;
        constexpr float kDeep = 1e-3f;  // coinciding surfaces stay open
        const glm::vec3 d = point - r_.spheres[item].center;
        const float radius = r_.spheres[item].radius - kDeep;
        buried = glm::dot(d, d) < radius * radius;
        return !buried;
    });
    return buried;
}

std::optional<SurfacePoint> NearestSurface::meet(std::uint32_t item, const glm::vec3& start,
                                                 const glm::vec3& direction) const {
    const std::size_t spheres = r_.spheres.size(), solids = spheres + r_.cylinders.size();
    if (item < spheres) return meetSphere(r_.spheres[item], start, direction);
    if (item < solids) return meetCylinder(r_.cylinders[item - spheres], start, direction);
    return meetTriangle(r_, r_.triangles[item - solids], start, direction);
}

std::optional<SurfacePoint> NearestSurface::from(std::uint32_t self, const glm::vec3& start,
                                                 const glm::vec3& direction) const {
    std::optional<SurfacePoint> nearest;
    tree_.along(self, start, direction, [&](std::uint32_t item, float far) {
        if (item == self || !isOpaque(item)) return far;
        std::optional<SurfacePoint> met = meet(item, start, direction);
        if (!met || met->distance >= far) return far;
        nearest = met;
        nearest->item = item;
        return met->distance;
    });
    return nearest;
}

}  // namespace nacre
