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

/// Where a scene keeps apart what moves or occludes together, what is joined to it is a part of its own: what a stream
/// has from `first` on. @param model  its number among the models; 0: there are none
void keepApart(Representation& scene, std::size_t first, std::size_t end, std::uint32_t model,
               std::vector<PrimitiveRun> Copies::*runs, std::vector<ModelRun> Representation::*models) {
    if (first == end) return;
    const auto from = static_cast<std::uint32_t>(first), count = static_cast<std::uint32_t>(end - first);
    if (!scene.copies.transforms.empty())
        (scene.copies.*runs).push_back({from, count, stillList(scene.copies), {}, scene.radius});
    if (model > 0) (scene.*models).push_back({from, count, model});
}

/// Of what is joined to a scene of several models: behind them; 0 where there is one.
std::uint32_t modelBehind(const Representation& scene) {
    std::uint32_t model = 0;
    for (const auto* runs : {&scene.sphereModels, &scene.cylinderModels, &scene.triangleModels})
        for (const ModelRun& run : *runs) model = std::max(model, run.model + 1);
    return model;
}

template <typename T>
void append(std::vector<T>& list, const std::vector<T>& others) {
    list.insert(list.end(), others.begin(), others.end());
}

void joinMeshes(Representation& scene, const Representation& others, std::uint32_t numbers) {
    const auto vertices = static_cast<std::uint32_t>(scene.meshVertices.size()),
               looks = static_cast<std::uint32_t>(scene.meshLooks.size()),
               triangles = static_cast<std::uint32_t>(scene.triangles.size()),
               coarse = static_cast<std::uint32_t>(scene.coarseTriangles.size());
    for (MeshVertex v : others.meshVertices) {
        v.look += looks;
        scene.meshVertices.push_back(v);
    }
    for (SphereLook look : others.meshLooks) {
        if (look.atom > 0) look.atom += numbers;
        scene.meshLooks.push_back(look);
    }
    const auto join = [&](std::vector<Triangle>& stream, const std::vector<Triangle>& joined) {
        for (Triangle t : joined) {
            t.a += vertices, t.b += vertices, t.c += vertices;
            stream.push_back(t);
        }
    };
    join(scene.triangles, others.triangles);
    join(scene.coarseTriangles, others.coarseTriangles);
    for (MeshRun run : others.meshes) {
        run.first += triangles;
        run.firstVertex += vertices, run.endVertex += vertices;
        for (MeshRun::Level& level : run.levels) level.first += coarse, level.endVertex += vertices;
        scene.meshes.push_back(std::move(run));
    }
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

void joinScenes(Representation& scene, const Representation& others) {
    const std::size_t spheres = scene.spheres.size(), cylinders = scene.cylinders.size(),
                      triangles = scene.triangles.size();
    const auto numbers = static_cast<std::uint32_t>(scene.atomGroups.size());
    const std::uint32_t model = modelBehind(scene);
    const auto numbered = [&](std::uint32_t number) { return number > 0 ? number + numbers : 0; };
    const auto joinSticks = [&](std::vector<CylinderLook>& looks, const std::vector<CylinderLook>& joined) {
        for (const CylinderLook& look : joined)
            looks.push_back({look.colorA, look.colorB, numbered(look.atomA), numbered(look.atomB)});
    };
    append(scene.spheres, others.spheres);
    for (const SphereLook& look : others.sphereLooks) scene.sphereLooks.push_back({look.color, numbered(look.atom)});
    append(scene.cylinders, others.cylinders);
    joinSticks(scene.cylinderLooks, others.cylinderLooks);
    append(scene.wires, others.wires);
    joinSticks(scene.wireLooks, others.wireLooks);
    joinMeshes(scene, others, numbers);
    scene.radius = std::max(scene.radius, others.radius);
    using R = Representation;
    keepApart(scene, spheres, scene.spheres.size(), model, &Copies::spheres, &R::sphereModels);
    keepApart(scene, cylinders, scene.cylinders.size(), model, &Copies::cylinders, &R::cylinderModels);
    keepApart(scene, triangles, scene.triangles.size(), model, &Copies::triangles, &R::triangleModels);
}

}  // namespace nacre
