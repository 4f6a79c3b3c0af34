#include "engine/mesh/creases.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

#include "engine/mesh/ball_grid.h"
#include "engine/mesh/unit_vectors.h"

namespace nacre {
namespace {

using glm::dvec3;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr double kTouch = 1e-6;  // Å: what touches a ball is not inside it

class CreaseMaker {
public:
    CreaseMaker(Mesh& mesh, const std::vector<SurfaceBall>& balls, const dvec3& shift, double step)
        : mesh_(mesh), balls_(balls), grid_(balls, 0), shift_(shift), step_(step) {
        for (std::uint32_t i = 0; i < balls.size(); ++i) {
            ballOfAtom_[balls[i].atom] = i;
            widest_ = std::max(widest_, balls[i].radius);
        }
    }

    void make() {
        const std::vector<glm::uvec3> whole = std::move(mesh_.triangles);
        mesh_.triangles.clear();
        mesh_.triangles.reserve(whole.size());
        for (const glm::uvec3& t : whole) split(t);
    }

private:
    std::uint32_t ballOf(std::uint32_t vertex) const { return ballOfAtom_.at(mesh_.atoms[vertex]); }
    dvec3 placeOf(std::uint32_t vertex) const { return dvec3(mesh_.positions[vertex]) - shift_; }

    bool isCovered(const dvec3& place) const {
        bool covered = false;
        grid_.near(place, widest_, [&](std::uint32_t ball) {
            covered = covered || glm::distance(balls_[ball].center, place) < balls_[ball].radius - kTouch;
        });
        return covered;
    }

    /// Of two spheres that meet: their circle's centre, the unit vector from a to b, and its radius.
    struct Circle {
        dvec3 center{}, axis{};
        double radius = 0;
    };
    std::optional<Circle> circleOf(std::uint32_t a, std::uint32_t b) const {
        const SurfaceBall &one = balls_[a], &other = balls_[b];
        const dvec3 way = other.center - one.center;
        const double apart = glm::length(way);
        if (apart < kTouch) return std::nullopt;
        const double along = (apart * apart + one.radius * one.radius - other.radius * other.radius) / (2 * apart);
        const double squared = one.radius * one.radius - along * along;
        if (squared <= 0) return std::nullopt;
        const dvec3 axis = way / apart;
        return Circle{one.center + axis * along, axis, std::sqrt(squared)};
    }

    /// A vertex at a place of the crease, unless that is far from where it was looked for. Where another ball covers
    /// it, on that one, towards there.
    std::uint32_t vertexAt(dvec3 place, const dvec3& from, dvec3 normal, std::uint32_t atom) {
        if (!(glm::distance(place, from) <= step_)) return kNone;
        if (isCovered(place)) {
            const dvec3 way = unitOr(from - place, normal) * step_;
            const BallExit exit = exitOf(balls_, grid_, widest_, place, way);
            if (exit.ball == kNoSource || exit.share > 1) return kNone;
            place += way * exit.share;
            normal = unitOr(place - balls_[exit.ball].center, normal);
            atom = balls_[exit.ball].atom;
        }
        mesh_.positions.emplace_back(place + shift_);
        mesh_.normals.emplace_back(normal);
        mesh_.atoms.push_back(atom);
        return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
    }

    /// The vertex on the crease between an edge's ends, the same for both triangles that share it; none where there is
    /// no crease.
    std::uint32_t onEdge(std::uint32_t u, std::uint32_t v) {
        if (mesh_.atoms[u] == mesh_.atoms[v]) return kNone;
        const auto [entry, added] = edges_.try_emplace(std::uint64_t{std::min(u, v)} << 32 | std::max(u, v), kNone);
        if (!added) return entry->second;
        if (u > v) std::swap(u, v);
        const std::optional<Circle> circle = circleOf(ballOf(u), ballOf(v));
        if (!circle) return kNone;
        const dvec3 a = placeOf(u), b = placeOf(v);
        const double heightA = glm::dot(a - circle->center, circle->axis),
                     heightB = glm::dot(b - circle->center, circle->axis);
        const double share = heightA * heightB < 0 ? heightA / (heightA - heightB) : 0.5;
        const dvec3 from = a + (b - a) * share;
        const dvec3 out = unitOr(across(from - circle->center, circle->axis), dvec3());
        if (out == dvec3()) return kNone;
        const dvec3 normal = unitOr(dvec3(mesh_.normals[u]) + dvec3(mesh_.normals[v]), out);
        return entry->second = vertexAt(circle->center + out * circle->radius, from, normal, mesh_.atoms[u]);
    }

    /// The vertex where the spheres of a triangle's corners meet.
    std::uint32_t onCorner(const glm::uvec3& t) {
        const std::optional<Circle> circle = circleOf(ballOf(t.x), ballOf(t.y));
        if (!circle) return kNone;
        // Points of the circle that are on the third sphere: by how far they go towards its centre.
        const SurfaceBall& third = balls_[ballOf(t.z)];
        const dvec3 way = third.center - circle->center, aside = across(way, circle->axis);
        const double length = glm::length(aside);
        if (length < kTouch) return kNone;
        const double along =
            (glm::dot(way, way) + circle->radius * circle->radius - third.radius * third.radius) / (2 * length);
        const double squared = circle->radius * circle->radius - along * along;
        if (squared < 0) return kNone;
        const dvec3 from = (placeOf(t.x) + placeOf(t.y) + placeOf(t.z)) / 3.0;
        const dvec3 base = circle->center + aside / length * along,
                    half = glm::cross(circle->axis, aside / length) * std::sqrt(squared);
        const dvec3 place = glm::dot(from - base, half) > 0 ? base + half : base - half;
        const dvec3 sum = dvec3(mesh_.normals[t.x]) + dvec3(mesh_.normals[t.y]) + dvec3(mesh_.normals[t.z]);
        return vertexAt(place, from, unitOr(sum, dvec3(mesh_.normals[t.x])), mesh_.atoms[t.x]);
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh_.triangles.emplace_back(a, b, c); }

    void split(const glm::uvec3& t) {
        // Opposite of each corner.
        const std::uint32_t edge[3] = {onEdge(t.y, t.z), onEdge(t.z, t.x), onEdge(t.x, t.y)};
        const int cut = static_cast<int>(std::count_if(edge, edge + 3, [](std::uint32_t e) { return e != kNone; }));
        if (cut == 0) return add(t.x, t.y, t.z);
        if (cut == 3) {
            const std::uint32_t center = onCorner(t);
            if (center != kNone) {
                for (int i = 0; i < 3; ++i) {
                    add(t[i], edge[(i + 2) % 3], center);
                    add(t[i], center, edge[(i + 1) % 3]);
                }
                return;
            }
            for (int i = 0; i < 3; ++i) add(t[i], edge[(i + 2) % 3], edge[(i + 1) % 3]);
            return add(edge[0], edge[1], edge[2]);
        }
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
            if (cut == 1 && edge[i] != kNone) {
                add(a, b, edge[i]);
                return add(a, edge[i], c);
            }
            if (cut == 2 && edge[i] == kNone) {  // a stands alone beyond the crease
                const std::uint32_t ab = edge[(i + 2) % 3], ca = edge[(i + 1) % 3];
                add(a, ab, ca);
                add(ab, b, c);
                return add(ab, c, ca);
            }
        }
    }

    Mesh& mesh_;
    const std::vector<SurfaceBall>& balls_;
    BallGrid grid_;
    dvec3 shift_;
    double step_, widest_ = 0;
    std::unordered_map<std::uint32_t, std::uint32_t> ballOfAtom_;
    std::unordered_map<std::uint64_t, std::uint32_t> edges_;
};

}  // namespace

void putCreases(Mesh& mesh, const std::vector<SurfaceBall>& balls, const dvec3& shift, double step) {
    CreaseMaker(mesh, balls, shift, step).make();
}

}  // namespace nacre
