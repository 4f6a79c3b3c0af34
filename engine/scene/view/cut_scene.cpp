#include "engine/scene/view/cut_scene.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "engine/scene/build/map_scene.h"
#include "engine/scene/build/mesh_caps.h"
#include "engine/scene/view/keep_spheres.h"

namespace nacre {
namespace {

/// Distance from the centre away from the viewer.
class Depth {
public:
    explicit Depth(const View& view) : away_(-view.rotation[0].z, -view.rotation[1].z, -view.rotation[2].z) {}
    double operator()(const glm::vec3& p) const { return glm::dot(away_, glm::dvec3(p)); }

private:
    glm::dvec3 away_;
};

/// A corner of a triangle that is being cut.
struct CutCorner {
    glm::vec3 place, normal;
    std::uint32_t look;
};
using Polygon = std::vector<CutCorner>;

/// The part of a polygon on one side of a plane (Sutherland and Hodgman 1974). @param within  depth inside; outside
/// negative
template <typename Within>
Polygon cutPolygon(const Polygon& polygon, const Within& within) {
    Polygon left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const CutCorner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double insideA = within(a.place), insideB = within(b.place);
        if (insideA >= 0) left.push_back(a);
        if ((insideA >= 0) == (insideB >= 0)) continue;
        const auto share = static_cast<float>(insideA / (insideA - insideB));
        left.push_back(
            {glm::mix(a.place, b.place, share), glm::mix(a.normal, b.normal, share), share < 0.5f ? a.look : b.look});
    }
    return left;
}

class SceneCutter {
public:
    SceneCutter(Representation& scene, const View& view, const Clip& clip, const std::vector<bool>& chosen)
        : scene_(scene), depth_(view), clip_(clip), chosen_(chosen) {}

    void cutSpheres() {
        keepSpheres(scene_, [&](std::size_t i) {
            const double depth = depth_(scene_.spheres[i].center);
            return isSpared(scene_.sphereLooks[i].atom) || (depth >= clip_.near && depth <= clip_.far);
        });
    }

    void cutSticks(std::vector<Cylinder>& sticks, std::vector<CylinderLook>& looks) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < sticks.size(); ++i) {
            Cylinder stick = sticks[i];
            CylinderLook look = looks[i];
            if (!(isSpared(look.atomA) && isSpared(look.atomB)) && !cutStick(stick, look)) continue;
            sticks[kept] = stick;
            looks[kept++] = look;
        }
        sticks.resize(kept);
        looks.resize(kept);
    }

    void cutMeshes() {
        const std::vector<MeshRun> meshes = std::move(scene_.meshes);
        const std::vector<Triangle> triangles = std::move(scene_.triangles);
        const std::vector<MeshVertex> vertices = std::move(scene_.meshVertices);
        const std::vector<SphereLook> looks = std::move(scene_.meshLooks);
        scene_.meshes.clear(), scene_.triangles.clear(), scene_.meshVertices.clear(), scene_.meshLooks.clear();
        scene_.coarseTriangles.clear();
        for (const MeshRun& run : meshes) {
            Mesh mesh;
            for (std::uint32_t i = run.first; i < run.first + run.count; ++i)
                addTriangle(triangles[i], vertices, looks, mesh);
            if (mesh.triangles.empty()) continue;
            appendMesh(
                mesh, {}, [&](std::uint32_t number) { return looks[number]; }, scene_);
            scene_.meshes.back().surface = run.surface;
            scene_.meshes.back().closed = false;
        }
    }

private:
    bool isSpared(std::uint32_t atom) const { return atom > 0 && atom <= chosen_.size() && chosen_[atom - 1]; }

    /// @returns whether anything is left
    bool cutStick(Cylinder& stick, CylinderLook& look) const {
        const double a = depth_(stick.a), b = depth_(stick.b);
        double from = 0, to = 1;
        for (const auto& [insideA, insideB] :
             {std::pair(a - clip_.near, b - clip_.near), {clip_.far - a, clip_.far - b}}) {
            if (insideA < 0 && insideB < 0) return false;
            if (insideA < 0) from = std::max(from, insideA / (insideA - insideB));
            if (insideB < 0) to = std::min(to, insideA / (insideA - insideB));
        }
        if (from >= to) return false;
        // Each half has a look; the remainder may lie in one half.
        if (from >= 0.5) look.colorA = look.colorB, look.atomA = look.atomB;
        if (to <= 0.5) look.colorB = look.colorA, look.atomB = look.atomA;
        const glm::vec3 start = stick.a, way = stick.b - stick.a;
        stick.a = start + way * static_cast<float>(from);
        stick.b = start + way * static_cast<float>(to);
        return true;
    }

    void addTriangle(const Triangle& t, const std::vector<MeshVertex>& vertices, const std::vector<SphereLook>& looks,
                     Mesh& mesh) const {
        Polygon polygon;
        bool spared = true;
        for (const std::uint32_t v : {t.a, t.b, t.c}) {
            polygon.push_back({decodePosition(vertices[v], t.step()), decodeNormal(vertices[v]), vertices[v].look});
            spared = spared && isSpared(looks[vertices[v].look].atom);
        }
        if (!spared) {
            polygon = cutPolygon(polygon, [&](const glm::vec3& p) { return depth_(p) - clip_.near; });
            polygon = cutPolygon(polygon, [&](const glm::vec3& p) { return clip_.far - depth_(p); });
        }
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const CutCorner& corner : polygon) {
            mesh.positions.push_back(corner.place);
            mesh.normals.push_back(glm::normalize(corner.normal));
            mesh.atoms.push_back(corner.look);
        }
        for (std::uint32_t i = 2; i < polygon.size(); ++i) mesh.triangles.emplace_back(first, first + i - 1, first + i);
    }

    Representation& scene_;
    const Depth depth_;
    const Clip& clip_;
    const std::vector<bool>& chosen_;
};

}  // namespace

bool cutScene(Representation& scene, const View& view, const Clip& clip, const std::vector<bool>& chosen) {
    if (!clip.on()) return true;
    if (!scene.copies.transforms.empty()) return false;
    Representation caps = meshCaps(scene, view, clip);
    if (const std::uint32_t color = packedCapColor(clip))
        for (SphereLook& look : caps.meshLooks) look.color = color;
    SceneCutter cutter(scene, view, clip, chosen);
    cutter.cutSpheres();
    cutter.cutSticks(scene.cylinders, scene.cylinderLooks);
    cutter.cutSticks(scene.wires, scene.wireLooks);
    cutter.cutMeshes();
    scene.sphereModels.clear(), scene.cylinderModels.clear(), scene.triangleModels.clear();
    joinPart(scene, caps);
    return true;
}

}  // namespace nacre
