#include "engine/scene/view/scene_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>

#include "engine/mesh/unit_vectors.h"
#include "engine/scene/build/mesh_streams.h"
#include "engine/scene/instances/write_out_copies.h"
#include "engine/scene/view/keep_spheres.h"
#include "engine/scene/view/orientation.h"

namespace nacre {
namespace {

// Least distance of planes from the eye, Å, as in Mol*; less for a small scene. Primitives may extend beyond a plane by
// a fraction of it, so that all of them are in front of the eye.
constexpr double kNearestPlane = 5, kRoomShare = 0.8;

/// Rows are the axes of the picture: right, up, to the viewer.
glm::dmat3 makeRotation(const SceneCamera& camera) {
    const glm::dvec3 back = unitOr(-camera.direction, {0, 0, 1});
    glm::dvec3 right = glm::cross(camera.up, back);
    if (glm::length(right) < 1e-9)
        right = glm::cross(std::abs(back.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), back);
    right = glm::normalize(right);
    return glm::transpose(glm::dmat3(right, glm::cross(back, right), back));
}

/// 49 directions, each for both signs: permutations of (1,0,0) (1,1,0) (1,1,1) (2,1,0) (2,1,1) (2,2,1).
std::vector<glm::dvec3> extremeDirections() {
    std::vector<glm::dvec3> directions;
    for (int x = 0; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = -2; z <= 2; ++z) {
                const bool half = x > 0 || (x == 0 && (y > 0 || (y == 0 && z > 0)));
                if (half && std::gcd(std::gcd(x, y), z) == 1) directions.push_back(glm::normalize(glm::dvec3(x, y, z)));
            }
    return directions;
}

template <typename Keep>
void keepCylinders(std::vector<Cylinder>& sticks, std::vector<CylinderLook>& looks, const Keep& keep) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < sticks.size(); ++i) {
        if (!keep(sticks[i])) continue;
        sticks[kept] = sticks[i];
        looks[kept++] = looks[i];
    }
    sticks.resize(kept);
    looks.resize(kept);
}

/// Keeps some triangles. Drops levels, which have other triangles. Runs of meshes shrink.
template <typename Keep>
void keepTriangles(Representation& r, const Keep& keep) {
    std::uint32_t kept = 0;
    for (MeshRun& mesh : r.meshes) {
        const std::uint32_t first = kept;
        for (std::uint32_t i = mesh.first; i < mesh.first + mesh.count; ++i)
            if (keep(r.triangles[i])) r.triangles[kept++] = r.triangles[i];
        mesh.first = first;
        mesh.count = kept - first;
        mesh.levels.clear();
        mesh.closed = false;
    }
    r.triangles.resize(kept);
    r.coarseTriangles.clear();
    std::erase_if(r.meshes, [](const MeshRun& mesh) { return mesh.count == 0; });
}

}  // namespace

SceneView makeView(const SceneCamera& camera, const Camera& hand, bool ortho, double reach, std::uint32_t width,
                   std::uint32_t height) {
    const double half = glm::radians(camera.fovDegrees) / 2;
    const double shape = std::min(1.0, static_cast<double>(width) / height);
    const double distance = camera.distance > 0 ? camera.distance : camera.radius / shape / std::sin(half);
    SceneView result;
    View& view = result.view;
    view.width = width;
    view.height = height;
    view.rotation = rotationMatrix(hand.rotationDegrees) * makeRotation(camera);
    view.pixelsPerAngstrom = height / (2 * distance * std::tan(half)) * hand.zoom;
    view.pan = hand.pan;
    if (ortho) {
        view.projection = Projection::orthographic;
        view.radius = reach;
        return result;
    }
    constexpr double kFarthestShare = 0.95;  // of the distance to the target
    const double wanted = camera.nearest > 0 ? std::min(camera.nearest, kFarthestShare * distance) : kNearestPlane;
    const double nearest = std::min(wanted, std::max(reach, 1e-3));
    const double before = std::min(camera.radius, distance - nearest);  // the near plane, from the target
    result.room = kRoomShare * nearest;
    view.projection = Projection::perspective;
    view.eyeDistance = distance;
    if (reach > before) result.clip.near = -before;
    if (reach > camera.radius) result.clip.far = camera.radius;
    // All depths are in front of the eye.
    const double deepest = std::max(before, camera.radius) + result.room;
    view.radius = std::min({reach, deepest, distance - (nearest - result.room) / 2});
    result.clip.far = std::min(result.clip.far, view.radius < reach ? view.radius : Clip::kNone);
    return result;
}

SceneCamera makeCamera(const View& view, const glm::dvec3& center, bool whole) {
    SceneCamera camera;
    const glm::dmat3 back = glm::transpose(view.rotation);
    const double half = glm::radians(camera.fovDegrees) / 2;
    const double shape = std::min(1.0, static_cast<double>(view.width) / view.height);
    camera.target = center - back * glm::dvec3(view.pan, 0);
    camera.direction = -back[2];
    camera.up = back[1];
    constexpr double kFill = 0.65;  // least fraction of the picture that a molecule in the ball fills
    const double side = view.height / (2 * view.pixelsPerAngstrom) * shape;
    camera.radius = side * std::cos(half);
    if (whole) camera.radius = std::max(camera.radius, std::min(view.radius, side / kFill));
    return camera;
}

void dropOutside(Representation& r, const SceneView& seen) {
    const Clip& clip = seen.clip;
    if (!clip.on()) return;
    const glm::dvec3 away = -glm::dvec3(seen.view.rotation[0].z, seen.view.rotation[1].z, seen.view.rotation[2].z);
    const auto depth = [&](const glm::vec3& p) { return glm::dot(glm::dvec3(p), away); };
    const auto inside = [&](double low, double high) {
        return high >= clip.near && low <= clip.far && low >= clip.near - seen.room && high <= clip.far + seen.room;
    };
    const auto meets = [&](const glm::dvec3& center, double radius) {
        const double at = glm::dot(center, away);
        return inside(at - radius, at + radius);
    };
    if (!r.copies.transforms.empty() && !writeOutCopies(r, meets)) return;
    keepSpheres(r, [&](std::size_t i) {
        const double at = depth(r.spheres[i].center), radius = static_cast<double>(r.spheres[i].radius);
        return inside(at - radius, at + radius);
    });
    const auto keepStick = [&](const Cylinder& stick) {
        const double a = depth(stick.a), b = depth(stick.b), radius = std::max(0.0, static_cast<double>(stick.radius));
        return inside(std::min(a, b) - radius, std::max(a, b) + radius);
    };
    keepCylinders(r.cylinders, r.cylinderLooks, keepStick);
    keepCylinders(r.wires, r.wireLooks, keepStick);
    keepTriangles(r, [&](const Triangle& t) {
        double low = Clip::kNone, high = -Clip::kNone;
        for (const std::uint32_t v : {t.a, t.b, t.c}) {
            const double at = depth(decodePosition(r.meshVertices[v], t.step()));
            low = std::min(low, at);
            high = std::max(high, at);
        }
        return inside(low, high);
    });
}

std::vector<glm::dvec3> extremePoints(std::span<const glm::dvec4> balls) {
    static const std::vector<glm::dvec3> kDirections = extremeDirections();
    std::vector<glm::dvec3> points;
    points.reserve(2 * kDirections.size());
    for (const glm::dvec3& direction : kDirections) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        const glm::dvec4 *lowest = &balls.front(), *highest = lowest;
        for (const glm::dvec4& ball : balls) {
            const double at = glm::dot(direction, glm::dvec3(ball));
            if (at - ball.w < low) low = at - ball.w, lowest = &ball;
            if (at + ball.w > high) high = at + ball.w, highest = &ball;
        }
        points.push_back(glm::dvec3(*lowest) - direction * lowest->w);
        points.push_back(glm::dvec3(*highest) + direction * highest->w);
    }
    return points;
}

std::vector<glm::dvec3> movedOut(std::span<const glm::dvec3> points, const Bounds& sphere, double room) {
    const glm::dmat3 axes = findPrincipalAxes(points);
    std::vector<glm::dvec3> moved;
    moved.reserve(points.size());
    for (const glm::dvec3& point : points) {
        glm::dvec3 out = point - sphere.center;
        for (int i = 0; i < 3; ++i) out += axes[i] * (glm::dot(point - sphere.center, axes[i]) < 0 ? -room : room);
        const double length = glm::length(out), most = sphere.radius + room;
        moved.push_back(sphere.center + (length > most ? out * (most / length) : out));
    }
    return moved;
}

Bounds extremeSphere(std::span<const glm::dvec4> balls) {
    Bounds bounds;
    const std::vector<glm::dvec3> points = extremePoints(balls);
    for (const glm::dvec3& point : points) bounds.center += point / static_cast<double>(points.size());
    bounds.radius = 0;
    for (const glm::dvec4& ball : balls)
        bounds.radius = std::max(bounds.radius, glm::distance(glm::dvec3(ball), bounds.center) + ball.w);
    return bounds;
}

}  // namespace nacre
