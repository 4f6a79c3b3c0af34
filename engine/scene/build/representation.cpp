#include "engine/scene/build/representation.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <unordered_set>

#include "engine/error.h"
#include "engine/scene/build/atom_ellipsoids.h"
#include "engine/scene/build/atom_groups.h"
#include "engine/scene/build/bond_drawing.h"
#include "engine/scene/build/crowd.h"
#include "engine/scene/build/gaps.h"
#include "engine/scene/build/line_drawing.h"
#include "engine/scene/build/mesh_scene.h"
#include "engine/scene/color/colors.h"
#include "engine/scene/instances/assembly_scene.h"

namespace nacre {
namespace {

void appendAtoms(const Molecule& molecule, const Appearance& appearance, Representation& result) {
    result.spheres.reserve(appearance.atoms.size());
    result.sphereLooks.reserve(appearance.atoms.size());
    const AtomEllipsoids ellipsoids(molecule, appearance.sizes.probability);
    for (std::size_t i = 0; i < appearance.atoms.size(); ++i) {
        const std::uint32_t index = appearance.atoms[i];
        const Atom& atom = molecule.atoms[index];
        const glm::dvec3 position = glm::dvec3(atom.position) - result.center;
        const float radius = appearance.styles[i] == Style::ellipsoids
                                 ? static_cast<float>(ellipsoids.reach(index))
                                 : drawnRadius(atom, appearance.styles[i], appearance.sizes);
        if (appearance.styles[i] == Style::ellipsoids)
            if (const auto axes = ellipsoids.axes(index)) {
                result.ellipsoids.resize(i);
                result.ellipsoids.push_back(ellipsoidRows(*axes));
            }
        result.spheres.push_back({glm::vec3(position), radius});
        result.sphereLooks.push_back({withOpacity(appearance.colors[i], appearance.opacity[i]), index + 1});
    }
}

/// The runs of primitives of one model. @param findModel  by primitive
template <typename FindModel>
std::vector<ModelRun> modelRuns(std::size_t count, const std::map<int, std::uint32_t>& numbers,
                                const FindModel& findModel) {
    std::vector<ModelRun> runs;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t model = numbers.at(findModel(i));
        if (runs.empty() || runs.back().model != model) runs.push_back({i, 0, model});
        ++runs.back().count;
    }
    return runs;
}

/// Records the model of each primitive, if there are several.
void separateModels(const Molecule& molecule, Representation& result) {
    const auto findModel = [&](std::uint32_t number) {
        const Atom& atom = molecule.atoms[result.findAtom(number) - 1];
        return molecule.chains[molecule.residues[atom.residue].chain].model;
    };
    std::map<int, std::uint32_t> numbers;
    for (const SphereLook& look : result.sphereLooks) numbers.emplace(findModel(look.atom), 0);
    for (const SphereLook& look : result.meshLooks) numbers.emplace(findModel(look.atom), 0);
    if (numbers.size() < 2) return;
    std::uint32_t next = 0;
    for (auto& [model, number] : numbers) number = next++;
    result.sphereModels =
        modelRuns(result.spheres.size(), numbers, [&](std::size_t i) { return findModel(result.sphereLooks[i].atom); });
    result.cylinderModels = modelRuns(result.cylinders.size(), numbers,
                                      [&](std::size_t i) { return findModel(result.cylinderLooks[i].atomA); });
    result.triangleModels = modelRuns(result.triangles.size(), numbers, [&](std::size_t i) {
        return findModel(result.meshLooks[result.meshVertices[result.triangles[i].a].look].atom);
    });
}

/// Largest distance of a sphere's surface from the centre, Å.
double spheresReach(const Representation& r) {
    double farthest = 0;
    for (const Sphere& sphere : r.spheres)
        farthest = std::max(farthest, glm::length(glm::dvec3(sphere.center)) + static_cast<double>(sphere.radius));
    for (const Cylinder& wire : r.wires)
        farthest = std::max<double>({farthest, glm::length(wire.a), glm::length(wire.b)});
    return farthest;
}

/// Removes legends of undrawn atoms, and entries whose colour is not drawn: a cartoon shows few of its atoms' colours.
/// @param legendIndex  as in Appearance
void dropUndrawn(const Representation& r, const std::vector<std::uint16_t>& legendIndex, std::vector<Legend>& legends) {
    std::vector<std::unordered_set<std::uint32_t>> drawn(legends.size());
    const auto note = [&](std::uint32_t color, std::uint32_t number) {
        const std::uint16_t legend =
            number > 0 && number <= legendIndex.size() ? legendIndex[number - 1] : Appearance::kNoLegend;
        if (legend < drawn.size()) drawn[legend].insert(color & 0xffffffu);
    };
    for (const SphereLook& look : r.sphereLooks) note(look.color, look.atom);
    for (const auto* looks : {&r.cylinderLooks, &r.wireLooks})
        for (const CylinderLook& look : *looks) note(look.colorA, look.atomA), note(look.colorB, look.atomB);
    for (const SphereLook& look : r.meshLooks) note(look.color, look.atom);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        std::vector<LegendEntry>& entries = legends[i].entries;
        if (legends[i].scheme == kContactScheme) continue;  // not about atoms
        if (drawn[i].empty()) {
            entries.clear();
            continue;
        }
        entries.erase(std::remove_if(entries.begin() + static_cast<std::ptrdiff_t>(legends[i].stops), entries.end(),
                                     [&](const LegendEntry& e) { return !drawn[i].contains(e.color & 0xffffffu); }),
                      entries.end());
        const bool ramp = std::ranges::any_of(drawn[i], [&](std::uint32_t color) {
            return std::ranges::none_of(entries.begin() + static_cast<std::ptrdiff_t>(legends[i].stops), entries.end(),
                                        [&](const LegendEntry& e) { return (e.color & 0xffffffu) == color; });
        });
        if (ramp || legends[i].stops == 0) continue;
        entries.erase(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(legends[i].stops));
        legends[i].stops = 0;
    }
}

/// Number of atoms seen, in any style, in all their copies.
std::size_t countAtoms(const Appearance& appearance, const AssemblyScene* assembly) {
    if (!assembly) return appearance.seen;
    std::vector<std::uint32_t> seen = appearance.atoms;
    for (const MeshAtoms* mesh : {&appearance.cartoon, &appearance.surface, &appearance.lines, &appearance.sugars})
        seen.insert(seen.end(), mesh->atoms.begin(), mesh->atoms.end());
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    return assembly->countCopies(seen);
}

/// Where outlines separate groups, a contact belongs to the residue of its first atom.
void addContactGroups(Representation& r) {
    if (r.contacts.empty()) return;
    r.atomGroups.resize(r.firstContact - 1);
    for (const DrawnContact& contact : r.contacts)
        r.atomGroups.push_back(r.atomGroups[contact.interaction.a.atoms.front()]);
}

}  // namespace

Representation represent(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                         const RepresentationOptions& options, const std::optional<Bounds>& frame) {
    const Molecule& molecule = facts.molecule();
    for (const std::uint32_t atom : drawn)
        if (atom >= molecule.atoms.size())
            throw Error("cannot draw molecule", "",
                        "atom " + std::to_string(atom) + " is none of its " + std::to_string(molecule.atoms.size()));
    std::optional<AssemblyScene> assembly;
    if (!options.assembly.empty()) {
        assembly.emplace(molecule, options.assembly);
        drawn = assembly->place(drawn);
    }
    Appearance appearance = makeAppearance(facts, drawn, options);
    if (appearance.seen == 0) throw Error("cannot draw molecule", "", "no atom is left to draw");
    if (assembly) {
        assembly->colorByCopy(appearance);
        assembly->sortByCopies(appearance);
    } else if (appearance.anyByCopy()) {
        appearance.warnings.push_back("colour by copy: there is one copy without an assembly (--assembly)");
    }
    const bool byCopy = appearance.anyByCopy();
    const SeenBalls seen = seenBalls(molecule, appearance);
    Representation result;
    const Bounds bounds = frame      ? movedTo(options.center, *frame)
                          : assembly ? assembly->bounds(seen, options.center)
                                     : computeBounds(seen.balls, options.center);
    result.center = bounds.center;
    result.radius = bounds.radius;
    result.style = appearance.style;
    result.ownMaterials = haveMaterials(options.rules);
    result.cutsOctants = appearance.cutsOctants;
    appendAtoms(molecule, appearance, result);
    result.drawnAtoms = countAtoms(appearance, assembly ? &*assembly : nullptr);
    result.legends = std::move(appearance.legends);
    result.warnings = std::move(appearance.warnings);
    std::vector<PlacedContact> contacts;
    if (options.contacts.of) {
        const ContactFinder finder(facts, options.contacts);
        contacts = finder.find(molecule, appearance);
        if (assembly) assembly->placeContacts(finder, appearance, contacts, result.warnings);
    }
    addBonds(facts, appearance, DrawnOrders(facts, appearance, options), contacts, assembly ? &*assembly : nullptr,
             result);
    if (options.gaps) addGaps(facts, appearance, result);
    if (assembly && options.surfaceForm != SurfaceForm::solid && !appearance.surface.atoms.empty())
        result.warnings.push_back("an assembly's surfaces are solid");
    if (options.contacts.of) addContacts(molecule, appearance, std::move(contacts), options.contacts, result);
    addLines(molecule, appearance, options.lineWidth, assembly ? &*assembly : nullptr, result);
    const auto findGroup = [&](std::uint32_t atom) {
        if (assembly) return assembly->copyList(atom);
        return static_cast<std::uint32_t>(molecule.chains[molecule.residues[molecule.atoms[atom].residue].chain].model);
    };
    addMeshes(facts, appearance, options, findGroup, result);
    // The actual reach of meshes, which is usually below the bound.
    if (!result.triangles.empty() && !assembly) {
        const double own = frame ? bounds.radius : spheresReach(result);
        result.radius = std::max(own, meshReach(result));
    }
    if (assembly) assembly->finish(result);
    if (!options.modelsOcclude && !molecule.modelsAreInputs) separateModels(molecule, result);
    refuseCrowd(result);
    result.atomGroups = atomGroups(facts);
    addContactGroups(result);
    if (!byCopy) dropUndrawn(result, appearance.legendIndex, result.legends);
    std::erase_if(result.legends, [](const Legend& legend) { return legend.entries.empty(); });
    return result;
}

MovingScene::MovingScene(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                         const RepresentationOptions& options, const std::optional<Bounds>& frame)
    : facts_(facts) {
    if (!options.assembly.empty()) throw Error("cannot move molecule", "", "the copies of an assembly stand still");
    scene_ = represent(facts, drawn, options, frame);
    if (options.contacts.of) fillUp(scene_, mostSpheres_, mostCylinders_);
    appearance_ = makeAppearance(facts, drawn, options);
    orders_.emplace(facts, appearance_, options);
    options_ = options;
}

/// Contacts at the atoms' current positions; their number of primitives hardly changes.
void MovingScene::moveContacts(const Molecule& molecule, std::vector<PlacedContact> contacts) {
    if (!options_.contacts.of) return;
    std::erase_if(scene_.legends, [](const Legend& legend) { return legend.scheme == kContactScheme; });
    const std::size_t warnings = scene_.warnings.size();
    addContacts(molecule, appearance_, std::move(contacts), options_.contacts, scene_);
    scene_.warnings.resize(warnings);
    fillUp(scene_, mostSpheres_, mostCylinders_);
    addContactGroups(scene_);
}

void MovingScene::move(const Molecule& molecule) {
    scene_.spheres.resize(appearance_.atoms.size());
    scene_.sphereLooks.resize(appearance_.atoms.size());
    for (std::size_t i = 0; i < appearance_.atoms.size(); ++i)
        scene_.spheres[i].center = glm::vec3(glm::dvec3(molecule.atoms[appearance_.atoms[i]].position) - scene_.center);
    scene_.cylinders.clear();
    scene_.cylinderLooks.clear();
    scene_.drawnBonds = 0;
    std::vector<PlacedContact> contacts;
    if (options_.contacts.of) {
        if (!finder_) finder_.emplace(facts_, options_.contacts);
        contacts = finder_->find(molecule, appearance_);
    }
    addBonds(facts_.moved(molecule), appearance_, *orders_, contacts, nullptr, scene_);
    if (options_.gaps) addGaps(facts_.moved(molecule), appearance_, scene_);
    moveContacts(molecule, std::move(contacts));
    scene_.wires.clear();
    scene_.wireLooks.clear();
    addLines(molecule, appearance_, options_.lineWidth, nullptr, scene_);
    scene_.triangles.clear();
    scene_.meshes.clear();
    scene_.coarseTriangles.clear();
    scene_.meshVertices.clear();
    scene_.meshLooks.clear();
    scene_.surfaceAtoms.clear();
    addMeshes(
        facts_.moved(molecule), appearance_, options_, [](std::uint32_t) { return 0u; }, scene_);
    scene_.radius = std::max(spheresReach(scene_), meshReach(scene_));
    refuseCrowd(scene_);
}

}  // namespace nacre
