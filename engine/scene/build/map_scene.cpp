#include "engine/scene/build/map_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/error.h"
#include "engine/scene/build/mesh_scene.h"
#include "engine/scene/build/mesh_streams.h"
#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

constexpr float kDotLength = 0.04f;  // Å along the normal: seen from most sides, a dot is as wide as long

/// The colour of each vertex of a contour. Step kSteps stands for the contour's own colour.
struct VertexColors {
    std::vector<std::uint32_t> steps;  // empty: all are kSteps
    std::vector<std::uint32_t> colors;

    VertexColors(const std::vector<glm::vec3>& positions, const MapContour& contour, Representation& scene) {
        if (!contour.values || positions.empty()) {
            colors.assign(1, contour.color);
            return;
        }
        std::vector<double> values;
        values.reserve(positions.size());
        for (const glm::vec3& p : positions)
            values.push_back(valueAt(*contour.values->map, glm::dvec3(p) + scene.center));
        const ValueColors of(*contour.values, values, Palette::viridis);
        for (const double value : values) steps.push_back(of.toStep(value));
        for (std::uint32_t step = 0; step <= ValueColors::kSteps; ++step)
            colors.push_back(of.stepColor(step, contour.color));
        scene.legends.push_back(of.legend(contour.values->name));
        scene.blendsColors = true;
    }
    std::uint32_t at(std::size_t vertex) const { return colors[steps.empty() ? 0 : steps[vertex]]; }
};

void addWires(const Isosurface& surface, const MapContour& contour, Representation& scene) {
    const auto radius = static_cast<float>(-contour.width / 2);
    const VertexColors colors(surface.positions, contour, scene);
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, std::size_t vertexA, std::size_t vertexB) {
        if (a == b) return;
        scene.wires.push_back({a, radius, b, 0});
        scene.wireLooks.push_back({colors.at(vertexA), colors.at(vertexB), 0, 0});
    };
    if (contour.style == MapStyle::mesh) {
        scene.wires.reserve(scene.wires.size() + surface.lines.size());
        scene.wireLooks.reserve(scene.wires.size() + surface.lines.size());
        for (const glm::uvec2& line : surface.lines)
            add(surface.positions[line.x], surface.positions[line.y], line.x, line.y);
    } else {
        scene.wires.reserve(scene.wires.size() + surface.positions.size());
        for (std::size_t i = 0; i < surface.positions.size(); ++i) {
            const glm::vec3 half = surface.normals[i] * (kDotLength / 2);
            add(surface.positions[i] - half, surface.positions[i] + half, i, i);
        }
    }
    for (const Cylinder& wire : scene.wires)
        scene.radius = std::max<double>({scene.radius, glm::length(wire.a), glm::length(wire.b)});
}

/// Adds a mesh. Its list of atoms holds the number of each vertex's colour.
void addColored(const Mesh& mesh, const std::vector<std::uint32_t>& colors, double opacity, Representation& scene) {
    appendMesh(
        mesh, {},
        [&](std::uint32_t number) {
            return SphereLook{withOpacity(colors[number], opacity), 0};
        },
        scene);
    scene.meshes.back().closed = false;  // a map's box cuts it
    scene.radius = std::max(scene.radius, meshReach(scene));
}

/// The list with one copy, the identity.
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

/// Makes the joined primitives of a stream, `first` to `end`, a run of their own, if the scene has runs of copies or
/// models. @param model  number of the run's model; 0: no models
void keepApart(Representation& scene, std::size_t first, std::size_t end, std::uint32_t model,
               std::vector<PrimitiveRun> Copies::*runs, std::vector<ModelRun> Representation::*models) {
    if (first == end) return;
    const auto from = static_cast<std::uint32_t>(first), count = static_cast<std::uint32_t>(end - first);
    if (!scene.copies.transforms.empty())
        (scene.copies.*runs).push_back({from, count, stillList(scene.copies), {}, scene.radius});
    if (model > 0) (scene.*models).push_back({from, count, model});
}

/// Model number for a scene that is joined to another: after all of its models; 0 if there are none.
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
    if (contour.cuts) {
        const auto isCut = [&](const auto& corners) {
            glm::dvec3 sum(0);
            for (int i = 0; i < corners.length(); ++i) sum += surface.positions[corners[i]];
            return contour.cuts(sum / static_cast<double>(corners.length()) + scene.center);
        };
        std::erase_if(surface.triangles, isCut);
        std::erase_if(surface.lines, isCut);
    }
    if (contour.style != MapStyle::surface) return addWires(surface, contour, scene);
    if (surface.triangles.empty()) return;
    Mesh mesh;
    VertexColors colors(surface.positions, contour, scene);
    mesh.atoms = std::move(colors.steps);
    mesh.atoms.resize(surface.positions.size(), 0);
    mesh.positions = std::move(surface.positions);
    mesh.normals = std::move(surface.normals);
    mesh.triangles = std::move(surface.triangles);
    addColored(mesh, colors.colors, contour.opacity, scene);
}

namespace {

/// Adds the part of a triangle whose values are not below a level. @param values  by vertex; grows with the mesh
void addAbove(double level, const std::array<std::uint32_t, 3>& corners, std::vector<double>& values, Mesh& mesh) {
    std::array<std::uint32_t, 4> kept{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = corners[i], b = corners[(i + 1) % 3];
        if (values[a] >= level) kept[count++] = a;
        if ((values[a] >= level) == (values[b] >= level)) continue;
        const double share = (level - values[a]) / (values[b] - values[a]);
        kept[count++] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(glm::mix(mesh.positions[a], mesh.positions[b], static_cast<float>(share)));
        values.push_back(level);
    }
    for (std::size_t i = 2; i < count; ++i) mesh.triangles.emplace_back(kept[0], kept[i - 1], kept[i]);
}

}  // namespace

void addSlice(const MapRegion& region, const MapSlice& slice, const ValueColoring& values, Representation& scene) {
    if (region.empty()) return;
    const DensityMap& map = region.map();
    const int across = slice.axis, u = (across + 1) % 3, v = (across + 2) % 3;
    const glm::ivec3& size = region.size();
    if (1.0 * size[u] * size[v] > static_cast<double>(kMostSliceNodes))
        throw Error("cannot draw map", map.name, "a slice of it has more than 4 million nodes (--map-around SEL)");
    glm::dvec3 node(region.first());
    node[across] += slice.place * (size[across] - 1);
    const glm::dvec3 corner = node;
    Mesh mesh;
    std::vector<double> found;
    const glm::vec3 normal(glm::normalize(glm::cross(map.step[u], map.step[v])));
    for (int j = 0; j < size[v]; ++j)
        for (int i = 0; i < size[u]; ++i) {
            node[u] = corner[u] + i;
            node[v] = corner[v] + j;
            const glm::dvec3 place = map.place(node);
            found.push_back(valueAt(*values.map, place));
            mesh.positions.emplace_back(place - scene.center);
        }
    const ValueColors of(values, found, Palette::grays, false);
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (std::isnan(found[a] + found[b] + found[c])) return;
        const glm::dvec3 middle = glm::dvec3(mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0;
        if (!slice.cuts || !slice.cuts(middle + scene.center)) addAbove(slice.least, {a, b, c}, found, mesh);
    };
    const auto row = static_cast<std::uint32_t>(size[u]);
    for (std::uint32_t j = 0; j + 1 < static_cast<std::uint32_t>(size[v]); ++j)
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t at = j * row + i;
            add(at, at + 1, at + row + 1);
            add(at, at + row + 1, at + row);
        }
    if (mesh.triangles.empty()) return;
    for (const double value : found) mesh.atoms.push_back(of.toStep(value));
    mesh.normals.assign(mesh.positions.size(), normal);
    std::vector<std::uint32_t> colors;
    for (std::uint32_t step = 0; step <= ValueColors::kSteps; ++step) colors.push_back(of.stepColor(step, 0xff000000u));
    addColored(mesh, colors, slice.opacity, scene);
    scene.blendsColors = true;
    scene.legends.push_back(of.legend(values.name));
}

namespace {

/// @param numbers  added to those of the looks
void join(Representation& scene, const Representation& others, std::uint32_t numbers) {
    const std::size_t spheres = scene.spheres.size(), cylinders = scene.cylinders.size(),
                      triangles = scene.triangles.size();
    const std::uint32_t model = modelBehind(scene);
    const auto numbered = [&](std::uint32_t number) { return number > 0 ? number + numbers : 0; };
    const auto joinSticks = [&](std::vector<CylinderLook>& looks, const std::vector<CylinderLook>& joined) {
        for (const CylinderLook& look : joined)
            looks.push_back({look.colorA, look.colorB, numbered(look.atomA), numbered(look.atomB)});
    };
    if (!others.ellipsoids.empty()) {
        scene.ellipsoids.resize(spheres);
        append(scene.ellipsoids, others.ellipsoids);
        scene.cutsOctants = others.cutsOctants;
    }
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
    scene.blendsColors |= others.blendsColors;
    scene.ownMaterials |= others.ownMaterials;
    if (others.volume) scene.volume = others.volume;
}

}  // namespace

void joinScenes(Representation& scene, const Representation& others) {
    join(scene, others, static_cast<std::uint32_t>(scene.atomGroups.size()));
}

void joinPart(Representation& scene, const Representation& part) { join(scene, part, 0); }

}  // namespace nacre
