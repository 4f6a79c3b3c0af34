#include "tests/reference/ambient_occlusion.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tests/reference/random.h"

namespace nacre::reference {
namespace {

void boundRod(const RTCBoundsFunctionArguments* arguments) {
    const Rod& rod = (*static_cast<const std::vector<Rod>*>(arguments->geometryUserPtr))[arguments->primID];
    // Doubles that were floats convert back exactly; the slack covers the sum with the radius.
    const glm::dvec3 low = glm::min(rod.a, rod.b) - rod.radius, high = glm::max(rod.a, rod.b) + rod.radius;
    const auto down = [](double x) {
        return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::max());
    };
    const auto up = [](double x) { return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::max()); };
    *arguments->bounds_o =
        RTCBounds{down(low.x), down(low.y), down(low.z), 0.0f, up(high.x), up(high.y), up(high.z), 0.0f};
}

/// Rods are user geometry rather than one of Embree's curves: so their ends are exactly the flat ones of solids.h.
void occludeByRod(const RTCOccludedFunctionNArguments* arguments) {
    const Rod& rod = (*static_cast<const std::vector<Rod>*>(arguments->geometryUserPtr))[arguments->primID];
    const unsigned count = arguments->N;
    for (unsigned i = 0; i < count; ++i) {
        if (arguments->valid[i] == 0) continue;
        RTCRayN* ray = arguments->ray;
        const Line line{{RTCRayN_org_x(ray, count, i), RTCRayN_org_y(ray, count, i), RTCRayN_org_z(ray, count, i)},
                        glm::normalize(glm::dvec3(RTCRayN_dir_x(ray, count, i), RTCRayN_dir_y(ray, count, i),
                                                  RTCRayN_dir_z(ray, count, i)))};
        const auto crossing = cross(line, rod);
        if (crossing && crossing->leave > 0.0) RTCRayN_tfar(ray, count, i) = -std::numeric_limits<float>::infinity();
    }
}

RTCRay makeRay(const glm::dvec3& start, const glm::dvec3& direction) {
    RTCRay ray{};
    ray.org_x = static_cast<float>(start.x);
    ray.org_y = static_cast<float>(start.y);
    ray.org_z = static_cast<float>(start.z);
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0u;
    return ray;
}

/// Even over all rotations: K. Shoemake, "Uniform random rotations", Graphics Gems III (1992), 124-132.
glm::dmat3 randomRotation(Random& random) {
    const double share = random.unit();
    const double first = 2.0 * std::numbers::pi * random.unit(), second = 2.0 * std::numbers::pi * random.unit();
    const double small = std::sqrt(1.0 - share), large = std::sqrt(share);
    return glm::mat3_cast(glm::dquat(large * std::cos(second), small * std::sin(first), small * std::cos(first),
                                     large * std::sin(second)));
}

}  // namespace

void OcclusionScene::DeviceRelease::operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }
void OcclusionScene::SceneRelease::operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }
OcclusionScene::~OcclusionScene() = default;

OcclusionScene::OcclusionScene(const Representation& scene) : device_(rtcNewDevice(nullptr)) {
    throwOnError();
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    if (!scene.spheres.empty()) addSpheres(scene.spheres);
    if (!scene.cylinders.empty()) addRods(scene.cylinders);
    if (!scene.triangles.empty()) addMesh(scene);
    rtcCommitScene(scene_.get());
    throwOnError();
}

void OcclusionScene::throwOnError() const {
    const RTCError error = rtcGetDeviceError(device_.get());
    if (error != RTC_ERROR_NONE) throw std::runtime_error("Embree fails with error " + std::to_string(error));
}

void OcclusionScene::addSpheres(const std::vector<Sphere>& spheres) {
    const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                                               4 * sizeof(float), spheres.size()));
    throwOnError();
    for (const Sphere& sphere : spheres) {
        *points++ = sphere.center.x;
        *points++ = sphere.center.y;
        *points++ = sphere.center.z;
        *points++ = sphere.radius;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    spheres_ = true;
}

void OcclusionScene::addRods(const std::vector<Cylinder>& cylinders) {
    for (const Cylinder& cylinder : cylinders) rods_.push_back({cylinder.a, cylinder.b, cylinder.radius});
    const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(rods_.size()));
    rtcSetGeometryUserData(geometry, &rods_);
    rtcSetGeometryBoundsFunction(geometry, boundRod, nullptr);
    rtcSetGeometryOccludedFunction(geometry, occludeByRod);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
}

void OcclusionScene::addMesh(const Representation& scene) {
    const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), 3 * scene.triangles.size()));
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(unsigned), scene.triangles.size()));
    throwOnError();
    unsigned next = 0;
    for (const Triangle& t : scene.triangles)
        for (const std::uint32_t v : {t.a, t.b, t.c}) {
            const glm::vec3 p = decodePosition(scene.meshVertices[v], t.step());
            *points++ = p.x;
            *points++ = p.y;
            *points++ = p.z;
            *corners++ = next++;
        }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
}

bool OcclusionScene::openTowards(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& direction) const {
#if RTC_VERSION_MAJOR < 4
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
#endif
    RTCRay ray = makeRay(point + kLift * normal, direction);
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene_.get(), &ray);
#else
    rtcOccluded1(scene_.get(), &context, &ray);
#endif
    return ray.tfar > 0.0f;
}

std::optional<OcclusionScene::Hit> OcclusionScene::nearest(const glm::dvec3& start, const glm::dvec3& direction) const {
    if (!rods_.empty()) throw std::logic_error("OcclusionScene::nearest: cylinders are not intersected");
#if RTC_VERSION_MAJOR < 4
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
#endif
    RTCRayHit ray{};
    ray.ray = makeRay(start, direction);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene_.get(), &ray);
#else
    rtcIntersect1(scene_.get(), &context, &ray);
#endif
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const glm::dvec3 normal = glm::normalize(glm::dvec3(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z));
    return Hit{ray.hit.geomID != 0 || !spheres_, ray.hit.primID, start + static_cast<double>(ray.ray.tfar) * direction,
               glm::dot(normal, direction) > 0 ? -normal : normal};
}

double OcclusionScene::occlusionAt(const glm::dvec3& point, const glm::dvec3& normal, std::size_t rayCount,
                                   std::uint64_t seed) const {
    const auto side =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(rayCount)))));
    Random random(seed);
    std::size_t open = 0;
    for (std::size_t i = 0; i < side; ++i)
        for (std::size_t j = 0; j < side; ++j) {
            const double square = (static_cast<double>(i) + random.unit()) / static_cast<double>(side);
            const double turn = (static_cast<double>(j) + random.unit()) / static_cast<double>(side);
            const glm::dvec3 direction = cosineDirection(normal, square, turn);
            if (openTowards(point, normal, direction)) ++open;
        }
    return static_cast<double>(open) / static_cast<double>(side * side);
}

std::vector<SurfacePoint> randomVisiblePoints(const Representation& scene, std::size_t count, std::uint64_t seed) {
    constexpr std::size_t kViews = 16;
    constexpr std::uint32_t kSide = 256;
    Random random(seed);
    std::vector<SurfacePoint> points;
    for (std::size_t v = 0; v < kViews; ++v) {
        View view;
        view.width = view.height = kSide;
        view.rotation = randomRotation(random);
        view.radius = scene.radius;
        view.pixelsPerAngstrom = kSide / (2.0 * scene.radius);
        const Layers layers = castRays(scene, view);
        if (std::all_of(layers.id.begin(), layers.id.end(), [](std::uint32_t id) { return id == 0; }))
            throw std::invalid_argument("randomVisiblePoints: a view shows nothing");
        const std::size_t wanted = count * (v + 1) / kViews;
        while (points.size() < wanted) {
            const auto column = static_cast<std::uint32_t>(random.below(kSide));
            const auto row = static_cast<std::uint32_t>(random.below(kSide));
            if (const auto point = surfacePoint(scene, view, layers, column, row)) points.push_back(*point);
        }
    }
    return points;
}

}  // namespace nacre::reference
