#include "engine/mesh/ellipsoids.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <string>
#include <utility>

#include "engine/error.h"
#include "engine/mesh/solids.h"

namespace nacre {
namespace {

constexpr int kFinestPieces = 32, kFewestPieces = 4, kCoarsestPieces = 2;
constexpr int kCutLines = 4;  // on each face of a cut, beside the one along its edge

constexpr std::size_t trianglesPerEllipsoid(int pieces) {
    const auto n = static_cast<std::size_t>(pieces);
    return 8 * n * n + 12 * 4 * n + 6 * 8;
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

/// The same ellipsoid, right-handed, with axes that point into the octant to be cut out.
Ellipsoid pointedIntoCut(Ellipsoid ellipsoid) {
    if (!ellipsoid.cut) return ellipsoid;
    auto& axes = ellipsoid.axes;
    for (std::size_t i = 0; i < 3; ++i) axes[i] *= (*ellipsoid.cut)[static_cast<int>(i)];
    if (glm::dot(glm::cross(axes[0], axes[1]), axes[2]) < 0) std::swap(axes[0], axes[1]);
    return ellipsoid;
}

/// Adds the mesh of one ellipsoid: eight octants, twelve strips of bands between them, and six squares where bands
/// cross. A cut leaves seven octants, halves of three strips and three quarters of three squares, and adds three faces.
class EllipsoidMaker {
public:
    EllipsoidMaker(Mesh& mesh, const Ellipsoid& ellipsoid, const glm::dvec3& origin, int pieces)
        : mesh_(mesh), it_(pointedIntoCut(ellipsoid)), center_(ellipsoid.center - origin), pieces_(pieces) {
        constexpr double kHalfWidth = 0.045, kWidest = 0.2;  // of a band: of the mean axis; of an axis across it
        for (std::size_t i = 0; i < 3; ++i) lengths_[static_cast<int>(i)] = glm::length(it_.axes[i]);
        const double mean = std::cbrt(lengths_.x * lengths_.y * lengths_.z);
        half_ = glm::min(kHalfWidth * mean / lengths_, glm::dvec3(kWidest));
        for (int axis = 0; it_.cut && axis < 3; ++axis) placeLines(axis, mean);
        for (int axis = 0; axis < 3; ++axis) layRim(axis);
    }

    void add() {
        for (int octant = it_.cut ? 1 : 0; octant < 8; ++octant) addOctant(octantSigns(octant));
        for (int axis = 0; axis < 3; ++axis) {
            for (int quarter = 0; quarter < 4; ++quarter) addStrip(axis, quarter & 1 ? -1 : 1, quarter & 2 ? -1 : 1);
            for (const double end : {1.0, -1.0}) addCrossing(axis, end);
            if (it_.cut) addFace(axis);
        }
    }

private:
    /// A point of a principal ellipse between the positive ends of two axes.
    struct RimPoint {
        glm::dvec3 place;  ///< on the unit sphere
        int number = 0;    ///< from the second axis, of the band's vertices; negative: a line on a face begins here
        bool isIn(int step) const { return number < 0 || number % step == 0; }
    };
    using Row = std::vector<std::pair<RimPoint, std::uint32_t>>;  ///< with indices of vertices

    static glm::dvec3 octantSigns(int octant) {
        return {octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1};
    }

    /// A point of the first octant beyond the bands, on the unit sphere.
    glm::dvec3 point(const glm::dvec3& parts) const {
        const glm::dvec3 way = glm::normalize(parts);
        const double along = glm::dot(half_, way);
        return half_ + way * (std::sqrt(along * along + 1 - glm::dot(half_, half_)) - along);
    }

    glm::dvec3 combined(const glm::dvec3& shares) const {
        return it_.axes[0] * shares.x + it_.axes[1] * shares.y + it_.axes[2] * shares.z;
    }
    std::uint32_t vertex(const glm::dvec3& p, bool band) {
        const glm::dvec3 gradient = combined(p / (lengths_ * lengths_));
        return addVertex(mesh_, center_ + combined(p), glm::normalize(gradient),
                         band ? it_.atom | kEllipsoidBand : it_.atom);
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

    /// The principal ellipse across an axis, from the first of the two others to the second.
    void layRim(int axis) {
        const int a = (axis + 1) % 3, b = (axis + 2) % 3;
        std::vector<RimPoint>& rim = rims_[static_cast<std::size_t>(axis)];
        for (const double share : borders_[static_cast<std::size_t>(a)]) {  // none without a cut
            glm::dvec3 place(0);
            place[a] = share;
            place[b] = std::sqrt(1 - share * share);
            rim.push_back({place, -1});
        }
        for (int i = 0; i <= pieces_; ++i) {
            glm::dvec3 parts(0);
            parts[a] = i;
            parts[b] = pieces_ - i;
            glm::dvec3 place = point(parts);
            place[axis] = 0;
            rim.push_back({glm::normalize(place), i});
        }
        std::ranges::sort(rim, std::greater(), [a](const RimPoint& p) { return p.place[a]; });
    }
    const std::vector<RimPoint>& rim(int axis) const { return rims_[static_cast<std::size_t>(axis)]; }
    std::size_t findOnRim(int axis, int number) const {
        return static_cast<std::size_t>(std::ranges::find(rim(axis), number, &RimPoint::number) - rim(axis).begin());
    }

    /// The part of the band across an axis between two others, in their quarter: two halves that meet on the ellipse.
    /// Beside a face there is one.
    void addStrip(int axis, double signU, double signV) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const bool cut = it_.cut && signU > 0 && signV > 0;
        glm::dvec3 signs(1);
        signs[u] = signU;
        signs[v] = signV;
        Row middle;
        const std::size_t end = findOnRim(axis, pieces_);
        for (std::size_t i = findOnRim(axis, 0) + 1; i-- > end;)
            if (const RimPoint& p = rim(axis)[i]; cut || p.number >= 0)
                middle.emplace_back(p, vertex(p.place * signs, true));
        for (const double side : {1.0, -1.0}) {
            if (cut && side > 0) continue;
            signs[axis] = side;
            std::vector<std::uint32_t> edge;
            for (int i = 0; i <= pieces_; ++i) {
                glm::dvec3 parts(0);
                parts[u] = i;
                parts[v] = pieces_ - i;
                edge.push_back(vertex(point(parts) * signs, true));
            }
            joinRows(middle, edge, signU * signV * side < 0);
        }
    }
    void joinRows(const Row& middle, const std::vector<std::uint32_t>& edge, bool outward) {
        eachLevel([&](std::vector<glm::uvec3>& triangles, int step) {
            std::uint32_t last = middle.front().second, regular = last;
            int from = 0;
            for (const auto& [p, index] : std::span(middle).subspan(1)) {
                if (!p.isIn(step)) continue;
                const std::uint32_t ahead = edge[static_cast<std::size_t>(from + step)];
                put(triangles, {last, index, ahead}, outward);
                last = index;
                if (p.number < 0) continue;
                put(triangles, {regular, ahead, edge[static_cast<std::size_t>(from)]}, outward);
                regular = index;
                from += step;
            }
        });
    }

    /// Where two bands cross at the end of an axis: triangles about the end. A cut takes a quarter of them.
    void addCrossing(int axis, double end) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const bool cut = it_.cut && end > 0;
        glm::dvec3 pole(0);
        pole[axis] = 1;
        const std::size_t alongU = findOnRim(v, pieces_), alongV = findOnRim(u, 0);
        const auto add = [&](const glm::dvec3& place, double signU, double signV) {
            glm::dvec3 signs(end);
            signs[u] = signU;
            signs[v] = signV;
            return vertex(place * signs, true);
        };
        const glm::dvec3 corner = point(pole), &onU = rim(v)[alongU].place, &onV = rim(u)[alongV].place;
        const std::uint32_t center = add(pole, 1, 1);
        const std::array<std::uint32_t, 8> ring{add(corner, 1, 1),  add(onV, 1, 1),      add(corner, -1, 1),
                                                add(onU, -1, 1),    add(corner, -1, -1), add(onV, 1, -1),
                                                add(corner, 1, -1), add(onU, 1, 1)};
        // The edges of the quarter that is cut, with what begins there.
        std::vector<std::uint32_t> in, out;
        if (cut) {
            for (std::size_t i = alongU + 1; i-- > 0;) in.push_back(add(rim(v)[i].place, 1, 1));
            for (std::size_t i = rim(u).size(); i-- > alongV;) out.push_back(add(rim(u)[i].place, 1, 1));
        }
        const auto fan = [&](std::vector<glm::uvec3>& triangles, std::uint32_t from,
                             const std::vector<std::uint32_t>& row) {
            for (std::size_t i = 0; i + 1 < row.size(); ++i) put(triangles, {from, row[i], row[i + 1]}, true);
        };
        eachLevel([&](std::vector<glm::uvec3>& triangles, int) {
            for (std::size_t i = cut ? 2 : 0; i < (cut ? 6u : 8u); ++i)
                put(triangles, {center, ring[i], ring[(i + 1) % 8]}, end > 0);
            fan(triangles, ring[6], in);
            fan(triangles, ring[2], out);
        });
    }

    // --- The cut: its axes are positive

    /// Borders of the lines across an axis, of its length: even ones begin a line.
    void placeLines(int axis, double mean) {
        constexpr double kHalfWidth = 0.03, kWidest = 0.2;  // of the mean axis; of the distance between lines
        constexpr double kApart = 1.0 / (kCutLines + 1);
        const double half = std::min(kHalfWidth * mean / lengths_[axis], kWidest * kApart);
        std::vector<double>& borders = borders_[static_cast<std::size_t>(axis)];
        borders = {0, 2 * half};
        for (int line = 1; line <= kCutLines; ++line)
            for (const double side : {-half, half}) borders.push_back(line * kApart + side);
        borders.push_back(1);
    }

    /// The face across an axis: slices between the borders along the first of the two others, alternately a line and
    /// the space to the next.
    void addFace(int axis) {
        const int a = (axis + 1) % 3, b = (axis + 2) % 3;
        const glm::dvec3 normal = it_.axes[static_cast<std::size_t>(axis)] / lengths_[axis];
        const auto on = [](int along, double share) {
            glm::dvec3 place(0);
            place[along] = share;
            return RimPoint{place, -1};
        };
        const std::vector<double>&borders = borders_[static_cast<std::size_t>(a)],
              &others = borders_[static_cast<std::size_t>(b)];
        for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
            std::vector<RimPoint> outline{on(a, borders[i + 1])};
            for (const RimPoint& p : rim(axis))
                if (p.place[a] >= borders[i] && p.place[a] <= borders[i + 1] && p.place[b] > 0) outline.push_back(p);
            if (i == 0)  // the other face at this edge has its lines here
                for (std::size_t k = others.size() - 1; k-- > 1;) outline.push_back(on(b, others[k]));
            outline.push_back(on(a, borders[i]));
            const std::uint32_t look = it_.atom | (i % 2 == 0 ? kEllipsoidBand : kEllipsoidFace);
            std::vector<std::uint32_t> indices;
            for (const RimPoint& p : outline)
                indices.push_back(addVertex(mesh_, center_ + combined(p.place), normal, look));
            eachLevel([&](std::vector<glm::uvec3>& triangles, int step) {
                std::uint32_t last = indices[1];
                for (std::size_t k = 2; k < outline.size(); ++k) {
                    if (!outline[k].isIn(step)) continue;
                    put(triangles, {indices[0], last, indices[k]}, true);
                    last = indices[k];
                }
            });
        }
    }

    Mesh& mesh_;
    const Ellipsoid it_;
    glm::dvec3 center_;
    int pieces_;
    glm::dvec3 lengths_{}, half_{};  ///< half the widths of bands, of their axes
    // By axis.
    std::array<std::vector<RimPoint>, 3> rims_;
    std::array<std::vector<double>, 3> borders_;  ///< of a cut
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

Mesh ellipsoidMesh(std::span<const Ellipsoid> ellipsoids, const glm::dvec3& origin, std::size_t meshes) {
    const std::size_t count = ellipsoids.size() * meshes;
    if (count > kMostEllipsoids)
        throw Error("cannot draw ellipsoids", "",
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
