#include "engine/scene/appearance.h"

#include <algorithm>

#include "engine/molecule/element.h"

namespace nacre {
namespace {

constexpr std::size_t kFewDrawn = 100;  // under this a molecule with bonds reads best as ball-and-stick
constexpr float kBallShare = 0.25f;     // of the van der Waals radius, ball-and-stick
constexpr std::uint32_t kBase = 0;      // the style and colour for all; rule i is i + 1

/// Which rule settles each drawn atom's style and colour.
struct Settled {
    std::vector<bool> hidden;
    std::vector<std::uint32_t> style, color;
};

std::string warningOfNothing(const Rule& rule, bool inMolecule) {
    const char* verb = rule.action == Rule::Action::show   ? "show"
                       : rule.action == Rule::Action::hide ? "hide"
                                                           : "color";
    const char* why = inMolecule ? "': it holds only atoms that are left out (waters, hydrogens, other conformers)"
                                 : "': the molecule has no such atoms";
    return std::string("nothing to ") + verb + " by '" + rule.selection.text + why;
}

Settled settle(const Molecule& molecule, std::span<const std::uint32_t> drawn, const std::vector<Rule>& rules,
               std::vector<std::string>& warnings) {
    Settled settled{std::vector<bool>(drawn.size()), std::vector<std::uint32_t>(drawn.size(), kBase),
                    std::vector<std::uint32_t>(drawn.size(), kBase)};
    for (std::size_t r = 0; r < rules.size(); ++r) {
        const std::vector<bool> selected = selectAtoms(molecule, rules[r].selection);
        const auto number = static_cast<std::uint32_t>(r + 1);
        bool any = false;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            if (!selected[drawn[i]]) continue;
            any = true;
            if (rules[r].action == Rule::Action::color) {
                settled.color[i] = number;
                continue;
            }
            settled.hidden[i] = rules[r].action == Rule::Action::hide;
            if (rules[r].action == Rule::Action::show) settled.style[i] = number;
        }
        const bool inMolecule = any || std::find(selected.begin(), selected.end(), true) != selected.end();
        if (!any) warnings.push_back(warningOfNothing(rules[r], inMolecule));
    }
    return settled;
}

/// A colouring in the palette for all, if it takes one of that kind and names none itself.
Coloring withPalette(Coloring coloring, Palette palette) {
    const PaletteUse use = paletteUse(coloring.scheme);
    const bool fits = palette != Palette::automatic && use == (isRamp(palette) ? PaletteUse::ramp : PaletteUse::kinds);
    if (fits && coloring.palette == Palette::automatic) coloring.palette = palette;
    return coloring;
}

/// Colours the atoms that one colouring settles, and adds its legend.
void color(const Molecule& molecule, const Coloring& coloring, const std::string& selection,
           const std::vector<std::uint32_t>& slots, Appearance& appearance) {
    std::vector<std::uint32_t> atoms;
    atoms.reserve(slots.size());
    for (const std::uint32_t slot : slots) atoms.push_back(appearance.atoms[slot]);
    ColoredAtoms colored = colorAtoms(molecule, atoms, coloring);
    for (std::size_t i = 0; i < slots.size(); ++i) {
        appearance.colors[slots[i]] = colored.colors[i];
        appearance.byCopy[slots[i]] = coloring.scheme == ColorScheme::copy;
    }
    const std::string scheme = coloringText(coloring);
    if (!colored.warning.empty()) appearance.warnings.push_back("colour by " + scheme + ": " + colored.warning);
    appearance.legends.push_back({selection, scheme, std::move(colored.legend), colored.ramp, colored.stops});
}

}  // namespace

Appearance appearanceOf(const Molecule& molecule, std::span<const std::uint32_t> drawn,
                        const RepresentationOptions& options) {
    const std::vector<Rule>& rules = options.rules;
    Appearance appearance;
    const Settled settled = settle(molecule, drawn, rules, appearance.warnings);
    std::vector<std::vector<std::uint32_t>> slotsOfColoring(rules.size() + 1);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (settled.hidden[i]) continue;
        slotsOfColoring[settled.color[i]].push_back(static_cast<std::uint32_t>(appearance.atoms.size()));
        appearance.atoms.push_back(drawn[i]);
    }
    appearance.style = options.style.value_or(defaultStyle(molecule, appearance.atoms));
    appearance.styles.reserve(appearance.atoms.size());
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (!settled.hidden[i])
            appearance.styles.push_back(settled.style[i] == kBase ? appearance.style
                                                                  : rules[settled.style[i] - 1].style);
    appearance.colors.resize(appearance.atoms.size());
    appearance.byCopy.resize(appearance.atoms.size());
    for (std::size_t i = 0; i < slotsOfColoring.size(); ++i) {
        if (slotsOfColoring[i].empty()) continue;
        const Coloring& coloring = i == kBase ? options.color : rules[i - 1].coloring;
        color(molecule, withPalette(coloring, options.palette), i == kBase ? "all" : rules[i - 1].selection.text,
              slotsOfColoring[i], appearance);
    }
    return appearance;
}

float drawnRadius(Element element, Style style) {
    switch (style) {
        case Style::ballAndStick:
            return kBallShare * vanDerWaalsRadius(element);
        case Style::licorice:
            return kLicoriceRadius;
        case Style::spacefill:
            break;
    }
    return vanDerWaalsRadius(element);
}

Style defaultStyle(const Molecule& molecule, std::span<const std::uint32_t> drawn) {
    if (drawn.size() >= kFewDrawn) return Style::spacefill;
    const auto isDrawn = [&](std::uint32_t atom) { return std::binary_search(drawn.begin(), drawn.end(), atom); };
    const bool bonded = std::any_of(molecule.bonds.begin(), molecule.bonds.end(), [&](const Bond& bond) {
        return isDrawn(bond.a) && isDrawn(bond.b) && molecule.atoms[bond.a].position != molecule.atoms[bond.b].position;
    });
    return bonded ? Style::ballAndStick : Style::spacefill;
}

}  // namespace nacre
