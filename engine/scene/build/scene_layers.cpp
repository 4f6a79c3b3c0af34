#include "engine/scene/build/scene_layers.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "engine/error.h"
#include "engine/scene/build/atom_ellipsoids.h"
#include "engine/scene/build/atom_groups.h"
#include "engine/scene/build/bond_drawing.h"
#include "engine/scene/build/carbohydrates.h"
#include "engine/scene/build/crowd.h"
#include "engine/scene/build/gaps.h"
#include "engine/scene/build/line_drawing.h"
#include "engine/scene/build/mesh_scene.h"
#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

constexpr std::size_t kMostWires = 10'000'000;

template <typename T>
void appendTo(std::vector<T>& list, const std::vector<T>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

void appendShifted(std::vector<Triangle>& list, const std::vector<Triangle>& more, std::uint32_t firstVertex) {
    for (Triangle t : more) {
        t.a += firstVertex, t.b += firstVertex, t.c += firstVertex;
        list.push_back(t);
    }
}

/// Adds the primitives of a part to a whole; copies, legends and bounds stay those of the whole.
void appendPart(Representation& whole, const Representation& part) {
    if (!part.ellipsoids.empty()) {
        whole.ellipsoids.resize(whole.spheres.size());
        appendTo(whole.ellipsoids, part.ellipsoids);
        whole.cutsOctants = part.cutsOctants;
    }
    appendTo(whole.spheres, part.spheres);
    appendTo(whole.sphereLooks, part.sphereLooks);
    appendTo(whole.cylinders, part.cylinders);
    appendTo(whole.cylinderLooks, part.cylinderLooks);
    appendTo(whole.wires, part.wires);
    appendTo(whole.wireLooks, part.wireLooks);
    const auto vertices = static_cast<std::uint32_t>(whole.meshVertices.size()),
               looks = static_cast<std::uint32_t>(whole.meshLooks.size()),
               triangles = static_cast<std::uint32_t>(whole.triangles.size()),
               coarse = static_cast<std::uint32_t>(whole.coarseTriangles.size());
    for (MeshVertex v : part.meshVertices) {
        v.look += looks;
        whole.meshVertices.push_back(v);
    }
    appendTo(whole.meshLooks, part.meshLooks);
    appendShifted(whole.triangles, part.triangles, vertices);
    appendShifted(whole.coarseTriangles, part.coarseTriangles, vertices);
    for (MeshRun run : part.meshes) {
        run.first += triangles;
        run.firstVertex += vertices, run.endVertex += vertices;
        for (MeshRun::Level& level : run.levels) level.first += coarse, level.endVertex += vertices;
        whole.meshes.push_back(std::move(run));
    }
}

/// Keeps the atoms of a layer for which `wanted(slot)` is true.
template <typename Wanted>
SceneLayer filtered(const SceneLayer& layer, const Wanted& wanted) {
    SceneLayer kept = layer;
    kept.atoms.clear(), kept.colors.clear(), kept.opacity.clear();
    for (std::size_t i = 0; i < layer.atoms.size(); ++i) {
        if (!wanted(i)) continue;
        kept.atoms.push_back(layer.atoms[i]);
        kept.colors.push_back(layer.colors[i]);
        if (!layer.opacity.empty()) kept.opacity.push_back(layer.opacity[i]);
    }
    return kept;
}

/// A layer of the drawn atoms in `chosen`, in one colouring.
SceneLayer newLayer(const ResidueFacts& facts, std::span<const std::uint32_t> drawn, const std::vector<bool>* chosen,
                    Style style, const Coloring& coloring, const RepresentationOptions& options, double opacity) {
    SceneLayer layer;
    layer.style = style;
    layer.cartoon = options.cartoon;
    layer.surface = options.surface;
    for (const std::uint32_t atom : drawn)
        if (!chosen || (*chosen)[atom]) layer.atoms.push_back(atom);
    layer.colors = colorAtoms(facts, layer.atoms, coloring).colors;
    if (opacity < 1) layer.opacity.assign(layer.atoms.size(), static_cast<float>(opacity));
    return layer;
}

double styleOpacity(Style style, const RepresentationOptions& options) {
    return style == Style::surface   ? options.surfaceOpacity
           : style == Style::cartoon ? options.cartoonOpacity
                                     : options.atomOpacity;
}

void recolorLayers(const ResidueFacts& facts, const std::vector<bool>* chosen, const Coloring& coloring,
                   const std::string& selection, GuidedLayers& result) {
    std::vector<std::uint32_t> atoms;
    for (const SceneLayer& layer : result.layers)
        std::copy_if(layer.atoms.begin(), layer.atoms.end(), std::back_inserter(atoms),
                     [&](std::uint32_t atom) { return !chosen || (*chosen)[atom]; });
    std::sort(atoms.begin(), atoms.end());
    atoms.erase(std::unique(atoms.begin(), atoms.end()), atoms.end());
    if (atoms.empty()) {
        result.warnings.push_back("'" + selection + "' matches no atoms to color");
        return;
    }
    ColoredAtoms colored = colorAtoms(facts, atoms, coloring);
    for (SceneLayer& layer : result.layers)
        for (std::size_t i = 0; i < layer.atoms.size(); ++i) {
            const auto at = std::lower_bound(atoms.begin(), atoms.end(), layer.atoms[i]);
            if (at != atoms.end() && *at == layer.atoms[i])
                layer.colors[i] = colored.colors[static_cast<std::size_t>(at - atoms.begin())];
        }
    if (!colored.warning.empty())
        result.warnings.push_back("colour by " + coloringText(coloring) + ": " + colored.warning);
    result.legends.push_back(
        {selection, coloringText(coloring), std::move(colored.legend), colored.ramp, colored.stops});
}

void applyRule(const ResidueFacts& facts, std::span<const std::uint32_t> drawn, const Rule& rule,
               const RepresentationOptions& options, GuidedLayers& result) {
    const std::vector<bool> chosen = selectAtoms(facts, rule.selection);
    if (rule.action == Rule::Action::color)
        return recolorLayers(facts, &chosen, rule.coloring, rule.selection.text, result);
    if (rule.action == Rule::Action::hide) {
        for (SceneLayer& layer : result.layers)
            layer = filtered(layer, [&](std::size_t i) { return !chosen[layer.atoms[i]]; });
        return;
    }
    SceneLayer layer = newLayer(facts, drawn, &chosen, rule.style, options.color, options,
                                rule.opacity.value_or(styleOpacity(rule.style, options)));
    if (rule.material)
        for (std::uint32_t& color : layer.colors) color = withMaterial(color, *rule.material);
    if (layer.atoms.empty()) result.warnings.push_back("'" + rule.selection.text + "' matches no atoms to show");
    result.layers.push_back(std::move(layer));
}

/// The appearance of one layer.
Appearance appearanceOfLayer(const ResidueFacts& facts, const SceneLayer& layer) {
    Appearance appearance;
    appearance.style = layer.style;
    appearance.seen = layer.atoms.size();
    const auto mesh = [&](const std::vector<std::uint32_t>& shown) {
        MeshAtoms atoms;
        for (std::size_t i = 0; i < layer.atoms.size(); ++i) {
            if (!std::binary_search(shown.begin(), shown.end(), layer.atoms[i])) continue;
            atoms.atoms.push_back(layer.atoms[i]);
            atoms.colors.push_back(layer.colors[i]);
            atoms.opacity.push_back(layer.opacity.empty() ? 1.0 : static_cast<double>(layer.opacity[i]));
        }
        atoms.tints.assign(atoms.atoms.size(), 0);
        return atoms;
    };
    if (layer.style == Style::cartoon) {
        appearance.cartoon = mesh(atomsOfCartoon(facts, layer.atoms).drawn);
    } else if (layer.style == Style::surface) {
        appearance.surface = mesh(layer.atoms);
    } else if (layer.style == Style::line) {
        appearance.lines = mesh(layer.atoms);
    } else if (layer.style == Style::carbohydrate) {
        std::vector<std::uint32_t> sugars;
        for (const std::uint32_t atom : layer.atoms)
            if (isSugar(facts.molecule(), facts.molecule().atoms[atom].residue)) sugars.push_back(atom);
        appearance.sugars = mesh(sugars);
    } else {
        const bool backbone = layer.style == Style::backbone;
        std::vector<bool> guides(backbone ? facts.molecule().atoms.size() : 0);
        if (backbone)
            for (const GuideTrace& trace : guideTraces(facts))
                for (const std::uint32_t atom : trace.atoms) guides[atom] = true;
        for (std::size_t i = 0; i < layer.atoms.size(); ++i) {
            if (backbone && !guides[layer.atoms[i]]) continue;
            appearance.atoms.push_back(layer.atoms[i]);
            appearance.colors.push_back(layer.colors[i]);
            appearance.opacity.push_back(layer.opacity.empty() ? 1.0 : static_cast<double>(layer.opacity[i]));
        }
        appearance.tints.assign(appearance.atoms.size(), 0);
        appearance.styles.assign(appearance.atoms.size(), layer.style);
    }
    return appearance;
}

float ballRadius(const SceneLayer& layer, const Atom& atom) {
    if (layer.ballRadius > 0) return layer.ballRadius;
    const bool own = layer.style != Style::spacefill || atom.radius > 0;
    return own ? drawnRadius(atom, layer.style) : layer.radius(atom.element);
}

Representation layerPart(const ResidueFacts& facts, const SceneLayer& layer, const RepresentationOptions& options,
                         const glm::dvec3& center) {
    const Molecule& molecule = facts.molecule();
    Appearance appearance = appearanceOfLayer(facts, layer);
    appearance.sizes.probability = options.sizes.probability;
    appearance.cutsOctants = options.ellipsoids == EllipsoidForm::octants;
    const AtomEllipsoids ellipsoids(molecule, options.sizes.probability);
    Representation part;
    part.center = center;
    part.cutsOctants = appearance.cutsOctants;
    for (std::size_t i = 0; i < appearance.atoms.size(); ++i) {
        const std::uint32_t index = appearance.atoms[i];
        const Atom& atom = molecule.atoms[index];
        const bool ellipsoid = layer.style == Style::ellipsoids;
        const float own = ellipsoid ? static_cast<float>(ellipsoids.reach(index)) : ballRadius(layer, atom);
        if (auto axes = ellipsoid ? ellipsoids.axes(index) : std::nullopt) {
            for (glm::dvec3& axis : *axes) axis *= layer.atomScale;
            part.ellipsoids.resize(i);
            part.ellipsoids.push_back(ellipsoidRows(*axes));
        }
        part.spheres.push_back({glm::vec3(glm::dvec3(atom.position) - center), own * layer.atomScale});
        part.sphereLooks.push_back({withOpacity(appearance.colors[i], appearance.opacity[i]), index + 1});
    }
    if (!appearance.atoms.empty()) {
        addBonds(facts, appearance, DrawnOrders(facts, appearance, options), {}, nullptr, part);
        for (Cylinder& cylinder : part.cylinders) cylinder.radius *= layer.bondScale;
    }
    if (!appearance.lines.atoms.empty())
        addLines(molecule, appearance, options.lineWidth * static_cast<double>(layer.atomScale), nullptr, part);
    RepresentationOptions own = options;
    own.cartoon = layer.cartoon;
    own.surface = layer.surface;
    own.sugarScale = static_cast<double>(layer.atomScale);
    own.sugarColors = !layer.ownColors;
    const auto findGroup = [&](std::uint32_t atom) {
        return static_cast<std::uint32_t>(molecule.chains[molecule.residues[molecule.atoms[atom].residue].chain].model);
    };
    addMeshes(facts, appearance, own, findGroup, part);
    if (options.gaps) addGaps(facts, appearance, part);
    return part;
}

/// Appends a part to a whole, as its own run of copies.
void placePart(const Representation& part, std::uint32_t list, Representation& whole) {
    const auto run = [&](std::vector<PrimitiveRun>& runs, std::size_t first, std::size_t count,
                         const auto& visitBalls) {
        if (count == 0) return;
        const Bounds bounds = boundsOfEach(visitBalls);
        runs.push_back(
            {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count), list, bounds.center, bounds.radius});
    };
    run(whole.copies.spheres, whole.spheres.size(), part.spheres.size(), [&](const auto& add) {
        for (const Sphere& sphere : part.spheres) add(sphere.center, sphere.radius);
    });
    run(whole.copies.cylinders, whole.cylinders.size(), part.cylinders.size(), [&](const auto& add) {
        for (const Cylinder& stick : part.cylinders) add(stick.a, stick.radius), add(stick.b, stick.radius);
    });
    run(whole.copies.triangles, whole.triangles.size(), part.triangles.size(), [&](const auto& add) {
        for (const Triangle& t : part.triangles)
            for (const std::uint32_t v : {t.a, t.b, t.c}) add(decodePosition(part.meshVertices[v], t.step()), 0.0f);
    });
    const std::size_t wires = whole.wires.size();
    appendPart(whole, part);
    whole.drawnBonds += part.drawnBonds;
    // Lines have no copies: each is stored separately.
    whole.wires.resize(wires);
    whole.wireLooks.resize(wires);
    if (part.wires.size() * whole.copies.lists[list].size() > kMostWires)
        throw Error("cannot draw scene", "", "the lines of its copies are more than " + std::to_string(kMostWires));
    for (const std::uint32_t copy : whole.copies.lists[list]) {
        const glm::dmat4x3& motion = whole.copies.transforms[copy];
        for (Cylinder wire : part.wires) {
            wire.a = glm::vec3(motion * glm::dvec4(wire.a, 1.0));
            wire.b = glm::vec3(motion * glm::dvec4(wire.b, 1.0));
            whole.wires.push_back(wire);
        }
        whole.wireLooks.insert(whole.wireLooks.end(), part.wireLooks.begin(), part.wireLooks.end());
    }
}

std::uint32_t copyList(const Molecule& molecule, const SceneGuide& guide, std::uint32_t atom) {
    return guide.listOfResidue[molecule.atoms[atom].residue];
}

/// Largest distance of any surface from the centre, Å, in all copies.
double measureReach(const Representation& r) {
    double reach = meshReach(r);
    for (const Sphere& sphere : r.spheres)
        reach = std::max(reach, static_cast<double>(glm::length(sphere.center) + sphere.radius));
    for (const Cylinder& stick : r.cylinders)
        for (const glm::vec3& end : {stick.a, stick.b})
            reach = std::max(reach, static_cast<double>(glm::length(end) + stick.radius));
    if (r.copies.transforms.empty()) return reach;
    reach = 0;
    for (const auto* runs : {&r.copies.spheres, &r.copies.cylinders, &r.copies.triangles})
        for (const PrimitiveRun& run : *runs)
            for (const std::uint32_t copy : r.copies.lists[run.list])
                reach =
                    std::max(reach, glm::length(r.copies.transforms[copy] * glm::dvec4(run.center, 1.0)) + run.radius);
    return reach;
}

/// Layers whose cartoons and surfaces have the detail for the number of residues and atoms in all copies.
std::vector<SceneLayer> coarseInCopies(const Molecule& molecule, std::vector<SceneLayer> layers) {
    const SceneGuide& guide = *molecule.guide;
    if (guide.transforms.empty()) return layers;
    for (SceneLayer& layer : layers) {
        std::size_t residues = 0, atoms = 0;
        std::uint32_t last = UINT32_MAX;
        for (const std::uint32_t atom : layer.atoms) {
            const std::size_t copies = guide.lists[copyList(molecule, guide, atom)].size();
            atoms += copies;
            if (molecule.atoms[atom].residue != last) residues += copies;
            last = molecule.atoms[atom].residue;
        }
        layer.cartoon = settledCartoon(layer.cartoon, residues);
        if (layer.surface.resolution <= 0) layer.surface.resolution = surfaceResolution(atoms, layer.surface.kind);
    }
    return layers;
}

std::size_t atomsIn(const Molecule& molecule, std::span<const SceneLayer> layers) {
    std::vector<std::uint32_t> atoms;
    for (const SceneLayer& layer : layers) atoms.insert(atoms.end(), layer.atoms.begin(), layer.atoms.end());
    std::sort(atoms.begin(), atoms.end());
    atoms.erase(std::unique(atoms.begin(), atoms.end()), atoms.end());
    const SceneGuide& guide = *molecule.guide;
    if (guide.transforms.empty()) return atoms.size();
    std::size_t count = 0;
    for (const std::uint32_t atom : atoms) count += guide.lists[copyList(molecule, guide, atom)].size();
    return count;
}

}  // namespace

GuidedLayers guidedLayers(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                          const RepresentationOptions& options) {
    GuidedLayers result;
    result.layers = facts.molecule().guide->layers;
    if (options.style) {
        result.layers = {newLayer(facts, drawn, nullptr, *options.style, options.color, options,
                                  styleOpacity(*options.style, options))};
    }
    if (options.color != Coloring(ColorScheme::element)) recolorLayers(facts, nullptr, options.color, "all", result);
    for (const Rule& rule : options.rules)
        if (rule.on) applyRule(facts, drawn, rule, options, result);
    return result;
}

std::vector<SceneLayer> splitLayers(const Appearance& appearance, const RepresentationOptions& options) {
    std::vector<SceneLayer> layers;
    const auto findLayer = [&](Style style) -> SceneLayer& {
        const auto found = std::ranges::find_if(layers, [&](const SceneLayer& layer) { return layer.style == style; });
        if (found != layers.end()) return *found;
        SceneLayer& layer = layers.emplace_back();
        layer.style = style;
        layer.cartoon = options.cartoon;
        layer.surface = options.surface;
        return layer;
    };
    const auto addMesh = [&](Style style, const MeshAtoms& mesh) {
        if (mesh.atoms.empty()) return;
        SceneLayer& layer = findLayer(style);
        layer.atoms = mesh.atoms;
        layer.colors = mesh.colors;
        if (std::any_of(mesh.opacity.begin(), mesh.opacity.end(), [](double opacity) { return opacity < 1; }))
            for (const double opacity : mesh.opacity) layer.opacity.push_back(static_cast<float>(opacity));
    };
    addMesh(Style::cartoon, appearance.cartoon);
    addMesh(Style::surface, appearance.surface);
    addMesh(Style::line, appearance.lines);
    addMesh(Style::carbohydrate, appearance.sugars);
    for (std::size_t i = 0; i < appearance.atoms.size(); ++i) {
        SceneLayer& layer = findLayer(appearance.styles[i]);
        layer.atoms.push_back(appearance.atoms[i]);
        layer.colors.push_back(appearance.colors[i]);
    }
    return layers;
}

std::string joinTooltips(const SceneGuide& guide, std::uint32_t atom) {
    std::string text;
    for (const SceneNote& note : guide.tooltips)
        if (std::binary_search(note.atoms.begin(), note.atoms.end(), atom))
            text += (text.empty() ? "" : "; ") + note.text;
    return text;
}

namespace {

/// Visits centre and radius of all that layers show, in all copies.
template <typename Visit>
void eachLayerBall(const Molecule& molecule, std::span<const SceneLayer> layers, const Visit& visit) {
    const SceneGuide& guide = *molecule.guide;
    for (const SceneLayer& layer : layers)
        for (const std::uint32_t index : layer.atoms) {
            const Atom& atom = molecule.atoms[index];
            const glm::dvec3 center(atom.position);
            const double radius = static_cast<double>(ballRadius(layer, atom) * layer.atomScale);
            if (guide.transforms.empty()) {
                visit(center, radius);
                continue;
            }
            for (const std::uint32_t copy : guide.lists[copyList(molecule, guide, index)])
                visit(guide.transforms[copy] * glm::dvec4(center, 1.0), radius);
        }
}

}  // namespace

Bounds computeBounds(const Molecule& molecule, std::span<const SceneLayer> layers) {
    const Bounds bounds = boundsOfEach([&](const auto& visit) { eachLayerBall(molecule, layers, visit); });
    return std::isnan(bounds.center.x) ? Bounds{{}, 1} : bounds;
}

Representation representLayers(const ResidueFacts& facts, const GuidedLayers& guided,
                               const RepresentationOptions& options, const Bounds& frame) {
    const Molecule& molecule = facts.molecule();
    const SceneGuide& guide = *molecule.guide;
    Representation result;
    result.center = frame.center;
    result.ownMaterials = haveMaterials(options.rules);
    result.legends = guided.legends;
    result.warnings = guided.warnings;
    const auto lists = static_cast<std::uint32_t>(guide.transforms.empty() ? 1 : guide.lists.size());
    for (const glm::dmat4x3& transform : guide.transforms) {
        glm::dmat4x3 about = transform;
        about[3] = transform * glm::dvec4(frame.center, 1.0) - frame.center;
        result.copies.transforms.push_back(about);
    }
    result.copies.lists = guide.lists;
    for (const SceneLayer& layer : coarseInCopies(molecule, guided.layers))
        for (std::uint32_t list = 0; list < lists; ++list) {
            const SceneLayer own = lists == 1 ? layer : filtered(layer, [&](std::size_t i) {
                return copyList(molecule, guide, layer.atoms[i]) == list;
            });
            if (own.atoms.empty()) continue;
            const Representation part = layerPart(facts, own, options, result.center);
            guide.transforms.empty() ? appendPart(result, part) : placePart(part, list, result);
            if (guide.transforms.empty()) result.drawnBonds += part.drawnBonds;
        }
    result.radius = std::max(measureReach(result), 1.0);
    result.drawnAtoms = atomsIn(molecule, guided.layers);
    result.atomGroups = atomGroups(facts);
    refuseCrowd(result);
    return result;
}

}  // namespace nacre
