#include "engine/mesh/ellipsoids.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/mesh/solids.h"

namespace nacre {
namespace {

constexpr int kFinestPieces = 32, kFewestPieces = 4;

/// Adds the mesh of one ellipsoid: eight octants, twelve strips of bands between them, and six squares where bands
/// cross.
class EllipsoidMaker {
public:
    EllipsoidMaker(Mesh& mesh, const Ellipsoid& ellipsoid, int pieces, std::uint32_t own, std::uint32_t ofBands)
        : mesh_(mesh), it_(ellipsoid), pieces_(pieces), own_(own), ofBands_(ofBands) {
        constexpr double kWidest = 0.2;  // of an axis across the band
        for (std::size_t i = 0; i < 3; ++i) lengths_[static_cast<int>(i)] = glm::length(it_.axes[i]);
        half_ = glm::min(it_.band / lengths_, glm::dvec3(kWidest));
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
        glm::dvec3 place = it_.center, normal(0);
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3& axis = it_.axes[static_cast<std::size_t>(i)];
            place += axis * p[i];
            normal += axis * (p[i] / (lengths_[i] * lengths_[i]));
        }
        return addVertex(mesh_, place, glm::normalize(normal), band ? ofBands_ : own_);
    }

    /// @param face  counter-clockwise from outside if `outward`
    void put(const glm::uvec3& face, bool outward) {
        mesh_.triangles.push_back(outward ? face : glm::uvec3(face.x, face.z, face.y));
    }

    void addOctant(const glm::dvec3& signs) {
        std::vector<std::uint32_t> firstOfRow;
        for (int i = 0; i <= pieces_; ++i)
            for (int j = 0; i + j <= pieces_; ++j) {
                const std::uint32_t index = vertex(signs * point({i, j, pieces_ - i - j}), false);
                if (j == 0) firstOfRow.push_back(index);
            }
        const auto at = [&](int i, int j) {
            return firstOfRow[static_cast<std::size_t>(i)] + static_cast<std::uint32_t>(j);
        };
        const bool outward = signs.x * signs.y * signs.z > 0;
        for (int i = 0; i < pieces_; ++i)
            for (int j = 0; i + j < pieces_; ++j) {
                put({at(i, j), at(i + 1, j), at(i, j + 1)}, outward);
                if (i + j + 1 < pieces_) put({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, outward);
            }
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
        for (int i = 0; i < pieces_; ++i) {
            const std::uint32_t a = first + 2 * static_cast<std::uint32_t>(i), b = a + 2;
            put({a, b, b + 1}, outward);
            put({a, b + 1, a + 1}, outward);
        }
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
        put({first, first + 1, first + 2}, end > 0);
        put({first, first + 2, first + 3}, end > 0);
    }

    Mesh& mesh_;
    const Ellipsoid& it_;
    int pieces_;
    std::uint32_t own_, ofBands_;
    glm::dvec3 lengths_{}, half_{};  ///< half the widths of bands, of their axes
};

}  // namespace

void addEllipsoid(Mesh& mesh, const Ellipsoid& ellipsoid, int pieces, std::uint32_t own, std::uint32_t ofBands) {
    EllipsoidMaker(mesh, ellipsoid, pieces, own, ofBands).add();
}

std::size_t trianglesPerEllipsoid(int pieces) {
    const auto n = static_cast<std::size_t>(pieces);
    return 8 * n * n + 12 * 2 * n + 6 * 2;
}

int ellipsoidPieces(std::size_t count) {
    constexpr std::size_t kAimed = 2'000'000;
    int pieces = kFinestPieces;
    while (pieces > kFewestPieces && count * trianglesPerEllipsoid(pieces) > kAimed) pieces /= 2;
    return pieces;
}

}  // namespace nacre
