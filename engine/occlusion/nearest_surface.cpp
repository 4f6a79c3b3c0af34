#include "engine/occlusion/nearest_surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/scene/build/translucency.h"
#include "engine/simd/lanes.h"

namespace nacre {
namespace {

constexpr float kWithin = 1e-3f;  // Å: coinciding surfaces stay open

std::optional<SurfaceHit> meetSphere(const Sphere& s, const glm::vec3& start, const glm::vec3& direction) {
    const glm::vec3 d = start - s.center;
    const float middle = -glm::dot(d, direction), square = middle * middle - glm::dot(d, d) + s.radius * s.radius;
    if (!(square >= 0)) return {};
    const float distance = middle - std::sqrt(square);
    if (!(distance > 0)) return {};
    return SurfaceHit{.distance = distance, .normal = (d + direction * distance) / s.radius};
}

/// @param item  of a sphere or ellipsoid
std::optional<SurfaceHit> meetBall(const Representation& r, std::uint32_t item, const glm::vec3& start,
                                   const glm::vec3& direction) {
    const EllipsoidRows* rows = r.ellipsoid(item);
    if (!rows) return meetSphere(r.spheres[item], start, direction);
    const glm::vec3 way = rows->toUnit(direction);
    const float length = glm::length(way);
    auto met = meetSphere({{}, 1}, rows->toUnit(start - r.spheres[item].center), way / length);
    if (!met) return {};
    met->distance /= length;
    met->normal = rows->gradient(met->normal);
    return met;
}

/// With flat ends.
std::optional<SurfaceHit> meetCylinder(const Cylinder& c, const glm::vec3& start, const glm::vec3& direction) {
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
            return SurfaceHit{
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
    return SurfaceHit{.distance = distance, .normal = side, .share = end / length};
}

/// Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997).
std::optional<SurfaceHit> meetTriangle(const Representation& r, const Triangle& t, const glm::vec3& start,
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
    return SurfaceHit{.distance = distance, .shares = {1 - u - v, u, v}, .inner = determinant < 0};
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

bool NearSpheres::bury(const glm::vec3& point) const {
    for (std::size_t i = 0; i < x.size(); i += kLanes) {
        const Lanes dx = loadLanes(&x[i]) - point.x, dy = loadLanes(&y[i]) - point.y, dz = loadLanes(&z[i]) - point.z;
        if (any(dx * dx + dy * dy + dz * dz < loadLanes(&squareWithin[i]))) return true;
    }
    return false;
}

NearSpheres NearestSurface::findNear(std::uint32_t sphere) const {
    NearSpheres near;
    const auto visit = [&](std::uint32_t item) {
        if (item >= r_.spheres.size() || !isOpaque(item)) return true;
        const Sphere& s = r_.spheres[item];
        near.items.push_back(item);
        near.x.push_back(s.center.x), near.y.push_back(s.center.y), near.z.push_back(s.center.z);
        near.square.push_back(s.radius * s.radius);
        near.hasEllipsoids = near.hasEllipsoids || r_.ellipsoid(item);
        const float within = std::max(r_.ballRadius(item) - kWithin, 0.0f);
        near.squareWithin.push_back(within * within);
        return true;
    };
    tree_.near(sphere, visit, NearSpheres::kReach);
    const std::size_t whole = (near.items.size() + kLanes - 1) / kLanes * kLanes;
    for (auto* const list : {&near.x, &near.y, &near.z}) list->resize(whole);
    constexpr float kMeetsNothing = -std::numeric_limits<float>::infinity();
    for (auto* const list : {&near.square, &near.squareWithin}) list->resize(whole, kMeetsNothing);
    return near;
}

bool NearestSurface::buries(std::uint32_t self, const glm::vec3& point) const {
    bool buried = false;
    tree_.near(self, [&](std::uint32_t item) {
        if (!isOpaque(item) || item >= r_.spheres.size()) return true;
        const glm::vec3 d = point - r_.spheres[item].center;
        const float radius = r_.spheres[item].radius - kWithin;
        const EllipsoidRows* rows = r_.ellipsoid(item);
        buried = rows ? glm::length(rows->toUnit(d)) < 1 - kWithin / rows->inner() : glm::dot(d, d) < radius * radius;
        return !buried;
    });
    return buried;
}

std::optional<SurfaceHit> NearestSurface::meet(std::uint32_t item, const glm::vec3& start,
                                               const glm::vec3& direction) const {
    const std::size_t spheres = r_.spheres.size(), solids = spheres + r_.cylinders.size();
    if (item < spheres) return meetBall(r_, item, start, direction);
    if (item < solids) return meetCylinder(r_.cylinders[item - spheres], start, direction);
    return meetTriangle(r_, r_.triangles[item - solids], start, direction);
}

std::optional<SurfaceHit> NearestSurface::from(std::uint32_t self, const glm::vec3& start,
                                               const glm::vec3& direction) const {
    return nearest(self, start, direction, {});
}

std::optional<SurfaceHit> NearestSurface::from(std::uint32_t self, const glm::vec3& start, const glm::vec3& direction,
                                               const NearSpheres& near) const {
    std::optional<SurfaceHit> found;
    for (std::size_t i = 0; i < near.x.size(); i += kLanes) {
        const Lanes dx = loadLanes(&near.x[i]) - start.x, dy = loadLanes(&near.y[i]) - start.y,
                    dz = loadLanes(&near.z[i]) - start.z;
        const Lanes middle = dx * direction.x + dy * direction.y + dz * direction.z;
        Mask meets = dx * dx + dy * dy + dz * dz - middle * middle < loadLanes(&near.square[i]);
        if (!near.hasEllipsoids) meets &= middle > 0;  // the tip of one may be ahead of its centre
        for (std::uint32_t bits = packSigns(meets); bits != 0; bits &= bits - 1) {
            const std::uint32_t item = near.items[i + static_cast<std::uint32_t>(std::countr_zero(bits))];
            std::optional<SurfaceHit> met = meetBall(r_, item, start, direction);
            if (!met || (found && met->distance >= found->distance)) continue;
            found = met;
            found->item = item;
        }
    }
    if (found && found->distance <= NearSpheres::kReach) return found;
    return nearest(self, start, direction, found);
}

/// @param found  on primitives that were tried before
std::optional<SurfaceHit> NearestSurface::nearest(std::uint32_t self, const glm::vec3& start,
                                                  const glm::vec3& direction, std::optional<SurfaceHit> found) const {
    const auto visit = [&](std::uint32_t item, float far) {
        if (item == self || !isOpaque(item)) return far;
        std::optional<SurfaceHit> met = meet(item, start, direction);
        if (!met || met->distance >= far) return far;
        found = met;
        found->item = item;
        return met->distance;
    };
    tree_.along(self, start, direction, visit, found ? found->distance : std::numeric_limits<float>::infinity());
    return found;
}

}  // namespace nacre
