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
constexpr double kTouch = 1e-6;  // Å: touching a ball is not inside it

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
    std::uint32_t vertexBall(std::uint32_t vertex) const { return ballOfAtom_.at(mesh_.atoms[vertex]); }
    dvec3 vertexPosition(std::uint32_t vertex) const { return dvec3(mesh_.positions[vertex]) - shift_; }

    bool isCovered(const dvec3& place) const {
        bool covered = false;
        grid_.near(place, widest_, [&](std::uint32_t ball) {
            covered = covered || glm::distance(balls_[ball].center, place) < balls_[ball].radius - kTouch;
        });
        return covered;
    }

    /// Intersection circle of two spheres: centre, unit vector from a to b, and radius.
    struct Circle {
        dvec3 center{}, axis{};
        double radius = 0;
    };
    std::optional<Circle> findCircle(std::uint32_t a, std::uint32_t b) const {
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

    /// A point on a crease, if the crease is open and near enough to the start. If another ball covers the point: the
    /// point in that direction on that ball.
    struct Place {
        dvec3 at{};
        std::uint32_t ball = kNone;  ///< the ball that covers it; none: on the crease
    };
    std::optional<Place> openPlace(const dvec3& place, const dvec3& from, const dvec3& normal) const {
        if (!(glm::distance(place, from) <= step_)) return std::nullopt;
        if (!isCovered(place)) return Place{place, kNone};
        const dvec3 way = unitOr(from - place, normal) * step_;
        const BallExit exit = findExit(balls_, grid_, widest_, place, way);
        if (exit.ball == kNoSource || exit.share > 1) return std::nullopt;
        return Place{place + way * exit.share, exit.ball};
    }

    /// A vertex at a place, for one ball: each side of a crease has its own normal and atom.
    std::uint32_t findVertex(const Place& place, std::uint32_t ball) {
        const SurfaceBall& of = balls_[place.ball == kNone ? ball : place.ball];
        mesh_.positions.emplace_back(place.at + shift_);
        mesh_.normals.emplace_back(unitOr(place.at - of.center, dvec3(0, 0, 1)));
        mesh_.atoms.push_back(of.atom);
        return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
    }

    /// Vertices on the crease between an edge's ends, for the side with the lower and with the higher number; shared by
    /// both triangles of the edge. None without a crease.
    struct Cut {
        std::uint32_t low = kNone, high = kNone;
    };
    Cut onEdge(std::uint32_t u, std::uint32_t v) {
        if (mesh_.atoms[u] == mesh_.atoms[v]) return {};
        if (u > v) std::swap(u, v);
        const auto [entry, added] = edges_.try_emplace(std::uint64_t{u} << 32 | v);
        if (!added) return entry->second;
        const std::uint32_t ballU = vertexBall(u), ballV = vertexBall(v);
        const std::optional<Circle> circle = findCircle(ballU, ballV);
        if (!circle) return {};
        const dvec3 a = vertexPosition(u), b = vertexPosition(v);
        const double heightA = glm::dot(a - circle->center, circle->axis),
                     heightB = glm::dot(b - circle->center, circle->axis);
        const double share = heightA * heightB < 0 ? heightA / (heightA - heightB) : 0.5;
        const dvec3 from = a + (b - a) * share;
        const dvec3 out = unitOr(across(from - circle->center, circle->axis), dvec3());
        if (out == dvec3()) return {};
        const dvec3 normal = unitOr(dvec3(mesh_.normals[u]) + dvec3(mesh_.normals[v]), out);
        const std::optional<Place> place = openPlace(circle->center + out * circle->radius, from, normal);
        if (!place) return {};
        Cut cut{findVertex(*place, ballU), kNone};
        cut.high = place->ball == kNone ? findVertex(*place, ballV) : cut.low;
        return entry->second = cut;
    }

    /// Where the spheres of a triangle's corners meet.
    std::optional<Place> onCorner(const glm::uvec3& t) const {
        const std::optional<Circle> circle = findCircle(vertexBall(t.x), vertexBall(t.y));
        if (!circle) return std::nullopt;
        // Finds the points of the circle on the third sphere by their distance towards its centre.
        const SurfaceBall& third = balls_[vertexBall(t.z)];
        const dvec3 way = third.center - circle->center, aside = across(way, circle->axis);
        const double length = glm::length(aside);
        if (length < kTouch) return std::nullopt;
        const double along =
            (glm::dot(way, way) + circle->radius * circle->radius - third.radius * third.radius) / (2 * length);
        const double squared = circle->radius * circle->radius - along * along;
        if (squared < 0) return std::nullopt;
        const dvec3 from = (vertexPosition(t.x) + vertexPosition(t.y) + vertexPosition(t.z)) / 3.0;
        const dvec3 base = circle->center + aside / length * along,
                    half = glm::cross(circle->axis, aside / length) * std::sqrt(squared);
        const dvec3 place = glm::dot(from - base, half) > 0 ? base + half : base - half;
        const dvec3 sum = dvec3(mesh_.normals[t.x]) + dvec3(mesh_.normals[t.y]) + dvec3(mesh_.normals[t.z]);
        return openPlace(place, from, unitOr(sum, dvec3(mesh_.normals[t.x])));
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh_.triangles.emplace_back(a, b, c); }

    void split(const glm::uvec3& t) {
        // Cuts opposite of each corner.
        const Cut cuts[3] = {onEdge(t.y, t.z), onEdge(t.z, t.x), onEdge(t.x, t.y)};
        const auto isCut = [&](int i) { return cuts[i].low != kNone; };
        // The vertex on the edge opposite of corner i, on the side of corner j.
        const auto on = [&](int i, int j) {
            const int other = 3 - i - j;
            return t[j] < t[other] ? cuts[i].low : cuts[i].high;
        };
        const int count = isCut(0) + isCut(1) + isCut(2);
        if (count == 0) return add(t.x, t.y, t.z);
        if (count == 3) return splitIntoSides(t, on);
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            if (count == 1 && isCut(i)) {
                add(t[i], t[j], on(i, j));
                return add(t[i], on(i, k), t[k]);
            }
            if (count == 2 && !isCut(i)) {  // corner i is alone on its side of the crease
                add(t[i], on(k, i), on(j, i));
                add(on(k, j), t[j], t[k]);
                return add(on(k, j), t[k], on(j, k));
            }
        }
    }

    /// A triangle between three balls.
    template <typename On>
    void splitIntoSides(const glm::uvec3& t, const On& on) {
        const std::optional<Place> middle = onCorner(t);
        std::uint32_t center[3] = {kNone, kNone, kNone};
        for (int i = 0; middle && i < 3; ++i)
            center[i] = i > 0 && middle->ball != kNone ? center[0] : findVertex(*middle, vertexBall(t[i]));
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            if (middle) {
                add(t[i], on(k, i), center[i]);
                add(t[i], center[i], on(j, i));
            } else {
                add(t[i], on(k, i), on(j, i));
            }
        }
        if (!middle) add(on(0, 1), on(1, 2), on(2, 0));
    }

    Mesh& mesh_;
    const std::vector<SurfaceBall>& balls_;
    BallGrid grid_;
    dvec3 shift_;
    double step_, widest_ = 0;
    std::unordered_map<std::uint32_t, std::uint32_t> ballOfAtom_;
    std::unordered_map<std::uint64_t, Cut> edges_;
};

}  // namespace

void putCreases(Mesh& mesh, const std::vector<SurfaceBall>& balls, const dvec3& shift, double step) {
    CreaseMaker(mesh, balls, shift, step).make();
}

}  // namespace nacre
