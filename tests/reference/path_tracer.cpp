#include "tests/reference/path_tracer.h"

#include <cmath>
#include <glm/matrix.hpp>
#include <limits>

#include "tests/reference/ambient_occlusion.h"
#include "tests/reference/random.h"
#include "tests/reference/ray_caster.h"
#include "tests/support/on_every_core.h"

namespace nacre::reference {
namespace {

/// As IEC 61966-2-1 has it.
double linear(double coded) { return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4); }
glm::dvec3 toLinear(std::uint32_t color) {
    glm::dvec3 c;
    for (int i = 0; i < 3; ++i) c[i] = linear(static_cast<double>(color >> (8 * i) & 0xffu) / 255.0);
    return c;
}

class PathTracer {
public:
    PathTracer(const Representation& scene, const View& view, const Sky& sky)
        : scene_(scene),
          solids_(scene),
          sky_(sky),
          toView_(view.rotation),
          toSun_(glm::transpose(view.rotation) * sky.toSun) {
        for (const SphereLook& look : scene.sphereLooks) spheres_.push_back(toLinear(look.color));
        for (const SphereLook& look : scene.meshLooks) mesh_.push_back(toLinear(look.color));
    }

    glm::dvec3 mean(const Line& line, std::size_t paths, std::uint64_t seed) const {
        const auto seen = solids_.nearest(line.origin, line.direction);
        if (!seen) return glm::dvec3(std::numeric_limits<double>::quiet_NaN());
        Random random(seed);
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < paths; ++i) sum += path(*seen, random);
        return sum / static_cast<double>(paths);
    }

private:
    glm::dvec3 path(OcclusionScene::Hit at, Random& random) const {
        constexpr int kMostBounces = 64;  // the brightest surfaces keep less than 1e-3 after as many
        glm::dvec3 kept(1.0), light(0.0);
        for (int bounce = 0; bounce < kMostBounces; ++bounce) {
            kept *= baseColor(at);
            const double facing = glm::dot(at.normal, toSun_);
            if (sky_.sun != glm::dvec3(0.0) && facing > 0 && solids_.openTowards(at.position, at.normal, toSun_))
                light += kept * sky_.sun * facing;
            const double square = random.unit(), turn = random.unit();
            const glm::dvec3 direction = cosineDirection(at.normal, square, turn);
            const auto next = solids_.nearest(at.position + kLift * at.normal, direction);
            if (!next) return light + kept * skyIn(direction);
            at = *next;
        }
        return light;
    }
    /// Of a radiance that is linear in the height of its direction, a surface gets two thirds of the slope.
    glm::dvec3 skyIn(const glm::dvec3& direction) const {
        return sky_.level + 1.5 * sky_.slope * (toView_ * direction).y;
    }
    glm::dvec3 baseColor(const OcclusionScene::Hit& hit) const {
        if (!hit.ofTriangle) return spheres_[hit.primitive];
        return mesh_[scene_.meshVertices[scene_.triangles[hit.primitive].a].look];
    }

    const Representation& scene_;
    OcclusionScene solids_;
    Sky sky_;
    glm::dmat3 toView_;
    glm::dvec3 toSun_;
    std::vector<glm::dvec3> spheres_, mesh_;  // linear colours
};

}  // namespace

std::vector<glm::dvec3> tracePaths(const Representation& scene, const View& view,
                                   const std::vector<std::uint32_t>& pixels, const Sky& sky, std::size_t paths) {
    const PathTracer tracer(scene, view, sky);
    const glm::dmat3 back = glm::transpose(view.rotation);
    std::vector<glm::dvec3> light(pixels.size());
    test::onEveryCore(pixels.size(), [&](std::size_t i) {
        const Line line = pixelLine(view, pixels[i] % view.width, pixels[i] / view.width);
        light[i] = tracer.mean({back * line.origin, back * line.direction}, paths, i);
    });
    return light;
}

}  // namespace nacre::reference
