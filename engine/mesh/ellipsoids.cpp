#include "engine/mesh/ellipsoids.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <string>

#include "engine/error.h"
#include "engine/mesh/solids.h"

namespace nacre {
namespace {

constexpr int kFinestPieces = 32, kFewestPieces = 4, kCoarsestPieces = 2;

constexpr std::size_t trianglesPerEllipsoid(int pieces) {
    const auto n = static_cast<std::size_t>(pieces);
    return 8 * n * n + 12 * 2 * n + 6 * 2;
}

/// Calls visit(a, b, c) with the corners of an octant's triangles: places (i, j) along two of its sides.
template <typename Visit>
void eachOctantTriangle(int pieces, int step, const Visit& visit) {
    const int count = pieces / step;
    for (int a = 0; a < count; ++a)
        for (int b = 0; a + b < count; ++b) {
            const auto at = [&](int i, int j) { return glm::ivec2(i, j) * step; };
            visit(at(a, b), at(a + 1, b), at(a, b + 1));
            if (a + b + 1 < count) visit(at(a + 1, b), at(a + 1, b + 1), at(a, b + 1));
        }
}

/// Adds the mesh of one ellipsoid: eight octants, twelve strips of bands between them, and six squares where bands
/// cross.
class EllipsoidMaker {
public:
    EllipsoidMaker(Mesh& mesh, const Ellipsoid& ellipsoid, const glm::dvec3& origin, int pieces)
        : mesh_(mesh), it_(ellipsoid), center_(ellipsoid.center - origin), pieces_(pieces) {
        constexpr double kHalfWidth = 0.045, kWidest = 0.2;  // of a band: of the mean axis; of an axis across it
        for (std::size_t i = 0; i < 3; ++i) lengths_[static_cast<int>(i)] = glm::length(it_.axes[i]);
        const double mean = std::cbrt(lengths_.x * lengths_.y * lengths_.z);
        half_ = glm::min(kHalfWidth * mean / lengths_, glm::dvec3(kWidest));
    }

    void add() {
        for (int octant = 0; octant < 8; ++octant) addOctant(octantSigns(octant));
        for (int axis = 0; axis < 3; ++axis) {
            for (int quarter = 0; quarter < 4; ++quarter) addStrip(axis, quarter & 1 ? -1 : 1, quarter & 2 ? -1 : 1);
            for (const double end : {1.0, -1.0}) addCrossing(axis, end);
        }
    }

private:
    static glm::dvec3 octantSigns(int octant) {
        return {octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1};
    }

    /// A point of the first octant beyond the bands, on the unit sphere.
    glm::dvec3 point(const glm::dvec3& parts) const {
        const glm::dvec3 way = glm::normalize(parts);
        const double along = glm::dot(half_, way);
        return half_ + way * (std::sqrt(along * along + 1 - glm::dot(half_, half_)) - along);
    }

    std::uint32_t vertex(const glm::dvec3& p, bool band) {
        glm::dvec3 place = center_, normal(0);
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3& axis = it_.axes[static_cast<std::size_t>(i)];
            place += axis * p[i];
            normal += axis * (p[i] / (lengths_[i] * lengths_[i]));
        }
        return addVertex(mesh_, place, glm::normalize(normal), band ? it_.atom | kEllipsoidBand : it_.atom);
    }

    /// @param face  counter-clockwise from outside if `outward`
    static void put(std::vector<glm::uvec3>& to, const glm::uvec3& face, bool outward) {
        to.push_back(outward ? face : glm::uvec3(face.x, face.z, face.y));
    }
    /// Calls add(triangles, step) for the mesh and each level, with its step between vertices.
    template <typename Add>
    void eachLevel(const Add& add) {
        add(mesh_.triangles, 1);
        for (std::size_t i = 0; i < mesh_.coarser.size(); ++i) add(mesh_.coarser[i].triangles, 2 << i);
    }

    void addOctant(const glm::dvec3& signs) {
        std::vector<std::uint32_t> firstOfRow;
        for (int i = 0; i <= pieces_; ++i)
            for (int j = 0; i + j <= pieces_; ++j) {
                const std::uint32_t index = vertex(signs * point({i, j, pieces_ - i - j}), false);
                if (j == 0) firstOfRow.push_back(index);
            }
        const auto at = [&](const glm::ivec2& p) {
            return firstOfRow[static_cast<std::size_t>(p.x)] + static_cast<std::uint32_t>(p.y);
        };
        const bool outward = signs.x * signs.y * signs.z > 0;
        eachLevel([&](std::vector<glm::uvec3>& triangles, int step) {
            eachOctantTriangle(pieces_, step, [&](const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c) {
                put(triangles, {at(a), at(b), at(c)}, outward);
            });
        });
    }

    /// The part of the band across an axis between two others, in their quarter.
    void addStrip(int axis, double signU, double signV) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (int i = 0; i <= pieces_; ++i) {
            glm::dvec3 parts(0), signs(1);
            parts[u] = i;
            parts[v] = pieces_ - i;
            signs[u] = signU;
            signs[v] = signV;
            const glm::dvec3 edge = point(parts);
            vertex(edge * signs, true);
            signs[axis] = -1;
            vertex(edge * signs, true);
        }
        const bool outward = signU * signV > 0;
        eachLevel([&](std::vector<glm::uvec3>& triangles, int step) {
            for (int i = 0; i < pieces_; i += step) {
                const std::uint32_t a = first + 2 * static_cast<std::uint32_t>(i),
                                    b = a + 2 * static_cast<std::uint32_t>(step);
                put(triangles, {a, b, b + 1}, outward);
                put(triangles, {a, b + 1, a + 1}, outward);
            }
        });
    }

    /// Where two bands cross at the end of an axis.
    void addCrossing(int axis, double end) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        glm::dvec3 parts(0);
        parts[axis] = 1;
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (int corner = 0; corner < 4; ++corner) {
            glm::dvec3 signs(1);
            signs[axis] = end;
            signs[u] = corner == 1 || corner == 2 ? -1 : 1;
            signs[v] = corner >= 2 ? -1 : 1;
            vertex(point(parts) * signs, true);
        }
        eachLevel([&](std::vector<glm::uvec3>& triangles, int) {
            put(triangles, {first, first + 1, first + 2}, end > 0);
            put(triangles, {first, first + 2, first + 3}, end > 0);
        });
    }

    Mesh& mesh_;
    const Ellipsoid& it_;
    glm::dvec3 center_;
    int pieces_;
    glm::dvec3 lengths_{}, half_{};  ///< half the widths of bands, of their axes
};

}  // namespace

int ellipsoidPieces(std::size_t count) {
    constexpr std::size_t kAimed = 2'000'000;
    int pieces = kFinestPieces;
    while (pieces > kFewestPieces && count * trianglesPerEllipsoid(pieces) > kAimed) pieces /= 2;
    return pieces;
}

double ellipsoidMeshError(int pieces) {
    double nearest = 1;
    eachOctantTriangle(pieces, 1, [&](const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c) {
        const auto at = [&](const glm::ivec2& p) { return glm::normalize(glm::dvec3(p.x, p.y, pieces - p.x - p.y)); };
        nearest = std::min(nearest, glm::dot(at(a), glm::normalize(glm::cross(at(b) - at(a), at(c) - at(a)))));
    });
    return 1 - nearest;
}

Mesh ellipsoidMesh(std::span<const Ellipsoid> ellipsoids, const glm::dvec3& origin, std::size_t all) {
    const std::size_t count = std::max(ellipsoids.size(), all);
    if (count > kMostEllipsoids)
        throw Error("cannot mesh ellipsoids", "",
                    std::to_string(count) + " are more than the limit of " + std::to_string(kMostEllipsoids) +
                        " (--show SEL=ellipsoids draws fewer)");
    Mesh mesh;
    double longest = 0;
    for (const Ellipsoid& each : ellipsoids)
        for (const glm::dvec3& axis : each.axes) longest = std::max(longest, glm::length(axis));
    const int pieces = ellipsoidPieces(count);
    for (int coarser = pieces / 2; coarser >= kCoarsestPieces; coarser /= 2)
        mesh.coarser.push_back({static_cast<float>(ellipsoidMeshError(coarser) * longest), {}});
    for (const Ellipsoid& each : ellipsoids) EllipsoidMaker(mesh, each, origin, pieces).add();
    return mesh;
}

}  // namespace nacre
