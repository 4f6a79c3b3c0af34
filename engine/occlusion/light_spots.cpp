#include "engine/occlusion/light_spots.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "engine/occlusion/directions.h"
#include "engine/occlusion/nearest_surface.h"
#include "engine/occlusion/patch_coordinates.h"
#include "engine/threads.h"

namespace nacre {
namespace {

/// Å that rays of meshes start above them: their facets are not quite their surface.
constexpr float kLift = 1e-2f;

/// Fewer for many spots: time and memory are proportional to both.
int directionsFor(std::uint64_t spots) { return spots <= 100'000 ? 64 : spots <= 1'000'000 ? 32 : 16; }

std::uint16_t fraction(float value) {
    return static_cast<std::uint16_t>(std::clamp(value, 0.0f, 1.0f) * 65535.0f + 0.5f);
}

/// Texel of a patch that is nearest to a coordinate.
std::uint32_t nearestTexel(const glm::vec2& uv, const glm::uvec2& size) {
    const glm::uvec2 at(glm::clamp(uv, 0.0f, 1.0f) * glm::vec2(size - 1u) + 0.5f);
    return at.y * size.x + at.x;
}

/// Results of consecutive primitives.
struct Part {
    std::vector<SeenSpot> seen;
    std::vector<std::uint32_t> ends;  // for each spot, within `seen`
    std::vector<SkyLean> sky;         // of each spot

    void end(const SkyLean& of) {
        ends.push_back(static_cast<std::uint32_t>(seen.size()));
        sky.push_back(of);
    }
};

class Seer {
public:
    Seer(const Representation& r, const BakedOcclusion& baked, const LightSpots& spots)
        : r_(r), baked_(baked), spots_(spots), surfaces_(r), spheresAlone_(r.cylinders.empty() && r.triangles.empty()) {
        for (const glm::dmat3& turn : occlusionDirections(kSets)) {
            directions_.emplace_back();
            for (const glm::dmat3& frame : occlusionDirections(directionsFor(spots.count())))
                directions_.back().emplace_back(turn * glm::transpose(frame)[2]);
        }
        for (std::uint32_t k = 0; k < spots.ofSphere.x * spots.ofSphere.y; ++k)
            ofSphere_.push_back(octahedralNormal(placeInPatch(k, spots.ofSphere)));
        itemOfVertex_.resize(r.meshVertices.size(), kNone);
        for (std::size_t i = 0; i < r.triangles.size(); ++i)
            for (const std::uint32_t v : {r.triangles[i].a, r.triangles[i].b, r.triangles[i].c})
                itemOfVertex_[v] = static_cast<std::uint32_t>(r.spheres.size() + r.cylinders.size() + i);
    }

    void sphere(std::uint32_t i, Part& part) const {
        if (ofSphere_.size() == 1) {
            all(i, part.seen);
            return part.end({});
        }
        const NearSpheres near = surfaces_.findNear(i);
        std::vector<glm::vec3> open;
        for (const glm::vec3& normal : ofSphere_)
            if (!near.bury(r_.pointOfBall(i, normal))) open.push_back(normal);
        for (std::uint32_t k = 0; k < ofSphere_.size(); ++k) {
            const std::optional<glm::vec3> normal = outside(i, ofSphere_[k], open, near);
            if (!normal) {
                part.end({});
                continue;
            }
            const glm::vec3 point = r_.pointOfBall(i, *normal);
            const auto ray = [&](const glm::vec3& d) {
                return spheresAlone_ ? surfaces_.from(i, point, d, near) : surfaces_.from(i, point, d);
            };
            each(setOf(k, spots_.ofSphere), *normal, ray, part);
        }
    }
    void cylinder(std::uint32_t i, Part& part) const {
        const Cylinder& c = r_.cylinders[i];
        const glm::vec3 axis = glm::normalize(c.b - c.a);
        const auto item = static_cast<std::uint32_t>(r_.spheres.size()) + i;
        for (std::uint32_t k = 0; k < spots_.ofCylinder.x * spots_.ofCylinder.y; ++k) {
            const glm::vec2 place = placeInPatch(k, spots_.ofCylinder);
            const glm::vec3 normal = directionAbout(axis, place.x);
            const glm::vec3 point = glm::mix(c.a, c.b, place.y) + c.radius * normal;
            if (surfaces_.buries(item, point))
                part.end({});
            else
                from(item, setOf(k, spots_.ofCylinder), point, normal, part);
        }
    }
    void vertex(std::uint32_t i, Part& part) const {
        const std::uint32_t item = itemOfVertex_[i];
        if (item == kNone) return part.end({}), part.end({});
        const float step = r_.triangles[item - r_.spheres.size() - r_.cylinders.size()].step();
        const glm::vec3 point = decodePosition(r_.meshVertices[i], step), normal = decodeNormal(r_.meshVertices[i]);
        from(item, i % kSets, point + kLift * normal, normal, part);
        // The inner side of a closed surface gets no light.
        if (baked_.ofVertex(i, true) > 0)
            from(item, i % kSets, point - kLift * normal, -normal, part);
        else
            part.end({});
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    static constexpr int kSets = 4;

    /// Spots next to each other send rays in other directions, so that interpolation averages four sets.
    static std::uint32_t setOf(std::uint32_t spot, const glm::uvec2& size) {
        return spot % size.x % 2 + spot / size.x % 2 * 2;
    }

    /// The normal where a texel of a sphere looks from: its own or, where that is inside of another sphere, one at the
    /// crease on the way to the next open texel. @param open  normals of the sphere's open texels
    std::optional<glm::vec3> outside(std::uint32_t sphere, const glm::vec3& normal, const std::vector<glm::vec3>& open,
                                     const NearSpheres& near) const {
        constexpr float kNear = 0.5f;  // cosine of the angle to a texel next to this one
        constexpr int kHalvings = 5;   // to a 32nd of that angle
        const glm::vec3* next = nullptr;
        for (const glm::vec3& other : open)
            if (const float cosine = glm::dot(normal, other); cosine > (next ? glm::dot(normal, *next) : kNear))
                next = &other;
        if (!next) return {};
        if (*next == normal) return normal;
        glm::vec3 inside = normal, out = *next;
        for (int k = 0; k < kHalvings; ++k) {
            const glm::vec3 middle = glm::normalize(inside + out);
            (near.bury(r_.pointOfBall(sphere, middle)) ? inside : out) = middle;
        }
        return out;
    }

    void from(std::uint32_t self, std::uint32_t set, const glm::vec3& point, const glm::vec3& normal,
              Part& part) const {
        each(
            set, normal, [&](const glm::vec3& direction) { return surfaces_.from(self, point, direction); }, part);
    }
    /// A spot that sees what ray(direction) meets in each direction above a surface.
    template <typename Ray>
    void each(std::uint32_t set, const glm::vec3& normal, const Ray& ray, Part& part) const {
        glm::vec3 all{}, open{};
        float allWeight = 0, openWeight = 0;
        for (const glm::vec3& direction : directions_[set]) {
            const float cosine = glm::dot(direction, normal);
            if (cosine <= 0) continue;
            all += cosine * direction, allWeight += cosine;
            if (const auto met = ray(direction))
                part.seen.push_back(spotAt(*met, cosine));
            else
                open += cosine * direction, openWeight += cosine;
        }
        if (allWeight == 0) return part.end({});
        part.end({1.5f * (open - openWeight / allWeight * all) / allWeight, true});
    }
    /// Of a sphere that has one value.
    void all(std::uint32_t i, std::vector<SeenSpot>& seen) const {
        for (const glm::vec3& direction : directions_[0]) {
            const glm::vec3 point = r_.pointOfBall(i, direction);
            if (surfaces_.buries(i, point)) continue;
            if (const auto met = surfaces_.from(i, point, direction)) seen.push_back(spotAt(*met, 1));
        }
    }

    SeenSpot spotAt(const SurfaceHit& p, float cosine) const {
        const auto spheres = static_cast<std::uint32_t>(r_.spheres.size());
        const auto solids = spheres + static_cast<std::uint32_t>(r_.cylinders.size());
        const std::uint16_t weight = fraction(cosine);
        if (p.item < spheres)
            return {spots_.firstOfSphere(p.item) + nearestTexel(octahedralCoordinate(p.normal), spots_.ofSphere),
                    weight, fraction(baked_.ofSphere(p.item, p.normal))};
        if (p.item < solids) {
            const std::uint32_t i = p.item - spheres;
            const glm::vec3 axis = glm::normalize(r_.cylinders[i].b - r_.cylinders[i].a);
            return {spots_.firstOfCylinder(i) + nearestTexel({angleAbout(axis, p.normal), p.share}, spots_.ofCylinder),
                    weight, fraction(baked_.ofCylinder(i, axis, p.normal, p.share))};
        }
        const Triangle& t = r_.triangles[p.item - solids];
        const std::uint32_t corners[]{t.a, t.b, t.c};
        int nearest = p.shares.y > p.shares.x ? 1 : 0;
        if (p.shares.z > p.shares[nearest]) nearest = 2;
        float open = 0;
        for (int k = 0; k < 3; ++k) open += p.shares[k] * baked_.ofVertex(corners[k], p.inner);
        return {spots_.ofVertex(corners[nearest], p.inner), weight, fraction(open)};
    }

    const Representation& r_;
    const BakedOcclusion& baked_;
    const LightSpots& spots_;
    NearestSurface surfaces_;
    bool spheresAlone_;
    std::vector<std::vector<glm::vec3>> directions_;
    std::vector<glm::vec3> ofSphere_;          // normals of a sphere's texels
    std::vector<std::uint32_t> itemOfVertex_;  // one of its triangles, as NearestSurface counts
};

}  // namespace

glm::vec2 placeInPatch(std::uint32_t texel, const glm::uvec2& size) {
    return glm::vec2(texel % size.x, texel / size.x) / glm::vec2(glm::max(size, glm::uvec2(2)) - 1u);
}

LightSpots findLightSpots(const Representation& r, const OcclusionLayout& layout, const BakedOcclusion& baked,
                          const std::stop_token& stop) {
    LightSpots spots;
    spots.ofSphere = glm::min(glm::uvec2(layout.sphereEdge), LightSpots::kSphere);
    spots.ofCylinder = glm::min(glm::uvec2(layout.around, layout.along), LightSpots::kCylinder);
    spots.spheres = layout.sphereCount;
    spots.cylinders = layout.cylinderCount;
    spots.vertices = layout.vertexCount;
    const Seer seer(r, baked, spots);
    constexpr std::size_t kPart = 256;
    const std::size_t primitives = std::size_t{spots.spheres} + spots.cylinders + spots.vertices;
    std::vector<Part> parts((primitives + kPart - 1) / kPart);
    inParallel(parts.size(), [&](std::size_t n) {
        const auto end = static_cast<std::uint32_t>(std::min(primitives, (n + 1) * kPart));
        Part& part = parts[n];
        for (auto i = static_cast<std::uint32_t>(n * kPart); i < end && !stop.stop_requested(); ++i) {
            if (i < spots.spheres)
                seer.sphere(i, part);
            else if (i < spots.spheres + spots.cylinders)
                seer.cylinder(i - spots.spheres, part);
            else
                seer.vertex(i - spots.spheres - spots.cylinders, part);
        }
    });
    if (stop.stop_requested()) return spots;
    spots.first.reserve(std::size_t{spots.count()} + 1);
    spots.first.push_back(0);
    std::size_t seen = 0;
    for (const Part& part : parts) seen += part.seen.size();
    spots.seen.reserve(seen);
    spots.sky.reserve(spots.count());
    for (Part& part : parts) {
        const auto before = static_cast<std::uint32_t>(spots.seen.size());
        spots.seen.insert(spots.seen.end(), part.seen.begin(), part.seen.end());
        spots.sky.insert(spots.sky.end(), part.sky.begin(), part.sky.end());
        for (const std::uint32_t end : part.ends) spots.first.push_back(before + end);
        part = {};
    }
    return spots;
}

}  // namespace nacre
