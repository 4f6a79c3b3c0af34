#include "engine/scene/build/primitives.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <numbers>

#include "engine/error.h"
#include "engine/scene/build/crowd.h"
#include "engine/scene/build/primitive_meshes.h"
#include "engine/scene/build/representation.h"

namespace nacre {
namespace {

bool isFinite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// Visits the dashes between two points; the whole line without dashes.
template <typename Visit>
void eachDash(const glm::dvec3& a, const glm::dvec3& b, const PrimitiveDashes& dashes, const Visit& visit) {
    constexpr double kMostDashes = 2000;
    const double length = glm::distance(a, b);
    if (!(length > 0)) return;
    if (!dashes.any()) return visit(a, b);
    const double period = dashes.dash + dashes.gap;
    const double count = std::clamp(std::round(length / period), 1.0, kMostDashes);
    const double share = dashes.dash / period;
    for (int i = 0; i < static_cast<int>(count); ++i)
        visit(glm::mix(a, b, (i + (1 - share) / 2) / count), glm::mix(a, b, (i + (1 + share) / 2) / count));
}

/// Adds primitives to a scene's streams.
class Placing {
public:
    Placing(const Primitives& primitives, Representation& scene)
        : all_(primitives), scene_(scene), meshes_(scene, primitives) {}

    void run() {
        for (const Primitives::Line& line : all_.lines) add(line);
        for (const Primitives::Arrow& arrow : all_.arrows) add(arrow);
        for (const Primitives::Ball& ball : all_.balls) add(ball);
        for (const Primitives::Ellipsoid& e : all_.ellipsoids) meshes_.ellipsoid(e.center, e.axes, e.look);
        for (const Primitives::Ellipse& ellipse : all_.ellipses) meshes_.sector(ellipse);
        for (const Primitives::Box& box : all_.boxes) add(box);
        for (const Primitives::Mesh& mesh : all_.meshes) add(mesh);
        meshes_.finish();
    }

private:
    glm::vec3 fromCenter(const glm::dvec3& p) const { return glm::vec3(p - scene_.center); }
    static bool isOpaque(const PrimitiveLook& look) { return look.opacity >= 1; }

    /// Dashes may multiply primitives.
    void checkRoom() const {
        constexpr std::size_t kMostPieces = 4 * kMostPrimitives;
        if (scene_.wires.size() + scene_.cylinders.size() >= kMostPieces)
            throw Error("cannot draw primitives", "",
                        "they have more than " + std::to_string(kMostPieces) + " dashes or lines");
    }

    void wire(const glm::dvec3& a, const glm::dvec3& b, double width, const PrimitiveLook& look) {
        checkRoom();
        if (!isFinite(a) || !isFinite(b) || fromCenter(a) == fromCenter(b)) return;
        scene_.wires.push_back({fromCenter(a), static_cast<float>(-width / 2), fromCenter(b), 0});
        scene_.wireLooks.push_back({look.color, look.color, look.note, look.note});
        reach(a, 0), reach(b, 0);
    }

    void stick(const glm::dvec3& a, const glm::dvec3& b, double radius, const PrimitiveLook& look) {
        if (!isFinite(a) || !isFinite(b) || !(radius > 0) || fromCenter(a) == fromCenter(b)) return;
        checkRoom();
        reach(a, radius), reach(b, radius);
        if (!isOpaque(look)) return meshes_.cylinder(a, b, radius, look);
        scene_.cylinders.push_back({fromCenter(a), static_cast<float>(radius), fromCenter(b), 0});
        scene_.cylinderLooks.push_back({look.color, look.color, look.note, look.note});
    }

    void add(const Primitives::Line& line) {
        if (!isFinite(line.a) || !isFinite(line.b)) return;
        eachDash(line.a, line.b, line.dashes, [&](const glm::dvec3& a, const glm::dvec3& b) {
            line.radius > 0 ? stick(a, b, line.radius, line.look) : wire(a, b, line.width, line.look);
        });
    }

    void add(const Primitives::Arrow& arrow) {
        const glm::dvec3 way = arrow.to - arrow.from;
        const double length = glm::length(way);
        if (!(length > 0) || !std::isfinite(length)) return;
        const int heads = int{arrow.headAtFrom} + int{arrow.headAtTo};
        const double head = std::min(arrow.headLength, length / std::max(heads, 1));
        const glm::dvec3 inset = way * (head / length);
        const glm::dvec3 from = arrow.headAtFrom ? arrow.from + inset : arrow.from,
                         to = arrow.headAtTo ? arrow.to - inset : arrow.to;
        eachDash(from, to, arrow.dashes,
                 [&](const glm::dvec3& a, const glm::dvec3& b) { stick(a, b, arrow.radius, arrow.look); });
        if (arrow.headAtFrom) cone(from, arrow.from, arrow);
        if (arrow.headAtTo) cone(to, arrow.to, arrow);
    }

    void cone(const glm::dvec3& base, const glm::dvec3& tip, const Primitives::Arrow& arrow) {
        if (!(arrow.headRadius > 0)) return;
        reach(base, arrow.headRadius), reach(tip, 0);
        meshes_.cone(base, tip, arrow.headRadius, arrow.look);
    }

    void add(const Primitives::Ball& ball) {
        if (!isFinite(ball.center) || !(ball.radius > 0)) return;
        if (!isOpaque(ball.look)) {
            const double r = ball.radius;
            return meshes_.ellipsoid(ball.center, {{{r, 0, 0}, {0, r, 0}, {0, 0, r}}}, ball.look);
        }
        reach(ball.center, ball.radius);
        scene_.spheres.push_back({fromCenter(ball.center), static_cast<float>(ball.radius)});
        scene_.sphereLooks.push_back({ball.look.color, ball.look.note});
    }

    void add(const Primitives::Box& box) {
        const auto corner = [&](unsigned bits) {
            glm::dvec3 p = box.center;
            for (unsigned axis = 0; axis < 3; ++axis) p += box.axes[axis] * (bits >> axis & 1 ? 1.0 : -1.0);
            return p;
        };
        if (box.faces) meshes_.boxFaces(corner, *box.faces);
        if (!box.edges) return;
        for (unsigned axis = 0; axis < 3; ++axis)
            for (unsigned bits = 0; bits < 8; ++bits) {
                if (bits >> axis & 1) continue;
                const glm::dvec3 a = corner(bits), b = corner(bits | 1u << axis);
                box.edgeRadius > 0 ? stick(a, b, box.edgeRadius, *box.edges) : wire(a, b, box.edgeWidth, *box.edges);
            }
        // Sticks meet in balls.
        for (unsigned bits = 0; bits < 8 && box.edgeRadius > 0; ++bits)
            add(Primitives::Ball{corner(bits), box.edgeRadius, *box.edges});
    }

    void add(const Primitives::Mesh& mesh) {
        if (mesh.faces) meshes_.mesh(mesh);
        if (!mesh.wires) return;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (const auto& [a, b, c] : mesh.triangles)
            for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) edges.push_back(std::minmax(from, to));
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        for (const auto& [from, to] : edges)
            if (std::max(from, to) < mesh.positions.size())
                wire(mesh.positions[from], mesh.positions[to], mesh.wireWidth, *mesh.wires);
    }

    void reach(const glm::dvec3& p, double radius) {
        scene_.radius = std::max(scene_.radius, glm::length(p - scene_.center) + radius);
    }

    const Primitives& all_;
    Representation& scene_;
    PrimitiveMeshes meshes_;
};

/// Visits points and radii that bound all drawn primitives.
template <typename Visit>
void eachBall(const Primitives& all, const Visit& visit) {
    for (const auto& l : all.lines) visit(l.a, l.radius), visit(l.b, l.radius);
    for (const auto& a : all.arrows)
        for (const glm::dvec3& p : {a.from, a.to}) visit(p, std::max(a.radius, a.headRadius));
    for (const auto& b : all.balls) visit(b.center, b.radius);
    for (const auto& e : all.ellipsoids) {
        double longest = 0;
        for (const glm::dvec3& axis : e.axes) longest = std::max(longest, glm::length(axis));
        visit(e.center, longest);
    }
    for (const auto& e : all.ellipses) visit(e.center, std::max(glm::length(e.major), glm::length(e.minor)));
    for (const auto& b : all.boxes)
        for (unsigned bits = 0; bits < 8; ++bits) {
            glm::dvec3 p = b.center;
            for (unsigned axis = 0; axis < 3; ++axis) p += b.axes[axis] * (bits >> axis & 1 ? 1.0 : -1.0);
            visit(p, b.edges ? b.edgeRadius : 0.0);
        }
    for (const auto& m : all.meshes)
        for (const glm::dvec3& p : m.positions) visit(p, 0.0);
    for (const auto& l : all.labels) visit(l.at, 0.0);
}

std::string number(std::size_t count) { return std::to_string(count); }

void checkPrimitives(const Primitives& all) {
    const std::size_t count = all.lines.size() + all.arrows.size() + all.balls.size() + all.ellipsoids.size() +
                              all.ellipses.size() + all.boxes.size() + all.meshes.size() + all.labels.size();
    if (count > kMostPrimitives)
        throw Error("cannot draw primitives", "",
                    number(count) + " of them are more than the limit of " + number(kMostPrimitives));
    std::size_t triangles = 0;
    for (const Primitives::Mesh& mesh : all.meshes) triangles += mesh.triangles.size();
    if (triangles > kMostPrimitiveTriangles)
        throw Error("cannot draw primitives", "",
                    "meshes of " + number(triangles) + " triangles are more than the limit of " +
                        number(kMostPrimitiveTriangles));
    eachBall(all, [](const glm::dvec3& p, double radius) {
        const double far = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) + radius;
        if (std::isfinite(far) && far > kFarthestPrimitive)
            throw Error("cannot draw primitives", "",
                        "one reaches " + number(static_cast<std::size_t>(std::min(far, 1e18))) +
                            " Å from the origin, farther than the limit of 1000000 Å");
    });
}

template <typename List>
void moveBehind(List& list, List& others) {
    list.insert(list.end(), std::make_move_iterator(others.begin()), std::make_move_iterator(others.end()));
}

}  // namespace

bool Primitives::empty() const {
    return lines.empty() && arrows.empty() && balls.empty() && ellipsoids.empty() && ellipses.empty() &&
           boxes.empty() && meshes.empty() && labels.empty();
}

void Primitives::append(Primitives others) {
    const auto before = static_cast<std::uint32_t>(notes.size());
    const auto shift = [&](PrimitiveLook& look) {
        if (look.note > 0) look.note += before;
    };
    for (Line& line : others.lines) shift(line.look);
    for (Arrow& arrow : others.arrows) shift(arrow.look);
    for (Ball& ball : others.balls) shift(ball.look);
    for (Ellipsoid& ellipsoid : others.ellipsoids) shift(ellipsoid.look);
    for (Ellipse& ellipse : others.ellipses) shift(ellipse.look);
    for (Box& box : others.boxes)
        for (std::optional<PrimitiveLook>* look : {&box.faces, &box.edges})
            if (*look) shift(**look);
    for (Mesh& mesh : others.meshes) {
        for (PrimitiveLook& look : mesh.looks) shift(look);
        if (mesh.wires) shift(*mesh.wires);
    }
    moveBehind(lines, others.lines);
    moveBehind(arrows, others.arrows);
    moveBehind(balls, others.balls);
    moveBehind(ellipsoids, others.ellipsoids);
    moveBehind(ellipses, others.ellipses);
    moveBehind(boxes, others.boxes);
    moveBehind(meshes, others.meshes);
    moveBehind(labels, others.labels);
    moveBehind(notes, others.notes);
}

std::optional<Bounds> computeBounds(const Primitives& primitives) {
    const Bounds bounds = boundsOfEach([&](const auto& visit) {
        eachBall(primitives, [&](const glm::dvec3& p, double radius) {
            if (isFinite(p) && std::isfinite(radius)) visit(p, radius);
        });
    });
    return std::isnan(bounds.center.x) ? std::nullopt : std::optional(bounds);
}

std::vector<glm::dvec4> outlinePoints(const Primitives& primitives) {
    std::vector<glm::dvec4> points;
    const auto add = [&](const glm::dvec3& p) {
        if (isFinite(p)) points.emplace_back(p, 0.0);
    };
    const auto disc = [&](const glm::dvec3& center, const glm::dvec3& axis, double radius) {
        const double length = glm::length(axis);
        if (!(length > 0) || !(radius > 0)) return add(center);
        const glm::dvec3 along = axis / length;
        const glm::dvec3 other = std::abs(along.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 u = glm::normalize(glm::cross(along, other)), v = glm::cross(along, u);
        for (int i = 0; i < 16; ++i) {
            const double turn = i * std::numbers::pi / 8;
            add(center + radius * (std::cos(turn) * u + std::sin(turn) * v));
        }
    };
    for (const Primitives::Line& line : primitives.lines)
        for (const glm::dvec3& end : {line.a, line.b}) disc(end, line.b - line.a, line.radius);
    for (const Primitives::Arrow& arrow : primitives.arrows) {
        const glm::dvec3 way = arrow.to - arrow.from;
        const double length = glm::length(way);
        const glm::dvec3 head = length > 0 ? way * (arrow.headLength / length) : way;
        arrow.headAtFrom ? (add(arrow.from), disc(arrow.from + head, way, arrow.headRadius))
                         : disc(arrow.from, way, arrow.radius);
        arrow.headAtTo ? (add(arrow.to), disc(arrow.to - head, way, arrow.headRadius))
                       : disc(arrow.to, way, arrow.radius);
    }
    const auto round = [&](const glm::dvec3& center, const std::array<glm::dvec3, 3>& axes) {
        for (int x = -2; x <= 2; ++x)
            for (int y = -2; y <= 2; ++y)
                for (int z = -2; z <= 2; ++z) {
                    const glm::dvec3 way(x, y, z);
                    if (way == glm::dvec3(0)) continue;
                    // Point where a plane perpendicular to `way` touches.
                    const glm::dvec3 share(glm::dot(axes[0], way), glm::dot(axes[1], way), glm::dot(axes[2], way));
                    const double length = glm::length(share);
                    if (length > 0) add(center + (axes[0] * share.x + axes[1] * share.y + axes[2] * share.z) / length);
                }
    };
    for (const Primitives::Ball& ball : primitives.balls)
        round(ball.center,
              {glm::dvec3(ball.radius, 0, 0), glm::dvec3(0, ball.radius, 0), glm::dvec3(0, 0, ball.radius)});
    for (const Primitives::Ellipsoid& ellipsoid : primitives.ellipsoids) round(ellipsoid.center, ellipsoid.axes);
    for (const Primitives::Ellipse& ellipse : primitives.ellipses) {
        add(ellipse.center);
        for (int i = 0; i <= 64; ++i) {
            const double turn = ellipse.start + (ellipse.end - ellipse.start) * i / 64;
            add(ellipse.center + std::cos(turn) * ellipse.major + std::sin(turn) * ellipse.minor);
        }
    }
    for (const Primitives::Box& box : primitives.boxes)
        for (int corner = 0; corner < 8; ++corner)
            add(box.center + (corner & 1 ? 1.0 : -1.0) * box.axes[0] + (corner & 2 ? 1.0 : -1.0) * box.axes[1] +
                (corner & 4 ? 1.0 : -1.0) * box.axes[2]);
    for (const Primitives::Mesh& mesh : primitives.meshes)
        for (const glm::dvec3& p : mesh.positions) add(p);
    return points;
}

void addPrimitives(const Primitives& primitives, Representation& scene) {
    checkPrimitives(primitives);
    Placing(primitives, scene).run();
    refuseCrowd(scene);
}

}  // namespace nacre
