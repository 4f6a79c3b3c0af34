#include "engine/scene/build/mesh_scene.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <map>
#include <optional>
#include <unordered_set>

#include "engine/error.h"
#include "engine/mesh/cartoon.h"
#include "engine/mesh/cartoon_trace.h"
#include "engine/mesh/surface.h"
#include "engine/molecule/element.h"
#include "engine/scene/build/carbohydrates.h"
#include "engine/scene/build/mesh_streams.h"
#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

/// Look of each atom in a mesh: a visible atom's own; for others (such as sulphurs of a cartoon selected by alpha
/// carbons) that of a visible atom of the residue.
class MeshLooks {
public:
    MeshLooks(const Molecule& molecule, const MeshAtoms& seen) : molecule_(molecule), seen_(seen) {}

    SphereLook operator()(std::uint32_t atom) const {
        auto found = std::lower_bound(seen_.atoms.begin(), seen_.atoms.end(), atom);
        if (found == seen_.atoms.end() || *found != atom) {
            const Residue& residue = molecule_.residues[molecule_.atoms[atom].residue];
            found = std::lower_bound(seen_.atoms.begin(), seen_.atoms.end(), residue.firstAtom);
            if (found == seen_.atoms.end()) --found;
        }
        const auto slot = static_cast<std::size_t>(found - seen_.atoms.begin());
        return {withOpacity(seen_.colors[slot], seen_.opacity[slot]), atom + 1};
    }

private:
    const Molecule& molecule_;
    const MeshAtoms& seen_;
};

SphereLook sugarLook(const Molecule& molecule, const MeshLooks& looks, bool ownColors, std::uint32_t atom) {
    const std::uint32_t index = atom & ~kWhiteHalf;
    const SugarSymbol* symbol = sugarSymbol(molecule.residues[molecule.atoms[index].residue].name);
    if (atom == index && !ownColors) return looks(index);
    return {withSurfaceFrom(atom == index ? symbol->color : packedColor(0xffffff), looks(index).color), index + 1};
}

/// Whether an edge lies in a plane of the grid, like a contour's lines; other edges cross cells.
bool liesInPlane(const glm::vec3& a, const glm::vec3& b) {
    constexpr float kSame = 1e-4f;  // Å
    return glm::any(glm::lessThan(glm::abs(a - b), glm::vec3(kSame)));
}

/// A surface as wires: its contours in the grid's planes, each half in the look of its end, or dots on its vertices.
void addSurfaceWires(const Mesh& mesh, const RepresentationOptions& options, const MeshLooks& looks,
                     Representation& r) {
    constexpr float kCoarse = 0.1f;  // Å: error of the level whose vertices are drawn
    constexpr float kSpeck = 0.04f;  // Å along the normal
    constexpr std::size_t kMostWires = 4'000'000;
    const auto radius = static_cast<float>(-options.lineWidth / 2);
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, std::uint32_t vertexA, std::uint32_t vertexB) {
        if (r.wires.size() >= kMostWires)
            throw Error("cannot draw surface", "",
                        "it has more than " + std::to_string(kMostWires) + " lines (--surface-resolution)");
        const SphereLook lookA = looks(mesh.atoms[vertexA]), lookB = looks(mesh.atoms[vertexB]);
        r.wires.push_back({a, radius, b, 0});
        r.wireLooks.push_back({lookA.color | 0xff000000u, lookB.color | 0xff000000u, lookA.atom, lookB.atom});
    };
    const std::vector<glm::uvec3>* triangles = &mesh.triangles;
    const bool lines = options.surfaceForm == SurfaceForm::mesh;
    for (const MeshLevel& level : mesh.coarser)
        if (!lines && level.error <= kCoarse) triangles = &level.triangles;
    std::unordered_set<std::uint64_t> drawn;
    const auto isNew = [&](std::uint32_t a, std::uint32_t b) {
        return drawn.insert(std::uint64_t{std::min(a, b)} << 32 | std::max(a, b)).second;
    };
    for (const glm::uvec3& t : *triangles)
        for (int side = 0; side < 3; ++side) {
            const std::uint32_t a = t[side], b = t[(side + 1) % 3];
            const glm::vec3 &from = mesh.positions[a], half = mesh.normals[a] * (kSpeck / 2);
            if (lines && liesInPlane(from, mesh.positions[b]) && isNew(a, b)) add(from, mesh.positions[b], a, b);
            if (!lines && isNew(a, a)) add(from - half, from + half, a, a);
        }
}

/// Lines of a mesh are far enough apart to see through.
SurfaceOptions wireOptions(const RepresentationOptions& options, std::size_t atoms) {
    constexpr double kApart = 0.8;  // Å
    SurfaceOptions result = options.surface;
    if (options.surfaceForm == SurfaceForm::mesh && result.resolution <= 0)
        result.resolution = std::max(kApart, surfaceResolution(atoms, result.kind));
    return result;
}

}  // namespace

void addMeshes(const ResidueFacts& facts, const Appearance& appearance, const RepresentationOptions& options,
               const std::function<std::uint32_t(std::uint32_t)>& findGroup, Representation& representation) {
    const Molecule& molecule = facts.molecule();
    struct Group {
        std::vector<std::uint32_t> cartoon, surface, sugars;
    };
    std::map<std::uint32_t, Group> groups;
    for (const std::uint32_t atom : appearance.cartoon.atoms) groups[findGroup(atom)].cartoon.push_back(atom);
    for (const std::uint32_t atom : appearance.surface.atoms) groups[findGroup(atom)].surface.push_back(atom);
    for (const std::uint32_t atom : appearance.sugars.atoms) groups[findGroup(atom)].sugars.push_back(atom);
    const MeshLooks ofCartoon(molecule, appearance.cartoon), ofSurface(molecule, appearance.surface),
        ofSugars(molecule, appearance.sugars);
    // Each group's bases, disulphide bonds and symbols are looked for in the whole molecule.
    constexpr double kMostVisits = 4e9;
    const auto looking = std::ranges::count_if(groups, [](const auto& numbered) {
        const Group& g = numbered.second;
        return !g.cartoon.empty() || !g.surface.empty() || !g.sugars.empty();
    });
    if (static_cast<double>(looking) * static_cast<double>(molecule.atoms.size()) > kMostVisits)
        throw Error("cannot draw cartoon, surface or symbols", "",
                    std::to_string(looking) + " models or parts of " + std::to_string(molecule.atoms.size()) +
                        " atoms are too many together");
    std::optional<ChainStretches> stretches;
    if (!appearance.cartoon.atoms.empty()) stretches.emplace(facts);
    for (const auto& [number, group] : groups) {
        if (!group.cartoon.empty())
            appendMesh(cartoon(*stretches, group.cartoon, facts.folds(), options.cartoon, representation.center), {},
                       ofCartoon, representation);
        if (!group.surface.empty() && options.surfaceForm != SurfaceForm::solid && options.assembly.empty()) {
            addSurfaceWires(
                surface(molecule, group.surface, wireOptions(options, group.surface.size()), representation.center),
                options, ofSurface, representation);
        } else if (!group.surface.empty()) {
            appendMesh(surface(molecule, group.surface, options.surface, representation.center), {}, ofSurface,
                       representation);
            representation.meshes.back().surface = true;
            for (const std::uint32_t atom : group.surface)
                representation.surfaceAtoms.push_back(
                    {glm::vec3(glm::dvec3(molecule.atoms[atom].position) - representation.center),
                     vanDerWaalsRadius(molecule.atoms[atom]), ofSurface(atom)});
        }
        if (!group.sugars.empty())
            appendMesh(
                sugarSymbols(molecule, group.sugars, {options.carbohydrates == Carbohydrates::icon, options.sugarScale},
                             representation.center),
                {}, [&](std::uint32_t atom) { return sugarLook(molecule, ofSugars, options.sugarColors, atom); },
                representation);
    }
}

double meshReach(const Representation& representation) {
    double farthest = 0;
    for (const Triangle& t : representation.triangles)
        for (const std::uint32_t v : {t.a, t.b, t.c})
            farthest =
                std::max<double>(farthest, glm::length(decodePosition(representation.meshVertices[v], t.step())));
    return farthest;
}

}  // namespace nacre
