#include "engine/scene/representation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/scene/assembly_scene.h"
#include "engine/scene/atom_groups.h"
#include "engine/scene/bond_cylinders.h"
#include "engine/scene/bounds.h"
#include "engine/scene/mesh_scene.h"

namespace nacre {
namespace {

constexpr double kShortestBond = 1e-3;  // Å; below it the ends coincide and there is no direction to draw
constexpr std::uint32_t kNotDrawn = std::numeric_limits<std::uint32_t>::max();

/// Position of each atom in the list of drawn ones, or kNotDrawn.
std::vector<std::uint32_t> drawnSlots(const Molecule& molecule, std::span<const std::uint32_t> drawn) {
    std::vector<std::uint32_t> slots(molecule.atoms.size(), kNotDrawn);
    for (std::size_t i = 0; i < drawn.size(); ++i) slots[drawn[i]] = static_cast<std::uint32_t>(i);
    return slots;
}

glm::dvec3 between(const Molecule& molecule, const Bond& bond) {
    return glm::dvec3(molecule.atoms[bond.b].position) - glm::dvec3(molecule.atoms[bond.a].position);
}

/// What lies around each atom: its first four bonded neighbours (a flat atom has at most three), and the sum of the
/// vectors to those by aromatic bonds, which points into the ring.
struct Surroundings {
    struct Neighbours {
        std::array<std::uint32_t, 4> atoms;
        std::uint32_t count = 0;
    };
    std::vector<Neighbours> neighbours;
    std::vector<glm::dvec3> aromatic;

    void add(std::uint32_t atom, std::uint32_t other) {
        Neighbours& list = neighbours[atom];
        if (list.count < list.atoms.size()) list.atoms[list.count++] = other;
    }
};

Surroundings surroundingsOf(const Molecule& molecule, std::span<const Bond> bonds) {
    Surroundings around{std::vector<Surroundings::Neighbours>(molecule.atoms.size()),
                        std::vector<glm::dvec3>(molecule.atoms.size(), glm::dvec3(0))};
    for (const Bond& bond : bonds) {
        around.add(bond.a, bond.b);
        around.add(bond.b, bond.a);
        if (bond.order != 4) continue;
        around.aromatic[bond.a] += between(molecule, bond);
        around.aromatic[bond.b] -= between(molecule, bond);
    }
    return around;
}

/// Side of a bond that has more than one strand: into the ring if aromatic, else towards the neighbour that stands
/// farthest off the axis. One neighbour decides, since those of a flat atom cancel in a sum.
glm::dvec3 strandSide(const Molecule& molecule, const Bond& bond, const glm::dvec3& axis, const Surroundings& around) {
    const auto across = [&](const glm::dvec3& way) { return way - axis * glm::dot(axis, way); };
    if (bond.order == 4) {
        const glm::dvec3 ring = across(around.aromatic[bond.a] + around.aromatic[bond.b]);
        if (glm::length(ring) > 1e-2) return bondSide(axis, ring);
    }
    glm::dvec3 best(0);
    for (const std::uint32_t end : {bond.a, bond.b}) {
        const Surroundings::Neighbours& list = around.neighbours[end];
        for (std::uint32_t i = 0; i < list.count; ++i) {
            const glm::dvec3 way =
                across(glm::dvec3(molecule.atoms[list.atoms[i]].position) - glm::dvec3(molecule.atoms[end].position));
            if (glm::length(way) > glm::length(best)) best = way;
        }
    }
    return bondSide(axis, best);
}

void appendAtoms(const Molecule& molecule, const Appearance& appearance, Representation& result) {
    result.spheres.reserve(appearance.atoms.size());
    result.sphereLooks.reserve(appearance.atoms.size());
    for (std::size_t i = 0; i < appearance.atoms.size(); ++i) {
        const std::uint32_t index = appearance.atoms[i];
        const Atom& atom = molecule.atoms[index];
        const glm::dvec3 position = glm::dvec3(atom.position) - result.center;
        const float radius = drawnRadius(atom.element, appearance.styles[i]);
        result.spheres.push_back({glm::vec3(position), radius});
        result.sphereLooks.push_back({appearance.colors[i], index + 1});
    }
}

Style stouter(Style a, Style b) {
    if (a == Style::licorice || b == Style::licorice) return Style::licorice;
    return a == Style::spacefill ? b : a;
}

/// Coordination is what binds a metal to anything but metals, whatever order a file gives it.
bool isCoordination(const Molecule& molecule, const Bond& bond) {
    return isMetal(molecule.atoms[bond.a].element) != isMetal(molecule.atoms[bond.b].element);
}

/// A bond's dashes, each in the colour of the atom that it is nearer to.
void appendDashes(const Sphere& a, const Sphere& b, const SphereLook& lookA, const SphereLook& lookB,
                  Representation& result) {
    const glm::dvec3 way = glm::dvec3(b.center) - glm::dvec3(a.center);
    const double length = glm::length(way);
    const Dashes dashes = bondDashes(length, static_cast<double>(a.radius), static_cast<double>(b.radius));
    for (int i = 0; i < dashes.count; ++i) {
        const double from = dashes.first + 2 * i * dashes.length;
        const auto at = [&](double distance) { return glm::vec3(glm::dvec3(a.center) + way * (distance / length)); };
        result.cylinders.push_back({at(from), kDashRadius, at(from + dashes.length), 0.0f});
        const SphereLook& first = 2 * i + 1 <= dashes.count ? lookA : lookB;
        const SphereLook& second = 2 * i + 1 < dashes.count ? lookA : lookB;
        result.cylinderLooks.push_back({first.color, second.color, first.atom, second.atom});
    }
}

void appendBonds(const Molecule& molecule, std::span<const Bond> bonds, const Surroundings& around,
                 std::span<const std::uint32_t> slots, std::span<const Style> styles, Representation& result) {
    for (const Bond& bond : bonds) {
        const std::uint32_t slotA = slots[bond.a], slotB = slots[bond.b];
        ++result.drawnBonds;
        if (isCoordination(molecule, bond)) {
            appendDashes(result.spheres[slotA], result.spheres[slotB], result.sphereLooks[slotA],
                         result.sphereLooks[slotB], result);
            continue;
        }
        const Style style = stouter(styles[slotA], styles[slotB]);
        const glm::dvec3 way = between(molecule, bond);
        const double length = glm::length(way);
        const glm::dvec3 axis = way / length;
        BondStrands strands{{{{0.0f, kLicoriceRadius}}}, 1};
        if (style == Style::ballAndStick) strands = bondStrands(bond.order);
        const glm::dvec3 side = strands.count > 1 ? strandSide(molecule, bond, axis, around) : glm::dvec3(0);
        const glm::dvec3 start = glm::dvec3(molecule.atoms[bond.a].position) - result.center;
        const SphereLook& lookA = result.sphereLooks[slotA];
        const SphereLook& lookB = result.sphereLooks[slotB];
        for (int i = 0; i < strands.count; ++i) {
            const auto& strand = strands.strands[static_cast<std::size_t>(i)];
            const glm::dvec3 from = start + side * static_cast<double>(strand.offset);
            result.cylinders.push_back({glm::vec3(from), strand.radius, glm::vec3(from + way), 0.0f});
            result.cylinderLooks.push_back({lookA.color, lookB.color, lookA.atom, lookB.atom});
        }
    }
}

/// Bonds whose two atoms are drawn and apart.
std::vector<Bond> drawableBonds(const Molecule& molecule, std::span<const std::uint32_t> slots) {
    std::vector<Bond> bonds;
    for (const Bond& bond : molecule.bonds)
        if (slots[bond.a] != kNotDrawn && slots[bond.b] != kNotDrawn &&
            glm::length(between(molecule, bond)) > kShortestBond)
            bonds.push_back(bond);
    return bonds;
}

void addBonds(const Molecule& molecule, const Appearance& appearance, AssemblyScene* assembly, Representation& result) {
    const std::vector<Style>& styles = appearance.styles;
    const auto has = [&](Style style) { return std::find(styles.begin(), styles.end(), style) != styles.end(); };
    if (!has(Style::ballAndStick) && !has(Style::licorice)) return;
    const std::vector<std::uint32_t> slots = drawnSlots(molecule, appearance.atoms);
    std::vector<Bond> bonds = drawableBonds(molecule, slots);
    const Surroundings around = has(Style::ballAndStick) ? surroundingsOf(molecule, bonds) : Surroundings{};
    std::erase_if(bonds, [&](const Bond& bond) {
        return stouter(styles[slots[bond.a]], styles[slots[bond.b]]) == Style::spacefill;
    });
    if (assembly) assembly->sortByCopies(bonds);
    appendBonds(molecule, bonds, around, slots, styles, result);
}

/// The runs of primitives of one model. @param modelOf  by primitive
template <typename ModelOf>
std::vector<ModelRun> modelRuns(std::size_t count, const std::map<int, std::uint32_t>& numbers,
                                const ModelOf& modelOf) {
    std::vector<ModelRun> runs;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t model = numbers.at(modelOf(i));
        if (runs.empty() || runs.back().model != model) runs.push_back({i, 0, model});
        ++runs.back().count;
    }
    return runs;
}

/// Notes what belongs to which model, if there are several.
void separateModels(const Molecule& molecule, Representation& result) {
    const auto modelOf = [&](std::uint32_t atom) {
        return molecule.chains[molecule.residues[molecule.atoms[atom - 1].residue].chain].model;
    };
    std::map<int, std::uint32_t> numbers;
    for (const SphereLook& look : result.sphereLooks) numbers.emplace(modelOf(look.atom), 0);
    for (const SphereLook& look : result.meshLooks) numbers.emplace(modelOf(look.atom), 0);
    if (numbers.size() < 2) return;
    std::uint32_t next = 0;
    for (auto& [model, number] : numbers) number = next++;
    result.sphereModels =
        modelRuns(result.spheres.size(), numbers, [&](std::size_t i) { return modelOf(result.sphereLooks[i].atom); });
    result.cylinderModels = modelRuns(result.cylinders.size(), numbers,
                                      [&](std::size_t i) { return modelOf(result.cylinderLooks[i].atomA); });
    result.triangleModels = modelRuns(result.triangles.size(), numbers, [&](std::size_t i) {
        return modelOf(result.meshLooks[result.meshVertices[result.triangles[i].a].look].atom);
    });
}

/// Time goes with how often the picture is covered over and over: a large protein covers it some twenty times, a
/// thousand models of a small one three thousand times. A file of atoms at one point, however small, must not run for
/// hours; at this bound a picture takes lavapipe a minute of processor time, and a bake as much.
void refuseCrowd(const Representation& r) {
    constexpr double kMostCovered = 10'000;
    const auto copiesOf = [&](const PrimitiveRun& run) { return static_cast<double>(r.copies.lists[run.list].size()); };
    const auto area = [](const auto& primitives, std::size_t first, std::size_t count, const auto& areaOf) {
        double sum = 0;
        for (std::size_t i = first; i < first + count; ++i) sum += areaOf(primitives[i]);
        return sum;
    };
    const auto disc = [](const Sphere& s) { return std::numbers::pi * static_cast<double>(s.radius) * s.radius; };
    const auto side = [](const Cylinder& c) { return 2.0 * static_cast<double>(c.radius) * glm::distance(c.a, c.b); };
    // Seen from all sides, half of its area on the average.
    const auto facet = [&](const Triangle& t) {
        const auto at = [&](std::uint32_t v) { return glm::dvec3(positionOf(r.meshVertices[v], t.step)); };
        return 0.25 * glm::length(glm::cross(at(t.b) - at(t.a), at(t.c) - at(t.a)));
    };
    double covered = 0;
    if (r.copies.transforms.empty())
        covered = area(r.spheres, 0, r.spheres.size(), disc) + area(r.cylinders, 0, r.cylinders.size(), side) +
                  area(r.triangles, 0, r.triangles.size(), facet);
    for (const PrimitiveRun& run : r.copies.spheres)
        covered += copiesOf(run) * area(r.spheres, run.first, run.count, disc);
    for (const PrimitiveRun& run : r.copies.cylinders)
        covered += copiesOf(run) * area(r.cylinders, run.first, run.count, side);
    for (const PrimitiveRun& run : r.copies.triangles)
        covered += copiesOf(run) * area(r.triangles, run.first, run.count, facet);
    const double times = covered / (std::numbers::pi * r.radius * r.radius);
    if (times > kMostCovered)
        throw Error("cannot draw molecule", "",
                    "its atoms, bonds and surfaces lie over one another " + std::to_string(std::llround(times)) +
                        " times, more than the limit of " + std::to_string(std::llround(kMostCovered)) +
                        " (draw fewer of them, or as thinner sticks)");
}

/// The farthest that a sphere reaches from the centre, Å.
double spheresReach(const Representation& r) {
    double farthest = 0;
    for (const Sphere& sphere : r.spheres)
        farthest = std::max(farthest, glm::length(glm::dvec3(sphere.center)) + static_cast<double>(sphere.radius));
    return farthest;
}

/// Atoms that are seen, in whatever style, in all their copies.
std::size_t countAtoms(const Appearance& appearance, const AssemblyScene* assembly) {
    if (!assembly) return appearance.seen;
    std::vector<std::uint32_t> seen = appearance.atoms;
    for (const MeshAtoms* mesh : {&appearance.cartoon, &appearance.surface})
        seen.insert(seen.end(), mesh->atoms.begin(), mesh->atoms.end());
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    return assembly->countCopies(seen);
}

}  // namespace

Representation represent(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                         const RepresentationOptions& options, const std::optional<Bounds>& frame) {
    const Molecule& molecule = facts.molecule();
    std::optional<AssemblyScene> assembly;
    if (!options.assembly.empty()) {
        assembly.emplace(molecule, options.assembly);
        drawn = assembly->place(drawn);
    }
    Appearance appearance = appearanceOf(facts, drawn, options);
    if (appearance.seen == 0) throw Error("cannot draw molecule", "", "no atom is left to draw");
    if (assembly) {
        assembly->colorByCopy(appearance);
        assembly->sortByCopies(appearance);
    } else if (appearance.anyByCopy()) {
        appearance.warnings.push_back("colour by copy: there is one copy without an assembly (--assembly)");
    }
    const SeenBalls seen = seenBalls(molecule, appearance);
    Representation result;
    const Bounds bounds = frame ? *frame : assembly ? assembly->bounds(seen) : boundsOf(seen.balls);
    result.center = bounds.center;
    result.radius = bounds.radius;
    result.style = appearance.style;
    appendAtoms(molecule, appearance, result);
    result.drawnAtoms = countAtoms(appearance, assembly ? &*assembly : nullptr);
    addBonds(molecule, appearance, assembly ? &*assembly : nullptr, result);
    const auto groupOf = [&](std::uint32_t atom) {
        if (assembly) return assembly->listOf(atom);
        return static_cast<std::uint32_t>(molecule.chains[molecule.residues[molecule.atoms[atom].residue].chain].model);
    };
    addMeshes(facts, appearance, options, groupOf, result);
    // Meshes end where they do, which is seldom as far out as it may be.
    if (!result.triangles.empty() && !assembly) {
        const double own = frame ? bounds.radius : spheresReach(result);
        result.radius = std::max(own, meshReach(result));
    }
    if (assembly) assembly->finish(result);
    if (!options.modelsOcclude && !molecule.modelsAreInputs) separateModels(molecule, result);
    refuseCrowd(result);
    result.atomGroups = atomGroups(facts);
    result.legends = std::move(appearance.legends);
    result.warnings = std::move(appearance.warnings);
    return result;
}

MovingScene::MovingScene(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                         const RepresentationOptions& options, const std::optional<Bounds>& frame)
    : facts_(facts) {
    if (!options.assembly.empty()) throw Error("cannot move molecule", "", "the copies of an assembly stand still");
    scene_ = represent(facts, drawn, options, frame);
    appearance_ = appearanceOf(facts, drawn, options);
    options_ = options;
}

void MovingScene::move(const Molecule& molecule) {
    for (std::size_t i = 0; i < appearance_.atoms.size(); ++i)
        scene_.spheres[i].center = glm::vec3(glm::dvec3(molecule.atoms[appearance_.atoms[i]].position) - scene_.center);
    scene_.cylinders.clear();
    scene_.cylinderLooks.clear();
    scene_.drawnBonds = 0;
    addBonds(molecule, appearance_, nullptr, scene_);
    scene_.triangles.clear();
    scene_.meshes.clear();
    scene_.coarseTriangles.clear();
    scene_.meshVertices.clear();
    scene_.meshLooks.clear();
    addMeshes(
        facts_.moved(molecule), appearance_, options_, [](std::uint32_t) { return 0u; }, scene_);
    scene_.radius = std::max(spheresReach(scene_), meshReach(scene_));
    refuseCrowd(scene_);
}

}  // namespace nacre
