#include "engine/mesh/solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/mesh/mesh_levels.h"
#include "engine/mesh/unit_vectors.h"

namespace nacre {
namespace {

/// Rings of vertices about an axis, from begin to end, each connected to the previous one.
class Lathe {
public:
    Lathe(Mesh& mesh, const glm::dvec3& axis, int sides)
        : mesh_(mesh),
          axis_(axis),
          x_(anyAcross(axis)),
          y_(glm::cross(axis, x_)),
          sides_(sides),
          all_(allPicks(static_cast<std::size_t>(sides))) {}

    /// First end of the solid.
    void begin(const glm::dvec3& point, std::uint32_t atom) { pole_ = addVertex(mesh_, point, -axis_, atom); }

    /// @param latitude  of the normals: -pi/2 points back along the axis
    void ring(const glm::dvec3& center, double radius, double latitude, std::uint32_t atom) {
        const Ring ring{addRing(center, radius, latitude, atom), radius, true};
        join(mesh_.triangles, ring.first, all_);
        last_ = ring.first;
        rings_.push_back(ring);
    }

    /// Changes the atom at a ring.
    void change(const glm::dvec3& center, double radius, double latitude, std::uint32_t atom) {
        last_ = addRing(center, radius, latitude, atom);
        rings_.push_back({last_, radius, false});
    }

    void end(const glm::dvec3& point, std::uint32_t atom) {
        const std::uint32_t tip = addVertex(mesh_, point, axis_, atom);
        close(mesh_.triangles, tip, all_);
        for (MeshLevel& level : mesh_.coarser) addCoarser(level, tip);
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    using Triangles = std::vector<glm::uvec3>;

    struct Ring {
        std::uint32_t first = 0;  ///< vertex
        double radius = 0;
        bool joined = true;  ///< to the previous ring, or to the pole
    };

    std::uint32_t addRing(const glm::dvec3& center, double radius, double latitude, std::uint32_t atom) {
        const std::uint32_t first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (int j = 0; j < sides_; ++j) {
            const double angle = 2 * std::numbers::pi * j / sides_;
            const glm::dvec3 out = x_ * std::cos(angle) + y_ * std::sin(angle);
            addVertex(mesh_, center + out * radius, out * std::cos(latitude) + axis_ * std::sin(latitude), atom);
        }
        return first;
    }

    /// The wall from the last ring or the pole.
    void join(Triangles& triangles, std::uint32_t ring, const Picks& picks) const {
        for (std::size_t i = 0; i < picks.size(); ++i) {
            const std::uint32_t a = picks[i], b = picks[(i + 1) % picks.size()];
            if (last_ == kNone) {
                triangles.emplace_back(pole_, ring + b, ring + a);
                continue;
            }
            triangles.emplace_back(last_ + a, last_ + b, ring + b);
            triangles.emplace_back(last_ + a, ring + b, ring + a);
        }
    }

    void close(Triangles& triangles, std::uint32_t tip, const Picks& picks) const {
        for (std::size_t i = 0; i < picks.size(); ++i)
            triangles.emplace_back(last_ + picks[i], last_ + picks[(i + 1) % picks.size()], tip);
    }

    /// If the error allows it, a round end becomes flat, or a cone from its widest ring; else it keeps all rings. Parts
    /// narrower than the error become one cone, from the first wide ring to the tip, unless the atom changes in
    /// between.
    void addCoarser(MeshLevel& level, std::uint32_t tip) {
        double widest = 0;
        for (const Ring& ring : rings_) widest = std::max(widest, ring.radius);
        const double error = static_cast<double>(level.error), ofCone = kConeError * widest;
        const bool flat = widest <= error, cone = !flat && ofCone <= 0.5 * error;
        const bool spike = flat && std::all_of(rings_.begin(), rings_.end(), [](const Ring& r) { return r.joined; });
        const Picks picks = circlePicks(all_.size(), widest, cone ? error - ofCone : error);
        last_ = kNone;
        std::uint32_t first = kNone;
        for (const Ring& ring : rings_) {
            if ((flat || cone) && ring.radius < 0.999 * widest) continue;
            if (ring.joined && !(flat && last_ == kNone)) join(level.triangles, ring.first, picks);
            if (first == kNone) first = ring.first;
            last_ = ring.first;
            if (spike) break;
        }
        if (!flat || spike) close(level.triangles, tip, picks);
        if (!flat) return;
        for (std::size_t i = 1; i + 1 < picks.size(); ++i) {
            level.triangles.emplace_back(first + picks[0], first + picks[i + 1], first + picks[i]);
            if (!spike) level.triangles.emplace_back(last_ + picks[0], last_ + picks[i], last_ + picks[i + 1]);
        }
    }

    Mesh& mesh_;
    glm::dvec3 axis_, x_, y_;
    int sides_;
    Picks all_;
    std::uint32_t pole_ = kNone, last_ = kNone;  // ring
    std::vector<Ring> rings_;
};

}  // namespace

std::uint32_t addVertex(Mesh& mesh, const glm::dvec3& position, const glm::dvec3& normal, std::uint32_t atom) {
    mesh.positions.emplace_back(position);
    mesh.normals.emplace_back(normal);
    mesh.atoms.push_back(atom);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void addRod(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, double radius, std::uint32_t atomA,
            std::uint32_t atomB, int sides) {
    const glm::dvec3 axis = unitOr(b - a, glm::dvec3());
    if (axis == glm::dvec3()) return addBall(mesh, a, radius, atomA, sides);
    Lathe lathe(mesh, axis, sides);
    const int rings = sides / 4;  // from pole to equator
    lathe.begin(a - axis * radius, atomA);
    for (int i = 1; i <= rings; ++i) {
        const double latitude = std::numbers::pi / 2 * (static_cast<double>(i) / rings - 1);
        lathe.ring(a + axis * (radius * std::sin(latitude)), radius * std::cos(latitude), latitude, atomA);
    }
    if (atomA != atomB) {
        lathe.ring((a + b) / 2.0, radius, 0, atomA);
        lathe.change((a + b) / 2.0, radius, 0, atomB);
    }
    for (int i = 0; i < rings; ++i) {
        const double latitude = std::numbers::pi / 2 * i / rings;
        lathe.ring(b + axis * (radius * std::sin(latitude)), radius * std::cos(latitude), latitude, atomB);
    }
    lathe.end(b + axis * radius, atomB);
}

void addCylinder(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, double radius, std::uint32_t atomA,
                 std::uint32_t atomB, int sides) {
    const glm::dvec3 axis = unitOr(b - a, {});
    if (axis == glm::dvec3()) return;
    constexpr double kPole = std::numbers::pi / 2;
    Lathe lathe(mesh, axis, sides);
    lathe.begin(a, atomA);
    lathe.ring(a, radius, -kPole, atomA);
    lathe.change(a, radius, 0, atomA);
    if (atomA != atomB) {
        lathe.ring((a + b) / 2.0, radius, 0, atomA);
        lathe.change((a + b) / 2.0, radius, 0, atomB);
    }
    lathe.ring(b, radius, 0, atomB);
    lathe.change(b, radius, kPole, atomB);
    lathe.end(b, atomB);
}

void addBall(Mesh& mesh, const glm::dvec3& center, double radius, std::uint32_t atom, int sides) {
    const glm::dvec3 axis(0, 0, 1);
    Lathe lathe(mesh, axis, sides);
    lathe.begin(center - axis * radius, atom);
    for (int i = 1; i < sides / 2; ++i) {
        const double latitude = std::numbers::pi * (2.0 * i / sides - 0.5);
        lathe.ring(center + axis * (radius * std::sin(latitude)), radius * std::cos(latitude), latitude, atom);
    }
    lathe.end(center + axis * radius, atom);
}

namespace {

/// Corners of a plate by outline number, counter-clockwise. The upper side keeps every other one, the lower side the
/// rest. With an odd number of corners both sides keep the first.
Picks thinCorners(const std::vector<std::uint32_t>& fan) {
    Picks corners = fan;
    if (corners.size() % 2 == 1) corners.insert(corners.begin(), fan[0]);
    return corners;
}

/// Largest distance of a convex plate from the result of addThinPlate(): between a dropped corner and the edge of its
/// neighbours, or the same corner on the other side.
double thinError(std::span<const glm::dvec3> outline, const Picks& corners, double thickness) {
    double most = 0;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec3 &a = outline[corners[(i + n - 1) % n]], &b = outline[corners[(i + 1) % n]];
        const glm::dvec3 out = across(outline[corners[i]] - a, unitOr(b - a, {}));
        const double away = glm::length(out);
        most = std::max(most, thickness * away / std::sqrt(away * away + thickness * thickness));
    }
    return most;
}

/// An antiprism of a plate's corners.
/// @param first  first vertex of the upper corners, followed by the lower ones @param all  number of corners per side
void addThinPlate(std::vector<glm::uvec3>& triangles, std::uint32_t first, std::uint32_t all, const Picks& corners) {
    const std::size_t n = corners.size();
    const auto above = [&](std::size_t i) { return first + corners[i % n]; };
    const auto below = [&](std::size_t i) { return first + all + corners[i % n]; };
    for (std::size_t i = 2; i + 2 < n; i += 2) {
        triangles.emplace_back(above(0), above(i), above(i + 2));
        triangles.emplace_back(below(1), below(i + 3), below(i + 1));
    }
    for (std::size_t i = 0; i < n; i += 2) {
        triangles.emplace_back(above(i), below(i + 1), above(i + 2));
        triangles.emplace_back(below(i + 1), below(i + 3), above(i + 2));
    }
}

}  // namespace

void addPlate(Mesh& mesh, std::span<const glm::dvec3> outline, const glm::dvec3& normal, double halfThickness,
              std::span<const std::vector<std::uint32_t>> fans, std::uint32_t atom) {
    const glm::dvec3 up = normal * halfThickness;
    const auto before = static_cast<std::ptrdiff_t>(mesh.triangles.size());
    const std::size_t corners = mesh.positions.size();
    for (const bool top : {true, false}) {
        const std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::dvec3& p : outline) addVertex(mesh, top ? p + up : p - up, top ? normal : -normal, atom);
        for (const std::vector<std::uint32_t>& fan : fans)
            for (std::size_t i = 1; i + 1 < fan.size(); ++i)
                mesh.triangles.emplace_back(first + fan[0], first + fan[top ? i : i + 1], first + fan[top ? i + 1 : i]);
    }
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec3 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        const glm::dvec3 out = unitOr(glm::cross(b - a, normal), normal);
        const std::uint32_t first = addVertex(mesh, a - up, out, atom);
        for (const glm::dvec3& p : {b - up, b + up, a + up}) addVertex(mesh, p, out, atom);
        mesh.triangles.emplace_back(first, first + 1, first + 2);
        mesh.triangles.emplace_back(first, first + 2, first + 3);
    }
    double error = 0;
    for (const std::vector<std::uint32_t>& fan : fans)
        error = std::max(error, thinError(outline, thinCorners(fan), 2 * halfThickness));
    for (MeshLevel& level : mesh.coarser)
        if (error <= static_cast<double>(level.error))
            for (const std::vector<std::uint32_t>& fan : fans)
                addThinPlate(level.triangles, static_cast<std::uint32_t>(corners),
                             static_cast<std::uint32_t>(outline.size()), thinCorners(fan));
        else
            level.triangles.insert(level.triangles.end(), mesh.triangles.begin() + before, mesh.triangles.end());
}

}  // namespace nacre
