#include "app/annotation/label_sight.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace nacre::app {
namespace {

/// The scene in view space. A ray is its point on the plane z = 0.
class Eye {
public:
    explicit Eye(const View& view)
        : view_(view), eye_(view.projection == Projection::perspective ? view.eyeDistance : 0) {}

    glm::dvec3 turned(const glm::dvec3& place) const { return view_.seen(place); }
    double magnified(double z) const { return eye_ > 0 ? eye_ / std::max(eye_ - z, 1e-6) : 1; }
    glm::dvec2 rayTo(const glm::dvec3& p) const { return glm::dvec2(p) * magnified(p.z); }
    glm::dvec3 origin(const glm::dvec2& ray) const { return eye_ > 0 ? glm::dvec3(0, 0, eye_) : glm::dvec3(ray, 0); }
    glm::dvec3 way(const glm::dvec2& ray) const {
        return eye_ > 0 ? glm::normalize(glm::dvec3(ray, -eye_)) : glm::dvec3(0, 0, -1);
    }

private:
    const View& view_;
    double eye_;
};

/// A ray of a label.
struct Ray {
    glm::dvec2 at{};    // on the plane z = 0
    double before = 0;  // spheres up to this distance occlude
    std::uint32_t owner = 0;
    bool open = true;
};

/// Rays by their position on the plane z = 0.
class Rays {
public:
    explicit Rays(std::vector<Ray> rays) : rays_(std::move(rays)) {
        low_ = glm::dvec2(std::numeric_limits<double>::infinity());
        glm::dvec2 high = -low_;
        for (const Ray& ray : rays_) low_ = glm::min(low_, ray.at), high = glm::max(high, ray.at);
        cell_ = std::max({(high.x - low_.x) / kCells, (high.y - low_.y) / kCells, 1e-6});
        cells_.resize(std::size_t{kCells + 1} * (kCells + 1));
        for (std::size_t i = 0; i < rays_.size(); ++i)
            cells_[index(findCell(rays_[i].at.x - low_.x), findCell(rays_[i].at.y - low_.y))].push_back(i);
    }

    /// Calls judge(ray) for the rays within a distance of a point.
    template <typename Judge>
    void eachNear(const glm::dvec2& at, double reach, const Judge& judge) {
        const glm::dvec2 from = at - reach - low_, to = at + reach - low_;
        if (to.x < 0 || to.y < 0 || from.x > cell_ * (kCells + 1) || from.y > cell_ * (kCells + 1)) return;
        for (int y = findCell(from.y); y <= findCell(to.y); ++y)
            for (int x = findCell(from.x); x <= findCell(to.x); ++x)
                for (const std::size_t i : cells_[index(x, y)])
                    if (rays_[i].open) judge(rays_[i]);
    }
    const std::vector<Ray>& all() const { return rays_; }

private:
    static constexpr int kCells = 64;
    int findCell(double away) const { return static_cast<int>(std::clamp(away / cell_, 0.0, double{kCells})); }
    static std::size_t index(int x, int y) {
        return static_cast<std::size_t>(y) * (kCells + 1) + static_cast<std::size_t>(x);
    }

    std::vector<Ray> rays_;
    std::vector<std::vector<std::size_t>> cells_;
    glm::dvec2 low_{};
    double cell_ = 1;
};

constexpr double kOff = 0.05;  // Å in front of a surface

/// Five points of an atom's near side.
constexpr double kSides[][2] = {{0, 0}, {0.6, 0}, {-0.6, 0}, {0, 0.6}, {0, -0.6}};

}  // namespace

LabelSight::LabelSight(const Representation& r) {
    const glm::dmat4x3 still(1.0);
    const auto addBall = [&](const Sphere& s, const SphereLook& look, const glm::dmat4x3& to) {
        balls_.push_back({glm::vec3(to * glm::dvec4(s.center, 1.0)), s.radius, look.atom});
    };
    const auto addStick = [&](const Cylinder& c, const CylinderLook& look, const glm::dmat4x3& to) {
        const int count = std::clamp(static_cast<int>(glm::distance(c.a, c.b) / std::max(c.radius, 0.05f)), 1, 64);
        for (int i = 0; i < count; ++i) {
            const float along = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
            balls_.push_back({glm::vec3(to * glm::dvec4(glm::mix(c.a, c.b, along), 1.0)), c.radius,
                              along < 0.5f ? look.atomA : look.atomB});
        }
    };
    const auto addFacet = [&](const Triangle& t, const glm::dmat4x3& to) {
        const auto at = [&](std::uint32_t v) {
            return glm::vec3(to * glm::dvec4(decodePosition(r.meshVertices[v], t.step()), 1.0));
        };
        facets_.push_back({at(t.a), at(t.b), at(t.c), r.meshLooks[r.meshVertices[t.a].look].atom});
    };
    if (r.copies.transforms.empty()) {
        for (std::size_t i = 0; i < r.spheres.size(); ++i) addBall(r.spheres[i], r.sphereLooks[i], still);
        for (std::size_t i = 0; i < r.cylinders.size(); ++i) addStick(r.cylinders[i], r.cylinderLooks[i], still);
        for (const Triangle& t : r.triangles) addFacet(t, still);
        return;
    }
    const auto eachPlaced = [&](const std::vector<PrimitiveRun>& runs, const auto& add) {
        for (const PrimitiveRun& run : runs)
            for (const std::uint32_t copy : r.copies.lists[run.list])
                for (std::size_t i = run.first; i < run.first + run.count; ++i) add(i, r.copies.transforms[copy]);
    };
    eachPlaced(r.copies.spheres, [&](std::size_t i, const auto& to) { addBall(r.spheres[i], r.sphereLooks[i], to); });
    eachPlaced(r.copies.cylinders,
               [&](std::size_t i, const auto& to) { addStick(r.cylinders[i], r.cylinderLooks[i], to); });
    eachPlaced(r.copies.triangles, [&](std::size_t i, const auto& to) { addFacet(r.triangles[i], to); });
}

std::vector<double> LabelSight::openShares(const std::vector<const Named*>& named, const View& view,
                                           const Clip& clip) const {
    const Eye eye(view);
    std::vector<Ray> asked;
    for (std::uint32_t i = 0; i < named.size(); ++i)
        for (std::size_t k = 0; k < named[i]->places.size(); ++k)
            for (const auto& [x, y] : kSides) {
                const double radius = named[i]->radii[k];
                const glm::dvec3 p =
                    eye.turned(named[i]->places[k]) + glm::dvec3(x, y, std::sqrt(1 - x * x - y * y)) * (radius + kOff);
                const glm::dvec2 at = eye.rayTo(p);
                asked.push_back({at, glm::dot(p - eye.origin(at), eye.way(at)), i});
            }
    Rays rays(std::move(asked));
    const auto own = [&](const Ray& ray, std::uint32_t atom) {
        const std::vector<std::uint32_t>& atoms = named[ray.owner]->atoms;
        return std::binary_search(atoms.begin(), atoms.end(), atom);
    };
    for (const Ball& ball : balls_) {
        const glm::dvec3 center = eye.turned(ball.center);
        if (-center.z < clip.near) continue;
        const double radius = double{ball.radius}, reach = radius * eye.magnified(center.z + radius) * 1.05;
        rays.eachNear(eye.rayTo(center), reach, [&](Ray& ray) {
            const glm::dvec3 to = center - eye.origin(ray.at);
            const double along = glm::dot(to, eye.way(ray.at)),
                         h = radius * radius - (glm::dot(to, to) - along * along);
            if (h > 0 && along - std::sqrt(h) < ray.before && !own(ray, ball.atom)) ray.open = false;
        });
    }
    for (const Facet& facet : facets_) {
        const glm::dvec3 a = eye.turned(facet.a), b = eye.turned(facet.b), c = eye.turned(facet.c);
        if (-a.z < clip.near) continue;
        const glm::dvec2 at = eye.rayTo(a);
        const double reach = std::max(glm::distance(at, eye.rayTo(b)), glm::distance(at, eye.rayTo(c)));
        // T. Möller and B. Trumbore, J. Graphics Tools 2 (1997) 21.
        rays.eachNear(at, reach, [&](Ray& ray) {
            const glm::dvec3 way = eye.way(ray.at), u = b - a, v = c - a, h = glm::cross(way, v);
            const double area = glm::dot(u, h);
            if (std::abs(area) < 1e-12) return;
            const glm::dvec3 from = eye.origin(ray.at) - a, q = glm::cross(from, u);
            const double s = glm::dot(from, h) / area, t = glm::dot(way, q) / area;
            if (s < 0 || t < 0 || s + t > 1) return;
            if (glm::dot(v, q) / area < ray.before && !own(ray, facet.atom)) ray.open = false;
        });
    }
    std::vector<double> open(named.size()), count(named.size());
    for (const Ray& ray : rays.all()) ++count[ray.owner], open[ray.owner] += ray.open ? 1 : 0;
    for (std::size_t i = 0; i < open.size(); ++i) open[i] = count[i] > 0 ? open[i] / count[i] : 1;
    return open;
}

}  // namespace nacre::app
