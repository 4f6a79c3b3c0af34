#pragma once
// Ray-traced, cosine-weighted ambient occlusion of a scene: what the baked occlusion is judged by.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "engine/scene/representation.h"
#include "tests/reference/ray_caster.h"
#include "tests/reference/solids.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace nacre::reference {

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
