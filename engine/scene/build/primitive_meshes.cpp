#include "engine/scene/build/primitive_meshes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "engine/error.h"
#include "engine/mesh/mesh_levels.h"
#include "engine/mesh/solids.h"
#include "engine/mesh/unit_vectors.h"
#include "engine/scene/build/mesh_scene.h"
#include "engine/scene/build/mesh_streams.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

constexpr int kFinestDetail = 6, kCoarsestDetail = 2;

/// A sphere of radius 1: an octahedron whose triangles are repeatedly split in four. The vertices of a coarser level
/// are the first of those of a finer one.
struct UnitSphere {
    struct Level {
        std::vector<glm::uvec3> triangles;
        double error = 0;  ///< largest distance of its triangles inside of the sphere
        std::uint32_t vertices = 0;
    };
    std::vector<glm::dvec3> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<Level> levels;  ///< 8 triangles, 32, ...

    UnitSphere() {
        std::vector<glm::uvec3> triangles;
        for (const unsigned x : {0u, 1u})
            for (const unsigned y : {2u, 3u})
                for (const unsigned z : {4u, 5u}) {
                    const bool odd = ((x + y + z) & 1) != 0;
                    triangles.emplace_back(x, odd ? z : y, odd ? y : z);
                }
        for (int i = 0; i <= kFinestDetail; ++i) {
            if (i > 0) triangles = parted(triangles);
            double nearest = 1;
            for (const glm::uvec3& t : triangles) {
                const glm::dvec3 a = points[t.x];
                const glm::dvec3 n = glm::normalize(glm::cross(points[t.y] - a, points[t.z] - a));
                nearest = std::min(nearest, glm::dot(n, a));
            }
            levels.push_back({triangles, 1 - nearest, static_cast<std::uint32_t>(points.size())});
        }
    }

private:
    std::vector<glm::uvec3> parted(const std::vector<glm::uvec3>& triangles) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, added] = middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(points.size()));
            if (added) points.push_back(glm::normalize(points[a] + points[b]));
            return found->second;
        };
        std::vector<glm::uvec3> finer;
        for (const glm::uvec3& t : triangles) {
            const std::uint32_t ab = middle(t.x, t.y), bc = middle(t.y, t.z), ca = middle(t.z, t.x);
            for (const glm::uvec3& part :
                 {glm::uvec3(t.x, ab, ca), glm::uvec3(ab, t.y, bc), glm::uvec3(ca, bc, t.z), glm::uvec3(ab, bc, ca)})
                finer.push_back(part);
        }
        return finer;
    }
};

const UnitSphere& unitSphere() {
    static const UnitSphere sphere;
    return sphere;
}

/// Level of the unit sphere for this many ellipsoids: about two million triangles in total.
int detailFor(std::size_t count) {
    constexpr std::size_t kAimedTriangles = 2'000'000;
    int detail = kFinestDetail;
    while (detail > kCoarsestDetail &&
           count * unitSphere().levels[static_cast<std::size_t>(detail)].triangles.size() > kAimedTriangles)
        --detail;
    return detail;
}

std::size_t countEllipsoids(const Primitives& all) {
    return all.ellipsoids.size() +
           static_cast<std::size_t>(std::count_if(all.balls.begin(), all.balls.end(),
                                                  [](const Primitives::Ball& ball) { return ball.look.opacity < 1; }));
}

}  // namespace

double ellipsoidError(std::size_t count) {
    return unitSphere().levels[static_cast<std::size_t>(detailFor(count))].error;
}

PrimitiveMeshes::PrimitiveMeshes(Representation& scene, const Primitives& all)
    : scene_(scene), detail_(detailFor(countEllipsoids(all))) {
    solids_.coarser = cartoonLevels();
}

std::uint32_t PrimitiveMeshes::numberLook(const PrimitiveLook& look) {
    const auto same = [&](const PrimitiveLook& other) {
        return other.color == look.color && other.opacity == look.opacity && other.note == look.note;
    };
    if (solids_.triangles.size() > kMostPrimitiveTriangles)
        throw Error("cannot draw primitives", "",
                    "they take more than " + std::to_string(kMostPrimitiveTriangles) + " triangles");
    if (looks_.empty() || !same(looks_.back())) looks_.push_back(look);
    return static_cast<std::uint32_t>(looks_.size() - 1);
}

/// Adds the finest mesh's triangles from `first` on to every level.
void PrimitiveMeshes::toAllLevels(std::size_t first) {
    const auto from = solids_.triangles.begin() + static_cast<std::ptrdiff_t>(first);
    for (MeshLevel& level : solids_.coarser)
        level.triangles.insert(level.triangles.end(), from, solids_.triangles.end());
}

void PrimitiveMeshes::cylinder(const glm::dvec3& a, const glm::dvec3& b, double radius, const PrimitiveLook& look) {
    cylinder(a, b, radius, look, look);
}

void PrimitiveMeshes::cylinder(const glm::dvec3& a, const glm::dvec3& b, double radius, const PrimitiveLook& lookA,
                               const PrimitiveLook& lookB) {
    const std::uint32_t ofA = numberLook(lookA), ofB = numberLook(lookB);
    addCylinder(solids_, a - scene_.center, b - scene_.center, radius, ofA, ofB, kRoundSides);
}

void PrimitiveMeshes::cone(const glm::dvec3& base, const glm::dvec3& tip, double radius, const PrimitiveLook& look) {
    const double height = glm::distance(base, tip);
    if (!(height > 1e-9) || !std::isfinite(height)) return;
    const std::uint32_t number = numberLook(look);
    const glm::dvec3 at = base - scene_.center, top = tip - scene_.center, axis = (tip - base) / height;
    const glm::dvec3 x = anyAcross(axis), y = glm::cross(axis, x);
    const double slant = std::hypot(height, radius);
    const auto out = [&](double side) {
        const double angle = 2 * std::numbers::pi * side / kRoundSides;
        return x * std::cos(angle) + y * std::sin(angle);
    };
    const auto slope = [&](double side) { return out(side) * (height / slant) + axis * (radius / slant); };
    const std::size_t first = solids_.triangles.size();
    const std::uint32_t middle = addVertex(solids_, at, -axis, number);
    for (int i = 0; i < kRoundSides; ++i) {
        const std::uint32_t rim = addVertex(solids_, at + out(i) * radius, slope(i), number);
        addVertex(solids_, at + out(i + 1) * radius, slope(i + 1), number);
        addVertex(solids_, top, slope(i + 0.5), number);  // a tip has a normal per side
        solids_.triangles.emplace_back(rim, rim + 1, rim + 2);
        addVertex(solids_, at + out(i) * radius, -axis, number);
        addVertex(solids_, at + out(i + 1) * radius, -axis, number);
        solids_.triangles.emplace_back(middle, rim + 4, rim + 3);
    }
    toAllLevels(first);
}

void PrimitiveMeshes::ellipsoid(const glm::dvec3& center, const std::array<glm::dvec3, 3>& axes,
                                const PrimitiveLook& look) {
    double longest = 0;
    for (const glm::dvec3& axis : axes) longest = std::max(longest, glm::length(axis));
    if (!(longest > 0) || !std::isfinite(longest + center.x + center.y + center.z)) return;
    const std::uint32_t number = numberLook(look), base = static_cast<std::uint32_t>(solids_.positions.size());
    const UnitSphere& sphere = unitSphere();
    const auto finest = static_cast<std::size_t>(detail_);
    // Normals use the inverse transpose: the cofactors, up to a factor.
    const std::array<glm::dvec3, 3> normals{glm::cross(axes[1], axes[2]), glm::cross(axes[2], axes[0]),
                                            glm::cross(axes[0], axes[1])};
    const double side = glm::dot(axes[0], normals[0]) < 0 ? -1 : 1;
    for (std::uint32_t i = 0; i < sphere.levels[finest].vertices; ++i) {
        const glm::dvec3& p = sphere.points[i];
        const glm::dvec3 normal = (normals[0] * p.x + normals[1] * p.y + normals[2] * p.z) * side;
        const double length = glm::length(normal);
        addVertex(solids_, center - scene_.center + axes[0] * p.x + axes[1] * p.y + axes[2] * p.z,
                  length > 0 ? normal / length : glm::dvec3(0, 0, 1), number);
    }
    const auto put = [&](const std::vector<glm::uvec3>& triangles, std::vector<glm::uvec3>& to) {
        for (const glm::uvec3& t : triangles)
            to.emplace_back(base + t.x, base + (side < 0 ? t.z : t.y), base + (side < 0 ? t.y : t.z));
    };
    put(sphere.levels[finest].triangles, solids_.triangles);
    for (MeshLevel& level : solids_.coarser) {
        std::size_t detail = 0;
        while (detail < finest && sphere.levels[detail].error * longest > static_cast<double>(level.error)) ++detail;
        put(sphere.levels[detail].triangles, level.triangles);
    }
}

void PrimitiveMeshes::sector(const Primitives::Ellipse& e) {
    const glm::dvec3 normal = unitOr(glm::cross(e.major, e.minor), {});
    const double turn = e.end - e.start;
    if (normal == glm::dvec3() || !std::isfinite(turn) || turn == 0) return;
    const double full = std::clamp(turn, -2 * std::numbers::pi, 2 * std::numbers::pi);
    const int sides =
        std::max(1, static_cast<int>(std::ceil(2 * kRoundSides * std::abs(full) / (2 * std::numbers::pi))));
    const std::uint32_t number = numberLook(e.look);
    const std::size_t first = solids_.triangles.size();
    const glm::dvec3 center = e.center - scene_.center;
    const std::uint32_t middle = addVertex(solids_, center, normal, number);
    for (int i = 0; i <= sides; ++i) {
        const double t = e.start + full * i / sides;
        const std::uint32_t rim =
            addVertex(solids_, center + e.major * std::cos(t) + e.minor * std::sin(t), normal, number);
        if (i > 0) solids_.triangles.emplace_back(middle, full > 0 ? rim - 1 : rim, full > 0 ? rim : rim - 1);
    }
    toAllLevels(first);
}

void PrimitiveMeshes::boxFaces(const std::function<glm::dvec3(unsigned)>& corner, const PrimitiveLook& look) {
    const std::uint32_t number = numberLook(look);
    const std::size_t first = solids_.triangles.size();
    const glm::dvec3 middle = (corner(0) + corner(7)) / 2.0;
    for (unsigned axis = 0; axis < 3; ++axis)
        for (const unsigned end : {0u, 1u}) {
            const unsigned u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3, from = end << axis;
            const std::array<glm::dvec3, 4> at{corner(from), corner(from | u), corner(from | u | v), corner(from | v)};
            glm::dvec3 normal = unitOr(glm::cross(at[1] - at[0], at[3] - at[0]), {});
            if (normal == glm::dvec3()) continue;
            const bool outward = glm::dot(normal, (at[0] + at[2]) / 2.0 - middle) >= 0;
            if (!outward) normal = -normal;
            const auto base = static_cast<std::uint32_t>(solids_.positions.size());
            for (const glm::dvec3& p : at) addVertex(solids_, p - scene_.center, normal, number);
            for (const glm::uvec3& t : {glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3)})
                solids_.triangles.emplace_back(base + t.x, base + (outward ? t.y : t.z), base + (outward ? t.z : t.y));
        }
    toAllLevels(first);
}

void PrimitiveMeshes::mesh(const Primitives::Mesh& given) {
    const std::size_t points = given.positions.size(), triangles = given.triangles.size();
    if (triangles == 0) return;
    const bool one = given.looks.size() == 1, perTriangle = hasLooksOfTriangles(given);
    if (!one && !perTriangle && given.looks.size() != points)
        throw Error("cannot draw mesh", "",
                    "it has " + std::to_string(given.looks.size()) + " colours for " + std::to_string(triangles) +
                        " triangles and " + std::to_string(points) + " vertices");
    Mesh mesh;
    scene_.blendsColors |= given.blends && !one;
    std::vector<std::uint32_t> numbers;
    if (given.blends && !one)
        for (const PrimitiveLook& look : given.looks) numbers.push_back(numberLook(look));
    const auto findLook = [&](std::size_t triangle, std::uint32_t vertex) {
        return !numbers.empty() ? numbers[vertex] : numberLook(given.looks[one ? 0 : perTriangle ? triangle : vertex]);
    };
    std::vector<glm::dvec3> means(given.smooth ? points : 0);
    const auto faceNormal = [&](const std::array<std::uint32_t, 3>& t) {
        const glm::dvec3& a = given.positions[t[0]];
        return glm::cross(given.positions[t[1]] - a, given.positions[t[2]] - a);  // weighted by area
    };
    for (const auto& t : given.triangles)
        for (const std::uint32_t v : t)
            if (v >= points)
                throw Error(
                    "cannot draw mesh", "",
                    "a triangle names vertex " + std::to_string(v) + ", but there are " + std::to_string(points));
    if (given.smooth)
        for (const auto& t : given.triangles)
            for (const std::uint32_t v : t) means[v] += faceNormal(t);
    for (std::size_t i = 0; i < triangles; ++i) {
        const auto& t = given.triangles[i];
        const glm::dvec3 flat = unitOr(faceNormal(t), {0, 0, 1});
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const std::uint32_t v : t)
            addVertex(mesh, given.positions[v] - scene_.center, given.smooth ? unitOr(means[v], flat) : flat,
                      findLook(i, v));
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    append(mesh);
}

void PrimitiveMeshes::append(const Mesh& mesh) {
    appendMesh(
        mesh, {},
        [&](std::uint32_t number) {
            const PrimitiveLook& look = looks_[number];
            return SphereLook{withOpacity(look.color, look.opacity), look.note};
        },
        scene_);
    scene_.meshes.back().closed = false;  // a file may orient its triangles inwards
}

void PrimitiveMeshes::finish() {
    if (!solids_.triangles.empty()) {
        dropFineLevels(solids_);
        append(solids_);
    }
    scene_.radius = std::max(scene_.radius, meshReach(scene_));
}

}  // namespace nacre
