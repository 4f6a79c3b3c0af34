#include "engine/scene/build/gaps.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "engine/mesh/cartoon.h"
#include "engine/scene/build/dashes.h"

namespace nacre {
namespace {

/// Colours of the atoms whose residues are drawn as a cartoon or backbone.
class RibbonColors {
public:
    explicit RibbonColors(const Appearance& appearance) : cartoon_(appearance.cartoon) {
        for (std::size_t i = 0; i < appearance.atoms.size(); ++i)
            if (appearance.styles[i] == Style::backbone) backbone_.emplace(appearance.atoms[i], appearance.colors[i]);
    }

    const std::uint32_t* inCartoon(std::uint32_t atom) const {
        const auto found = std::lower_bound(cartoon_.atoms.begin(), cartoon_.atoms.end(), atom);
        if (found == cartoon_.atoms.end() || *found != atom) return nullptr;
        return &cartoon_.colors[static_cast<std::size_t>(found - cartoon_.atoms.begin())];
    }

    /// Null if the residue is drawn as neither.
    const std::uint32_t* of(std::uint32_t atom) const {
        if (const std::uint32_t* color = inCartoon(atom)) return color;
        const auto found = backbone_.find(atom);
        return found == backbone_.end() ? nullptr : &found->second;
    }

private:
    const MeshAtoms& cartoon_;
    std::map<std::uint32_t, std::uint32_t> backbone_;
};

/// Whether a chain continues after a break: residue numbers are missing, or the ends are so near that only a bond is.
/// Two ends of a cleaved chain drift apart.
bool goesOn(const Residue& before, const Residue& after, double apart) {
    constexpr double kFarthestEnds = 10;  // Å
    if (before.chain != after.chain || before.subchain != after.subchain) return false;
    // mmCIF counts all residues of the sequence; the author's numbers may jump back.
    const bool counted = before.labelNumber != kNoLabelNumber && after.labelNumber != kNoLabelNumber &&
                         before.labelNumber != after.labelNumber;
    const std::int64_t steps =
        counted ? std::int64_t{after.labelNumber} - before.labelNumber : std::int64_t{after.number} - before.number;
    return steps > 1 || (steps >= 0 && apart <= kFarthestEnds);
}

}  // namespace

void addGaps(const ResidueFacts& facts, const Appearance& appearance, Representation& scene) {
    const Molecule& molecule = facts.molecule();
    const RibbonColors colors(appearance);
    const std::vector<GuideTrace> traces = guideTraces(facts);
    const auto findResidue = [&](std::uint32_t atom) { return molecule.atoms[atom].residue; };
    const auto at = [&](std::uint32_t atom) { return glm::dvec3(molecule.atoms[atom].position) - scene.center; };
    for (std::size_t i = 1; i < traces.size(); ++i) {
        const std::uint32_t last = traces[i - 1].atoms.back(), next = traces[i].atoms.front();
        const std::uint32_t *color = colors.of(last), *colorAfter = colors.of(next);
        if (!color || !colorAfter || facts.kinds()[findResidue(last)] != facts.kinds()[findResidue(next)]) continue;
        DashedLine line{.a = at(colors.inCartoon(last) ? traces[i - 1].end : last), .b = at(next)};
        const Residue &before = molecule.residues[findResidue(last)], &after = molecule.residues[findResidue(next)];
        if (!goesOn(before, after, glm::distance(line.a, line.b))) continue;
        line.radius = 0.15;
        line.pattern = {{0.6, 0.6, 0, 0}};
        line.look = {*color, last + 1};
        line.lookB = LineLook{*colorAfter, next + 1};
        appendDashes(line, scene);
    }
}

}  // namespace nacre
