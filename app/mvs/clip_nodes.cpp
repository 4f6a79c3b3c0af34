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
#include "app/mvs/split_copies.h"
#include "engine/molecule/text.h"
#include "engine/scene/instances/copies.h"
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
    if (!isRigid(glm::dmat4x3(turn))) refusePrimitive("its rotation stretches, skews or shrinks");
    return turn;
}

template <typename Item, typename Center>
void dropCut(std::vector<Item>& items, const ClipRegions& regions, const Center& getCenter) {
    std::erase_if(items, [&](const Item& item) { return regions.cuts(getCenter(item)); });
}

void clipMesh(const ClipRegions& regions, Primitives::Mesh& mesh) {
    const bool each = hasLooksOfTriangles(mesh);
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

double ClipRegions::Region::depth(const glm::dvec3& point) const {
    const glm::dvec3 own = toOwn * glm::dvec4(point, 1.0);
    if (shape == Shape::plane) return own.y;
    return 1 -
           (shape == Shape::ball ? glm::length(own) : std::max({std::abs(own.x), std::abs(own.y), std::abs(own.z)}));
}

bool ClipRegions::cuts(const glm::dvec3& point) const {
    return std::ranges::any_of(regions_,
                               [&](const Region& region) { return (region.depth(point) >= 0) != region.inverted; });
}

ClipRegions::Cut ClipRegions::cutsBall(const glm::dvec3& center, double radius) const {
    Cut cut = Cut::none;
    for (const Region& region : regions_) {
        double square = 0;  // no direction is stretched more than by its root
        for (int i = 0; i < 3; ++i) square += glm::dot(region.toOwn[i], region.toOwn[i]);
        const double depth = region.depth(center);
        if (std::abs(depth) <= radius * std::sqrt(square))
            cut = Cut::some;
        else if ((depth > 0) != region.inverted)
            return Cut::all;
    }
    return cut;
}

void clipLayer(const ClipRegions& regions, const Structure& s, SceneLayer& layer) {
    const bool byResidue = layer.style == Style::cartoon || layer.style == Style::backbone;
    std::vector<glm::dmat4x3> motions;  // by list
    for (const std::vector<std::uint32_t>& list : s.lists)
        motions.push_back(listMotions(s, s.transforms[list.front()]).front());
    if (motions.empty()) motions.push_back(findFirstMotion(s));
    const auto list = [&](std::uint32_t atom) { return listOfCopies(s, s.molecule->atoms[atom].residue); };
    keepAtoms(layer, [&](std::size_t i) { return list(layer.atoms[i]) != UINT32_MAX; });
    const auto place = [&](std::uint32_t atom) {
        return glm::dvec3(motions[list(atom)] * glm::dvec4(glm::dvec3(s.molecule->atoms[atom].position), 1.0));
    };
    if (!regions.cutObjects() && !byResidue)
        return keepAtoms(layer, [&](std::size_t i) { return !regions.cuts(place(layer.atoms[i])); });
    const auto findGroup = [&](std::uint32_t atom) {
        const std::uint32_t index = s.molecule->atoms[atom].residue;
        const Residue& residue = s.molecule->residues[index];
        const std::uint32_t chain = s.molecule->subchains.empty() ? residue.chain : residue.subchain;
        return std::pair(list(atom), regions.cutObjects() ? chain : index);
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<glm::dvec4>> groups;
    for (const std::uint32_t atom : layer.atoms) groups[findGroup(atom)].emplace_back(place(atom), 0.0);
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> cut;
    for (const auto& [group, points] : groups) cut[group] = regions.cuts(extremeSphere(points).center);
    keepAtoms(layer, [&](std::size_t i) { return !cut[findGroup(layer.atoms[i])]; });
}

std::optional<Structure> separateCut(const Node& node, const ClipRegions& regions, const Structure& s,
                                     SceneLayer& layer, SceneFiles& files, SceneWarnings& warnings) {
    if (layer.atoms.empty()) return std::nullopt;
    if (std::max<std::size_t>(s.transforms.size(), 1) * std::max<std::size_t>(s.instances.size(), 1) > kMostCopies) {
        warnings.add(node, "it is not clipped: its structure has more than " + std::to_string(kMostCopies) + " copies");
        return std::nullopt;
    }
    const std::size_t atoms = s.molecule->atoms.size();
    const Bounds ball = boundsOfEach([&](const auto& visit) {
        for (const std::uint32_t atom : layer.atoms) visit(glm::dvec3(s.molecule->atoms[atom].position), 0);
    });
    // All that stay whole are one group; each that is cut through is one of its own.
    std::vector<std::uint32_t> groups;
    std::uint32_t count = 0, whole = kNoGroup;
    std::vector<glm::dmat4x3> copies = s.transforms;
    if (copies.empty()) copies.emplace_back(1.0);
    for (const glm::dmat4x3& copy : copies)
        for (const glm::dmat4x3& motion : listMotions(s, copy)) {
            using Cut = ClipRegions::Cut;
            constexpr double kStretch = 1.01;  // motions count as rigid up to 1.005
            const Cut cut = regions.cutsBall(motion * glm::dvec4(ball.center, 1.0), kStretch * ball.radius);
            if (cut == Cut::none && whole == kNoGroup) whole = count++;
            groups.push_back(cut == Cut::all ? kNoGroup : cut == Cut::none ? whole : count++);
        }
    const bool isSplit = std::ranges::any_of(groups, [&](std::uint32_t group) { return group != whole; });
    if (count == 0) keepAtoms(layer, [](std::size_t) { return false; });
    if (count == 0 || !isSplit) return std::nullopt;
    if (count * atoms > kMostCutAtoms) {
        warnings.add(node, "it is not clipped: the copies that its clip cuts have more than " +
                               std::to_string(kMostCutAtoms) + " atoms together");
        return std::nullopt;
    }
    files.countCopied(node, count * atoms);
    Structure own = s.copied();
    foldInstances(node, own);
    splitCopies(groups, count, own);
    const SceneLayer once = layer;
    for (std::uint32_t group = 1; group < count; ++group) {
        for (const std::uint32_t atom : once.atoms)
            layer.atoms.push_back(atom + static_cast<std::uint32_t>(group * atoms));
        layer.colors.insert(layer.colors.end(), once.colors.begin(), once.colors.end());
        layer.opacity.insert(layer.opacity.end(), once.opacity.begin(), once.opacity.end());
    }
    clipLayer(regions, own, layer);
    return own;
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
