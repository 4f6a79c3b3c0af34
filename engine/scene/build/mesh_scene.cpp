#include "engine/scene/build/mesh_scene.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "engine/mesh/cartoon.h"
#include "engine/mesh/surface.h"
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
    const double opacity = opacitySteps(looks(index).color) / double{kOpacitySteps};
    const SugarSymbol* symbol = sugarSymbol(molecule.residues[molecule.atoms[index].residue].name);
    if (atom == index && !ownColors) return looks(index);
    return {withOpacity(atom == index ? symbol->color : packedColor(0xffffff), opacity), index + 1};
}

}  // namespace

void addMeshes(const ResidueFacts& facts, const Appearance& appearance, const RepresentationOptions& options,
               const std::function<std::uint32_t(std::uint32_t)>& groupOf, Representation& representation) {
    const Molecule& molecule = facts.molecule();
    struct Group {
        std::vector<std::uint32_t> cartoon, surface, sugars;
    };
    std::map<std::uint32_t, Group> groups;
    for (const std::uint32_t atom : appearance.cartoon.atoms) groups[groupOf(atom)].cartoon.push_back(atom);
    for (const std::uint32_t atom : appearance.surface.atoms) groups[groupOf(atom)].surface.push_back(atom);
    for (const std::uint32_t atom : appearance.sugars.atoms) groups[groupOf(atom)].sugars.push_back(atom);
    const MeshLooks ofCartoon(molecule, appearance.cartoon), ofSurface(molecule, appearance.surface),
        ofSugars(molecule, appearance.sugars);
    for (const auto& [number, group] : groups) {
        if (!group.cartoon.empty())
            appendMesh(cartoon(facts, group.cartoon, facts.folds(), options.cartoon, representation.center), {},
                       ofCartoon, representation);
        if (!group.surface.empty()) {
            appendMesh(surface(molecule, group.surface, options.surface, representation.center), {}, ofSurface,
                       representation);
            representation.meshes.back().surface = true;
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
            farthest = std::max<double>(farthest, glm::length(positionOf(representation.meshVertices[v], t.step)));
    return farthest;
}

}  // namespace nacre
