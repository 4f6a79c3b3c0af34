#include "engine/scene/build/gaps.h"

#include <algorithm>
#include <optional>

#include "engine/mesh/cartoon.h"
#include "engine/scene/build/dashes.h"

namespace nacre {
namespace {

/// The colour in which an atom's residue is drawn as a cartoon or backbone; nothing if it is not.
std::optional<std::uint32_t> ribbonColor(const Appearance& appearance, std::uint32_t atom) {
    const MeshAtoms& cartoon = appearance.cartoon;
    const auto inCartoon = std::lower_bound(cartoon.atoms.begin(), cartoon.atoms.end(), atom);
    if (inCartoon != cartoon.atoms.end() && *inCartoon == atom)
        return cartoon.colors[static_cast<std::size_t>(inCartoon - cartoon.atoms.begin())];
    const auto found = std::lower_bound(appearance.atoms.begin(), appearance.atoms.end(), atom);
    if (found == appearance.atoms.end() || *found != atom) return std::nullopt;
    const auto slot = static_cast<std::size_t>(found - appearance.atoms.begin());
    if (appearance.styles[slot] != Style::backbone) return std::nullopt;
    return appearance.colors[slot];
}

}  // namespace

void addGaps(const ResidueFacts& facts, const Appearance& appearance, Representation& scene) {
    const Molecule& molecule = facts.molecule();
    const std::vector<GuideTrace> traces = guideTraces(facts);
    const auto residueOf = [&](std::uint32_t atom) -> const Residue& {
        return molecule.residues[molecule.atoms[atom].residue];
    };
    for (std::size_t i = 1; i < traces.size(); ++i) {

        const std::uint32_t last = traces[i - 1].atoms.back(), next = traces[i].atoms.front();
        const Residue &before = residueOf(last), &after = residueOf(next);
        if (before.chain != after.chain || after.number <= before.number + 1) continue;
        const auto color = ribbonColor(appearance, last), colorAfter = ribbonColor(appearance, next);
        if (!color || !colorAfter) continue;
        DashedLine line;
        line.a = glm::dvec3(molecule.atoms[last].position) - scene.center;
        line.b = glm::dvec3(molecule.atoms[next].position) - scene.center;
        line.radius = 0.15;
        line.pattern = {{0.6, 0.6, 0, 0}};
        line.look = {*color, last + 1};
        line.lookB = LineLook{*colorAfter, next + 1};
        appendDashes(line, scene);
    }
}

}  // namespace nacre
