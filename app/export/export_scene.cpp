#include "app/export/export_scene.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <glm/geometric.hpp>
#include <map>
#include <unordered_map>

#include "engine/error.h"
#include "engine/mesh/ellipsoids.h"
#include "engine/mesh/solids.h"
#include "engine/scene/build/atom_ellipsoids.h"
#include "engine/scene/color/colors.h"

namespace nacre::app {
namespace {

constexpr int kFinestSides = 24, kCoarsestSides = 8;
constexpr double kAimedTriangles = 1e7;

double trianglesOfBall(int sides) { return static_cast<double>(sides) * (sides - 2); }
double trianglesOfStick(int sides) { return 6.0 * sides; }

/// Primitives with the same copies and name.
struct ExportGroup {
    std::uint32_t list = 0;
    std::string chain, kind;
    std::uint32_t color = 0;  ///< of instances
    auto operator<=>(const ExportGroup&) const = default;
};

Error tooManyTriangles(std::size_t count, const char* advice = "fewer --sides, or --atoms instanced") {
    return {"cannot export molecule", "",
            "it would have " + std::to_string(count) + " triangles, more than the limit of " +
                std::to_string(kMostExportTriangles) + " (" + advice + ")"};
}

class SceneExporter {
public:
    SceneExporter(const Molecule& molecule, const Representation& scene, const ExportOptions& options)
        : molecule_(molecule), scene_(scene), instances_(options.instances), baked_(options.occlusion) {
        result_.center = scene.center;
        result_.sides = options.sides ? options.sides : sidesThatFit();
        if (!instances_) pieces_ = ellipsoidPieces(countEllipsoids());
    }

    ExportScene run() {
        eachList(scene_.copies.triangles, scene_.triangles.size(), [&](auto i, auto list) { addTriangle(i, list); });
        eachList(scene_.copies.spheres, scene_.spheres.size(), [&](auto i, auto list) { addSphere(i, list); });
        eachList(scene_.copies.cylinders, scene_.cylinders.size(), [&](auto i, auto list) { addStick(i, list); });
        for (auto& [group, mesh] : meshes_) addMesh(group, std::move(mesh.mesh), mesh.occlusion);
        checkInstances();
        for (auto& [group, instances] : placed_) addInstances(group, std::move(instances));
        if (triangleCount(result_) > kMostExportTriangles) throw tooManyTriangles(triangleCount(result_));
        return std::move(result_);
    }

private:
    struct GroupMesh {
        Mesh mesh;
        std::unordered_map<std::uint64_t, std::uint32_t> places;  ///< mesh vertex by scene vertex and colour
        std::vector<float> occlusion;                             ///< of the mesh's vertices
    };

    int sidesThatFit() const {
        const double copies = std::max<double>(1, static_cast<double>(scene_.copies.transforms.size()));
        int sides = kFinestSides;
        const auto triangles = [&] {
            return copies * (trianglesOfBall(sides) * static_cast<double>(scene_.spheres.size()) +
                             trianglesOfStick(sides) * static_cast<double>(scene_.cylinders.size()));
        };
        while (sides > kCoarsestSides && triangles() > kAimedTriangles) sides -= 4;
        return sides;
    }

    /// In all copies. @throws Error if even the coarsest would have too many triangles
    std::size_t countEllipsoids() const {
        std::size_t count = 0;
        eachList(scene_.copies.spheres, scene_.spheres.size(),
                 [&](auto i, auto list) { count += scene_.ellipsoid(i) ? listCopies(list).size() : 0; });
        const std::size_t triangles = count * trianglesPerEllipsoid(ellipsoidPieces(count));
        if (triangles > kMostExportTriangles) throw tooManyTriangles(triangles, "--atoms instanced");
        return count;
    }

    /// Visits each primitive with the list of its copies.
    template <typename Visit>
    static void eachList(const std::vector<PrimitiveRun>& runs, std::size_t count, const Visit& visit) {
        if (runs.empty())
            for (std::size_t i = 0; i < count; ++i) visit(i, 0u);
        for (const PrimitiveRun& run : runs)
            for (std::size_t i = run.first; i < run.first + run.count; ++i) visit(i, run.list);
    }

    /// @param atom  1-based
    const std::string& chainName(std::uint32_t atom) const {
        static const std::string kNone;
        if (atom == 0 || scene_.noteNumber(atom) > 0) return kNone;  // belongs to a map or a primitive
        return molecule_.chains[molecule_.residues[molecule_.atoms[scene_.findAtom(atom) - 1].residue].chain].name;
    }

    GroupMesh& findMesh(std::uint32_t list, std::uint32_t atom, const char* kind) {
        const ExportGroup group{list, chainName(atom), kind, 0};
        if (last_ == meshes_.end() || last_->first != group) last_ = meshes_.try_emplace(group).first;
        return last_->second;
    }

    void addTriangle(std::size_t i, std::uint32_t list) {
        const Triangle& t = scene_.triangles[i];
        const std::uint32_t atom = scene_.meshLooks[scene_.meshVertices[t.a].look].atom;
        GroupMesh& group = findMesh(list, atom, atom == 0 ? "map" : scene_.noteNumber(atom) > 0 ? "geometry" : "fold");
        const auto colorOf = [&](std::uint32_t v) { return scene_.meshLooks[scene_.meshVertices[v].look].color; };
        // One for the triangle: other programs would blend those of its corners, as across a border of two chains.
        const std::uint32_t common = colorOf(t.b) == colorOf(t.c) ? colorOf(t.b) : colorOf(t.a);
        glm::uvec3 corners{};
        int corner = 0;
        for (const std::uint32_t v : {t.a, t.b, t.c}) {
            const std::uint32_t color = scene_.blendsColors ? colorOf(v) : common;
            const auto [place, added] = group.places.emplace(std::uint64_t{color} << 32 | v,
                                                             static_cast<std::uint32_t>(group.mesh.positions.size()));
            if (added) {
                const MeshVertex& vertex = scene_.meshVertices[v];
                addVertex(group.mesh, decodePosition(vertex, t.step()), decodeNormal(vertex), color);
                if (baked_) group.occlusion.push_back(baked_->ofVertex(v));
            }
            corners[corner++] = place->second;
        }
        group.mesh.triangles.push_back(corners);
    }

    /// Sets occlusion of new vertices in a group's mesh. @param getOcclusion  receives position and normal
    template <typename GetOcclusion>
    void occlude(GroupMesh& group, const GetOcclusion& getOcclusion) const {
        if (!baked_) return;
        for (std::size_t v = group.occlusion.size(); v < group.mesh.positions.size(); ++v)
            group.occlusion.push_back(getOcclusion(group.mesh.positions[v], group.mesh.normals[v]));
    }

    void addEllipsoid(Mesh& mesh, const glm::vec3& center, const EllipsoidRows& rows, std::uint32_t color) const {
        Ellipsoid ellipsoid{.center = center, .band = static_cast<double>(rows.band)};
        std::ranges::copy(rows.axes(), ellipsoid.axes.begin());
        nacre::addEllipsoid(mesh, ellipsoid, pieces_, color, bandColor(color));
    }

    void addSphere(std::size_t i, std::uint32_t list) {
        const Sphere& sphere = scene_.spheres[i];
        const SphereLook& look = scene_.sphereLooks[i];
        if (!instances_) {
            GroupMesh& group = findMesh(list, look.atom, "atoms");
            if (const EllipsoidRows* rows = scene_.ellipsoid(i))
                addEllipsoid(group.mesh, sphere.center, *rows, look.color);
            else
                addBall(group.mesh, sphere.center, sphere.radius, look.color, result_.sides);
            return occlude(group, [&](const glm::vec3&, const glm::vec3& normal) {
                return baked_->ofSphere(static_cast<std::uint32_t>(i), normal);
            });
        }
        ExportInstances::Place place{sphere.center, glm::quat(1, 0, 0, 0), glm::vec3(sphere.radius)};
        if (const EllipsoidRows* rows = scene_.ellipsoid(i)) {
            const auto [a, b, c] = rows->axes();
            place.scale = {glm::length(a), glm::length(b), glm::length(c)};
            place.turn =
                glm::normalize(glm::quat_cast(glm::mat3(a / place.scale.x, b / place.scale.y, c / place.scale.z)));
        }
        placed_[{list, chainName(look.atom), "atoms", look.color}].push_back(place);
    }

    void addStick(std::size_t i, std::uint32_t list) {
        const Cylinder& stick = scene_.cylinders[i];
        const CylinderLook& look = scene_.cylinderLooks[i];
        if (!instances_) {
            GroupMesh& group = findMesh(list, look.atomA, "sticks");
            addCylinder(group.mesh, stick.a, stick.b, stick.radius, look.colorA, look.colorB, result_.sides);
            return occlude(group, [&](const glm::vec3& at, const glm::vec3& normal) {
                const glm::vec3 span = stick.b - stick.a, axis = glm::normalize(span);
                // The centre of a flat end has its normal along the axis; then any direction around it serves.
                const glm::vec3 side = std::abs(glm::dot(normal, axis)) < 0.5f ? normal : at - stick.a;
                const float share = glm::dot(at - stick.a, axis) / glm::length(span);
                return baked_->ofCylinder(static_cast<std::uint32_t>(i), axis, side, share);
            });
        }
        const glm::vec3 middle = (stick.a + stick.b) / 2.0f;
        const bool whole = look.colorA == look.colorB && chainName(look.atomA) == chainName(look.atomB);
        addHalf(stick.a, whole ? stick.b : middle, stick.radius, {list, chainName(look.atomA), "sticks", look.colorA});
        if (!whole) addHalf(middle, stick.b, stick.radius, {list, chainName(look.atomB), "sticks", look.colorB});
    }

    void addHalf(const glm::vec3& a, const glm::vec3& b, float radius, const ExportGroup& group) {
        const float length = glm::length(b - a);
        if (!(length > 1e-6f)) return;
        const glm::vec3 way = (b - a) / length, z(0, 0, 1);
        // Rotates z to the given direction; the opposite of z needs an axis.
        const glm::quat turn = way.z < -0.99999f ? glm::quat(0, 1, 0, 0)
                                                 : glm::normalize(glm::quat(1 + glm::dot(z, way), glm::cross(z, way)));
        placed_[group].push_back({a, turn, {radius, radius, length}});
    }

    /// Copies of a list in an assembly, else the identity.
    std::vector<std::uint32_t> listCopies(std::uint32_t list) const {
        return scene_.copies.transforms.empty() ? std::vector<std::uint32_t>{0} : scene_.copies.lists[list];
    }
    glm::dmat4x3 copyTransform(std::uint32_t copy) const {
        return scene_.copies.transforms.empty() ? glm::dmat4x3(1.0) : scene_.copies.transforms[copy];
    }
    std::uint32_t copyColor(std::uint32_t color, std::uint32_t copy) const {
        const auto& colors = scene_.copies.colors;
        return isCopyTint(color) && !colors.empty() ? tintedColor(colors[copy % colors.size()], color) : color;
    }

    std::string groupName(const ExportGroup& group) const {
        return (group.chain.empty() ? std::string("molecule") : "chain " + group.chain) + ", " + group.kind;
    }

    /// Each copy of a group becomes a node of the file, about 2 kB during writing.
    void checkInstances() const {
        std::size_t copies = 0;
        for (const auto& placed : placed_) copies += listCopies(placed.first.list).size();
        if (copies > kMostExportCopies)
            throw Error("cannot export molecule", "",
                        "its instances would have " + std::to_string(copies) + " copies, more than the limit of " +
                            std::to_string(kMostExportCopies) + " (another --assembly, or fewer colours)");
    }

    /// Copies with different colours become meshes.
    template <typename Add>
    void byColorOfCopy(std::uint32_t list, bool tinted, const Add& add) {
        std::map<std::size_t, std::vector<std::uint32_t>> parts;
        for (const std::uint32_t copy : listCopies(list))
            parts[tinted ? copy % std::max<std::size_t>(scene_.copies.colors.size(), 1) : 0].push_back(copy);
        for (const auto& [color, copies] : parts) {
            std::vector<glm::dmat4x3> transforms;
            for (const std::uint32_t copy : copies) transforms.push_back(copyTransform(copy));
            add(copies.front(), std::move(transforms));
        }
    }

    void addMesh(const ExportGroup& group, Mesh mesh, const std::vector<float>& occlusion) {
        const bool tinted = std::any_of(mesh.atoms.begin(), mesh.atoms.end(), isCopyTint);
        byColorOfCopy(group.list, tinted, [&](std::uint32_t copy, std::vector<glm::dmat4x3> transforms) {
            Mesh colored = mesh;
            for (std::uint32_t& color : colored.atoms) color = copyColor(color, copy);
            result_.meshes.push_back({groupName(group), std::move(colored), std::move(transforms), occlusion});
        });
    }

    void addInstances(const ExportGroup& group, std::vector<ExportInstances::Place> places) {
        byColorOfCopy(
            group.list, isCopyTint(group.color), [&](std::uint32_t copy, std::vector<glm::dmat4x3> transforms) {
                const auto shape = group.kind == "atoms" ? ExportInstances::Shape::ball : ExportInstances::Shape::stick;
                result_.instances.push_back(
                    {groupName(group), shape, copyColor(group.color, copy), places, std::move(transforms)});
            });
    }

    const Molecule& molecule_;
    const Representation& scene_;
    bool instances_;
    int pieces_ = 0;  ///< of meshes of ellipsoids
    const BakedOcclusion* baked_;
    std::map<ExportGroup, GroupMesh> meshes_;
    std::map<ExportGroup, GroupMesh>::iterator last_ = meshes_.end();  // most recent result
    std::map<ExportGroup, std::vector<ExportInstances::Place>> placed_;
    ExportScene result_;
};

}  // namespace

ExportScene exportScene(const Molecule& molecule, const Representation& scene, const ExportOptions& options) {
    return SceneExporter(molecule, scene, options).run();
}

std::size_t triangleCount(const ExportScene& scene) {
    std::size_t count = 0;
    for (const ExportMesh& part : scene.meshes) count += part.mesh.triangles.size() * part.transforms.size();
    return count;
}

Mesh unitShape(ExportInstances::Shape shape, int sides) {
    Mesh mesh;
    if (shape == ExportInstances::Shape::ball)
        addBall(mesh, {}, 1, 0, sides);
    else
        addCylinder(mesh, {}, {0, 0, 1}, 1, 0, 0, sides);
    return mesh;
}

}  // namespace nacre::app
