#include "engine/scene/map_scene.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "engine/scene/colors.h"
#include "engine/scene/mesh_scene.h"
#include "engine/scene/mesh_streams.h"

namespace nacre {
namespace {

constexpr float kDotLength = 0.04f;  // Å along the normal: seen from most sides a dot as wide as it is long

void addWires(const Isosurface& surface, const MapContour& contour, Representation& scene) {
    const auto radius = static_cast<float>(-contour.width / 2);
    const CylinderLook look{contour.color, contour.color, 0, 0};
    const auto add = [&](const glm::vec3& a, const glm::vec3& b) {
        if (a != b) scene.wires.push_back({a, radius, b, 0});
    };
    if (contour.style == MapStyle::mesh) {
        scene.wires.reserve(scene.wires.size() + surface.lines.size());
        for (const glm::uvec2& line : surface.lines) add(surface.positions[line.x], surface.positions[line.y]);
    } else {
        scene.wires.reserve(scene.wires.size() + surface.positions.size());
        for (std::size_t i = 0; i < surface.positions.size(); ++i) {
            const glm::vec3 half = surface.normals[i] * (kDotLength / 2);
            add(surface.positions[i] - half, surface.positions[i] + half);
        }
    }
    scene.wireLooks.resize(scene.wires.size(), look);
    for (const Cylinder& wire : scene.wires)
        scene.radius = std::max<double>({scene.radius, glm::length(wire.a), glm::length(wire.b)});
}

/// The list of the one copy that stands where it is stored.
std::uint32_t stillList(Copies& copies) {
    const auto placeIn = [](auto& list, const auto& value) {
        const auto found = std::find(list.begin(), list.end(), value);
        const auto at = static_cast<std::uint32_t>(found - list.begin());
        if (found == list.end()) list.push_back(value);
        return at;
    };
    const std::uint32_t still = placeIn(copies.transforms, glm::dmat4x3(1.0));
    return placeIn(copies.lists, std::vector<std::uint32_t>{still});
}

/// Where a scene keeps apart what moves or occludes together, maps are a part of their own.
void keepApart(std::uint32_t first, std::uint32_t count, Representation& scene) {
    if (count == 0) return;
    if (!scene.copies.transforms.empty())
        scene.copies.triangles.push_back({first, count, stillList(scene.copies), {}, scene.radius});
    if (scene.triangleModels.empty() && scene.sphereModels.empty()) return;
    std::uint32_t model = 0;
    for (const auto* runs : {&scene.sphereModels, &scene.cylinderModels, &scene.triangleModels})
        for (const ModelRun& run : *runs) model = std::max(model, run.model + 1);
    scene.triangleModels.push_back({first, count, model});
}

}  // namespace

void addContour(const MapRegion& region, const MapContour& contour, Representation& scene) {
    const IsosurfaceParts parts = contour.style == MapStyle::surface ? IsosurfaceParts::triangles
                                  : contour.style == MapStyle::mesh  ? IsosurfaceParts::lines
                                                                     : IsosurfaceParts::vertices;
    Isosurface surface = region.at(contour.level, contour.above, parts, scene.center);
    if (contour.style != MapStyle::surface) return addWires(surface, contour, scene);
    if (surface.triangles.empty()) return;
    Mesh mesh;
    mesh.atoms.assign(surface.positions.size(), 0);
    mesh.positions = std::move(surface.positions);
    mesh.normals = std::move(surface.normals);
    mesh.triangles = std::move(surface.triangles);
    const std::uint32_t color = withOpacity(contour.color, static_cast<float>(contour.opacity));
    appendMesh(
        mesh, {},
        [&](std::uint32_t) {
            return SphereLook{color, 0};
        },
        scene);
    scene.radius = std::max(scene.radius, meshReach(scene));
}

void joinMaps(Representation& scene, const Representation& maps) {
    scene.wires.insert(scene.wires.end(), maps.wires.begin(), maps.wires.end());
    scene.wireLooks.insert(scene.wireLooks.end(), maps.wireLooks.begin(), maps.wireLooks.end());
    scene.radius = std::max(scene.radius, maps.radius);
    if (maps.triangles.empty()) return;
    const auto vertices = static_cast<std::uint32_t>(scene.meshVertices.size()),
               looks = static_cast<std::uint32_t>(scene.meshLooks.size()),
               triangles = static_cast<std::uint32_t>(scene.triangles.size());
    for (MeshVertex v : maps.meshVertices) {
        v.look += looks;
        scene.meshVertices.push_back(v);
    }
    scene.meshLooks.insert(scene.meshLooks.end(), maps.meshLooks.begin(), maps.meshLooks.end());
    for (Triangle t : maps.triangles) {
        t.a += vertices, t.b += vertices, t.c += vertices;
        scene.triangles.push_back(t);
    }
    for (MeshRun run : maps.meshes) {
        run.first += triangles;
        run.firstVertex += vertices, run.endVertex += vertices;
        scene.meshes.push_back(std::move(run));
    }
    keepApart(triangles, static_cast<std::uint32_t>(maps.triangles.size()), scene);
}

}  // namespace nacre
