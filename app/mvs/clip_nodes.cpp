#include "app/mvs/clip_nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <stdexcept>

#include "app/mvs/primitive_values.h"
#include "engine/molecule/text.h"
#include "engine/scene/view/scene_camera.h"

namespace nacre::app::mvs {
namespace {

glm::dvec3 neededPoint(const Node& node, const char* name) {
    const Json* value = node.param(name);
    if (!value) refusePrimitive(std::string("it has no ") + name);
    return vectorIn(name, *value);
}

double positive(double value, const char* name) {
    if (!(value > 0)) refusePrimitive(std::string(name) + " is not above 0");
    return value;
}

/// Applies a shift, then a linear map.
glm::dmat4x3 shiftedMap(const glm::dmat3& map, const glm::dvec3& origin) {
    return glm::dmat4x3(map[0], map[1], map[2], -(map * origin));
}

glm::dmat3 readRotation(const Node& node) {
    const Json* value = node.param("rotation");
    if (!value) return glm::dmat3(1.0);
    const std::vector<double> numbers = numbersIn("rotation", *value, 9);
    const glm::dmat3 turn = glm::make_mat3(numbers.data());
    const glm::dmat3 square = glm::transpose(turn) * turn;
    for (int i = 0; i < 9; ++i)
        if (!(std::abs(square[i / 3][i % 3] - (i % 4 == 0 ? 1.0 : 0.0)) <= 0.01))
            refusePrimitive("its rotation stretches, skews or shrinks");
    return turn;
}

template <typename Item, typename Center>
void dropCut(std::vector<Item>& items, const ClipRegions& regions, const Center& getCenter) {
    std::erase_if(items, [&](const Item& item) { return regions.cuts(getCenter(item)); });
}

void clipMesh(const ClipRegions& regions, Primitives::Mesh& mesh) {
    const bool each = mesh.looks.size() == mesh.triangles.size();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        glm::dvec3 sum(0);
        for (const std::uint32_t corner : mesh.triangles[i]) sum += mesh.positions[corner];
        if (regions.cuts(sum / 3.0)) continue;
        mesh.triangles[kept] = mesh.triangles[i];
        if (each) mesh.looks[kept] = mesh.looks[i];
        ++kept;
    }
    mesh.triangles.resize(kept);
    if (each) mesh.looks.resize(kept);
}

}  // namespace

ClipRegions::ClipRegions(const Node& parent, SceneWarnings& warnings) {
    for (const Node& node : parent.children) {
        if (node.kind != "clip") continue;
        const std::string type = nodeText(node, "type");
        const NodeRow* row = nodeRow("clip:" + type);
        if (!row) {
            warnings.add(node, "there is no clip type '" + nacre::printable(type, 40) + "': it is left out");
            continue;
        }
        tellUnused(node, *row, warnings);
        try {
            if (regions_.empty()) cutObjects_ = nodeText(node, "variant") == "object";
            regions_.push_back(readRegion(node, type));
        } catch (const std::invalid_argument& why) {
            warnings.add(node, why.what() + std::string(": it is left out"));
        }
    }
}

ClipRegions::Region ClipRegions::readRegion(const Node& node, const std::string& type) {
    Region region{Region::Shape::plane};
    if (type == "plane") {
        const glm::dvec3 normal = neededPoint(node, "normal");
        if (!(glm::length(normal) > 1e-9)) refusePrimitive("its normal has no length");
        const glm::dvec3 y = glm::normalize(normal);  // x and z do not matter
        region.toOwn =
            shiftedMap(glm::transpose(glm::dmat3(glm::dvec3(0), y, glm::dvec3(0))), neededPoint(node, "point"));
    } else if (type == "sphere") {
        region.shape = Region::Shape::ball;
        const double radius = positive(number(node, "radius", 1), "radius");
        region.toOwn = shiftedMap(glm::dmat3(1 / radius), neededPoint(node, "center"));
    } else {
        region.shape = Region::Shape::cube;
        const Json* given = node.param("size");
        const glm::dvec3 half = (given ? vectorIn("size", *given) : glm::dvec3(1)) / 2.0;
        glm::dmat3 scale(0);
        for (int i = 0; i < 3; ++i) scale[i][i] = 1 / positive(half[i], "size");
        region.toOwn = shiftedMap(scale * glm::transpose(readRotation(node)), neededPoint(node, "center"));
    }
    if (const Json* first = node.param("check_transform")) {
        const std::vector<double> matrix = numbersIn("check_transform", *first, 16);
        region.toOwn = joinedMotion(region.toOwn, glm::dmat4x3(glm::make_mat4(matrix.data())));
    }
    region.inverted = flag(node, "invert", false);
    return region;
}

bool ClipRegions::cuts(const glm::dvec3& point) const {
    return std::any_of(regions_.begin(), regions_.end(), [&](const Region& region) {
        const glm::dvec3 own = region.toOwn * glm::dvec4(point, 1.0);
        const bool inside = region.shape == Region::Shape::plane ? own.y >= 0
                            : region.shape == Region::Shape::ball
                                ? glm::length(own) <= 1
                                : std::max({std::abs(own.x), std::abs(own.y), std::abs(own.z)}) <= 1;
        return inside != region.inverted;
    });
}

void clipLayer(const Node& representation, const Structure& s, SceneLayer& layer, SceneWarnings& warnings) {
    const ClipRegions regions(representation, warnings);
    if (regions.empty()) return;
    if (s.transforms.size() > 1 || s.instances.size() > 1)
        return warnings.add(representation, "a structure with copies is not clipped");
    const glm::dmat4x3 motion = findFirstMotion(s);
    const bool byResidue = layer.style == Style::cartoon || layer.style == Style::backbone;
    const auto place = [&](std::uint32_t atom) {
        return glm::dvec3(motion * glm::dvec4(glm::dvec3(s.molecule->atoms[atom].position), 1.0));
    };
    if (!regions.cutObjects() && !byResidue)
        return keepAtoms(layer, [&](std::size_t i) { return !regions.cuts(place(layer.atoms[i])); });
    const auto findGroup = [&](std::uint32_t atom) {
        const std::uint32_t index = s.molecule->atoms[atom].residue;
        const Residue& residue = s.molecule->residues[index];
        return !regions.cutObjects() ? index : s.molecule->subchains.empty() ? residue.chain : residue.subchain;
    };
    std::map<std::uint32_t, std::vector<glm::dvec4>> groups;
    for (const std::uint32_t atom : layer.atoms) groups[findGroup(atom)].emplace_back(place(atom), 0.0);
    std::map<std::uint32_t, bool> cut;
    for (const auto& [group, points] : groups) cut[group] = regions.cuts(extremeSphere(points).center);
    keepAtoms(layer, [&](std::size_t i) { return !cut[findGroup(layer.atoms[i])]; });
}

void clipPrimitives(const ClipRegions& regions, Primitives& p) {
    if (regions.empty()) return;
    dropCut(p.lines, regions, [](const Primitives::Line& line) { return (line.a + line.b) / 2.0; });
    dropCut(p.arrows, regions, [](const Primitives::Arrow& arrow) { return (arrow.from + arrow.to) / 2.0; });
    dropCut(p.balls, regions, [](const Primitives::Ball& ball) { return ball.center; });
    dropCut(p.ellipsoids, regions, [](const Primitives::Ellipsoid& ellipsoid) { return ellipsoid.center; });
    dropCut(p.ellipses, regions, [](const Primitives::Ellipse& ellipse) { return ellipse.center; });
    dropCut(p.boxes, regions, [](const Primitives::Box& box) { return box.center; });
    dropCut(p.labels, regions, [](const Primitives::Label& label) { return label.at; });
    for (Primitives::Mesh& mesh : p.meshes) clipMesh(regions, mesh);
    std::erase_if(p.meshes, [](const Primitives::Mesh& mesh) { return mesh.triangles.empty(); });
}

}  // namespace nacre::app::mvs
