#pragma once
// Ray-traced, cosine-weighted ambient occlusion of a scene: what the baked occlusion is judged by.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "engine/scene/build/representation.h"
#include "tests/reference/ray_caster.h"
#include "tests/reference/solids.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace nacre::reference {

/// How far above the surface rays start, in Å. Embree works in float, whose step at 100 Å from the origin is 8e-6 Å
/// (3e-5 at 500): a start this high stays outside its own solid with a margin of 30 to 100 roundings. On the other
/// side it is 1/150 of the thinnest bond's radius, so that what the patch sees does not change noticeably.
inline constexpr double kLift = 1e-3;

/// Spheres, flat-capped cylinders and triangles in an Embree scene. Frame: that of the streams, Å.
class OcclusionScene {
public:
    /// @throws std::runtime_error if Embree does
    explicit OcclusionScene(const Representation& scene);
    OcclusionScene(const OcclusionScene&) = delete;
    OcclusionScene& operator=(const OcclusionScene&) = delete;
    ~OcclusionScene();

    /// Share of the cosine-weighted hemisphere that no surface blocks at any distance: 1 = open, 0 = closed.
    /// Directions are stratified: one at a random place in each cell of an n x n grid, n = ceil(sqrt(rayCount)).
    /// May be called from several threads at once.
    /// @param point   on the outer surface
    /// @param normal  outward, unit length
    double occlusionAt(const glm::dvec3& point, const glm::dvec3& normal, std::size_t rayCount = 4096,
                       std::uint64_t seed = 1) const;

    /// Whether nothing lies between a point of the outer surface and infinity in a direction above the surface.
    bool openTowards(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& direction) const;

    struct Hit {
        bool ofTriangle;          ///< else of a sphere
        std::uint32_t primitive;  ///< among its kind
        glm::dvec3 position;      ///< Å
        glm::dvec3 normal;        ///< unit length, against the ray
    };
    /// The nearest sphere or triangle of a scene without cylinders. @param direction  unit length
    std::optional<Hit> nearest(const glm::dvec3& start, const glm::dvec3& direction) const;

private:
    struct DeviceRelease {
        void operator()(RTCDeviceTy* device) const;
    };
    struct SceneRelease {
        void operator()(RTCSceneTy* scene) const;
    };
    void addSpheres(const std::vector<Sphere>& spheres);
    void addRods(const std::vector<Cylinder>& cylinders);
    void addMesh(const Representation& scene);
    void throwOnError() const;

    bool spheres_ = false;   // are the first geometry
    std::vector<Rod> rods_;  // Embree's callbacks point into it
    std::unique_ptr<RTCDeviceTy, DeviceRelease> device_;
    std::unique_ptr<RTCSceneTy, SceneRelease> scene_;
};

/// Random points of the surface that can be seen from outside: a random pixel of a random orthographic view, 16 views
/// of 256 x 256 pixels with orientations drawn evenly from all rotations. A patch is thus chosen in proportion to the
/// area that it shows, averaged over all directions: open places more often than creases, as an onlooker sees them.
/// @param seed  same seed, same points
/// @throws std::invalid_argument if a view shows nothing: an empty scene, or one far thinner than its pixels
std::vector<SurfacePoint> randomVisiblePoints(const Representation& scene, std::size_t count, std::uint64_t seed = 1);

}  // namespace nacre::reference
