#include "engine/scene/build/appearance.h"

#include <algorithm>
#include <limits>

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/element.h"
#include "engine/scene/build/atom_ellipsoids.h"
#include "engine/scene/build/carbohydrates.h"
#include "engine/scene/color/color_table.h"
#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

constexpr std::size_t kFewDrawn = 100;  // under this a molecule with bonds reads best as ball-and-stick
constexpr std::uint32_t kBase = 0;      // the style and colour for all; rule i is i + 1

/// The rules that decide how a drawn atom looks.
struct AtomLook {
    std::uint32_t style = kBase, color = kBase;
    bool hidden = false;
    bool bare = false;     ///< not drawn as an atom
    bool covered = false;  ///< not drawn if space-filling: a surface was put over it
    bool cartoon = false, surface = false;
    bool beside = false;                                     ///< left out of the surface for all
    std::uint32_t cartoonRule = kBase, surfaceRule = kBase;  // rules that set them

    /// Before any rule: the style for all.
    explicit AtomLook(std::optional<Style> base)
        : bare(base == Style::cartoon || base == Style::surface),
          cartoon(base == Style::cartoon),
          surface(base == Style::surface) {}

    void leaveOut() {
        beside = surface;
        surface = false;
    }
    void hide() {
        hidden = bare = true;
        cartoon = surface = covered = beside = false;
    }
    void show(std::uint32_t rule, Style wanted) {
        hidden = beside = false;
        if (wanted == Style::surface) {
            surface = covered = true;
            surfaceRule = rule;
        } else if (wanted == Style::cartoon) {
            cartoon = bare = true;
            cartoonRule = rule;
        } else {
            style = rule;
            bare = covered = false;
        }
    }
};

/// Selected atoms that are not drawn, by reason.
struct NotDrawn {
    std::size_t waters = 0, hydrogens = 0, conformers = 0, dummies = 0;

    NotDrawn(const Molecule& molecule, const std::vector<bool>& selected, std::span<const std::uint32_t> drawn) {
        std::vector<bool> left = selected;
        for (const std::uint32_t atom : drawn) left[atom] = false;
        for (std::size_t i = 0; i < left.size(); ++i) {
            if (!left[i]) continue;
            const Atom& atom = molecule.atoms[i];
            ++(isWater(molecule.residues[atom.residue]) ? waters
               : isDummy(atom)                          ? dummies
               : atom.alternate != '\0'                 ? conformers
                                                        : hydrogens);
        }
    }

    std::string text() const {
        std::string text;
        const auto add = [&](std::size_t count, const char* what) {
            if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + what;
        };
        add(waters, " in hidden waters (--water show)");
        add(hydrogens, " hidden hydrogens (--hydrogens show)");
        add(conformers, " in other conformers (--altlocs all)");
        add(dummies, " dummies");
        return text;
    }
};

std::string warningOfNothing(const Rule& rule, const NotDrawn& left) {
    const char* verb = rule.action == Rule::Action::show   ? "show"
                       : rule.action == Rule::Action::hide ? "hide"
                                                           : "color";
    const std::string why = left.text();
    return "'" + rule.selection.text + "' matches no atoms to " + verb +
           (why.empty() ? "" : ": those that it matches are not drawn, " + why);
}

bool namesConformers(const Selection& selection) {
    return std::any_of(selection.steps.begin(), selection.steps.end(),
                       [](const SelectionStep& step) { return step.test == SelectionTest::alternate; });
}

/// The atoms that a colour table matches; empty for other colourings. Warns about rows that match none.
std::optional<TableMatch> findMatch(const ResidueFacts& facts, const Coloring& coloring,
                                    std::vector<std::string>& warnings) {
    if (coloring.scheme != ColorScheme::table || !coloring.table) return std::nullopt;
    TableMatch match = matchTable(facts, *coloring.table);
    constexpr std::size_t kLongestSource = 80;  // a source may be the table itself
    const std::string name = coloring.source.size() <= kLongestSource ? coloring.source : "the table of colours";
    if (match.idle > 0)
        warnings.push_back(std::to_string(match.idle) + " of " + std::to_string(coloring.table->rows.size()) +
                           " rows of " + name + " match no atoms (the first: " + coloring.table->rowWord + " " +
                           std::to_string(match.firstIdle) + ")");
    return match;
}

/// The colouring of an AtomLook::color: for all, of a rule, or of a table (numbered after the rules).
const Coloring& findColoring(const RepresentationOptions& options, std::size_t number) {
    if (number == kBase) return options.color;
    return number <= options.rules.size() ? options.rules[number - 1].coloring
                                          : options.colorFrom[number - 1 - options.rules.size()];
}

std::vector<AtomLook> settle(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                             const RepresentationOptions& options, std::vector<std::string>& warnings) {
    std::vector<AtomLook> looks(drawn.size(), AtomLook(options.style));
    const auto inPolymer = [&](std::uint32_t atom) { return facts.isPolymer(facts.molecule().atoms[atom].residue); };
    // A ligand's surface would fill its pocket.
    if (options.style == Style::surface && std::ranges::any_of(drawn, inPolymer))
        for (std::size_t i = 0; i < drawn.size(); ++i)
            if (!inPolymer(drawn[i])) looks[i].leaveOut();
    for (std::size_t t = 0; t < options.colorFrom.size(); ++t) {
        const std::optional<TableMatch> match = findMatch(facts, options.colorFrom[t], warnings);
        for (std::size_t i = 0; match && i < drawn.size(); ++i)
            if (match->rows[drawn[i]] != TableMatch::kNone)
                looks[i].color = static_cast<std::uint32_t>(options.rules.size() + 1 + t);
    }
    for (std::size_t r = 0; r < options.rules.size(); ++r) {
        const Rule& rule = options.rules[r];
        if (!rule.on) continue;
        const std::vector<bool> selected = selectAtoms(facts, rule.selection);
        const auto number = static_cast<std::uint32_t>(r + 1);
        const std::optional<TableMatch> match = findMatch(facts, rule.coloring, warnings);
        bool any = false;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            if (!selected[drawn[i]]) continue;
            any = true;
            const bool named = !match || match->rows[drawn[i]] != TableMatch::kNone;
            if (rule.action == Rule::Action::color && named) looks[i].color = number;
            if (rule.action == Rule::Action::hide) looks[i].hide();
            if (rule.action == Rule::Action::show) looks[i].show(number, rule.style);
        }
        if (any && (rule.action == Rule::Action::hide || !namesConformers(rule.selection))) continue;
        const NotDrawn left(facts.molecule(), selected, drawn);
        if (!any)
            warnings.push_back(warningOfNothing(rule, left));
        else if (left.conformers > 0)
            warnings.push_back("'" + rule.selection.text + "' also matches atoms that are not drawn: " + left.text());
    }
    return looks;
}

/// For some atoms, ascending, whether each is bonded to another of them.
std::vector<bool> bondedAmong(const Molecule& molecule, const std::vector<std::uint32_t>& atoms) {
    std::vector<bool> bonded(atoms.size());
    const auto findSlot = [&](std::uint32_t atom) {
        const auto found = std::lower_bound(atoms.begin(), atoms.end(), atom);
        return found != atoms.end() && *found == atom ? static_cast<std::size_t>(found - atoms.begin()) : atoms.size();
    };
    for (const Bond& bond : molecule.bonds) {
        const std::size_t a = findSlot(bond.a), b = findSlot(bond.b);
        if (a < atoms.size() && b < atoms.size()) bonded[a] = bonded[b] = true;
    }
    return bonded;
}

/// For each atom of the molecule, whether a backbone tube passes it.
std::vector<bool> guideAtoms(const ResidueFacts& facts) {
    std::vector<bool> guides(facts.molecule().atoms.size());
    for (const GuideTrace& trace : guideTraces(facts))
        for (const std::uint32_t atom : trace.atoms) guides[atom] = true;
    return guides;
}

/// If one colouring by chain colours a surface and the cartoon in it, gives each residue of the surface the colour of
/// the atom that its cartoon shows. @param looks, inCartoon  of the seen atoms @param findScheme  of a rule
template <typename FindScheme>
void colorAsCartoon(const Molecule& molecule, const std::vector<AtomLook>& looks, const std::vector<bool>& inCartoon,
                    const FindScheme& findScheme, Appearance& appearance) {
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> shows(molecule.residues.size(), kNone);
    const auto getAtom = [&](std::size_t i) -> const Atom& { return molecule.atoms[appearance.atoms[i]]; };
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const std::string_view name = getAtom(i).name.view();
        if (inCartoon[i] && (name == "CA" || name == "C4'" || name == "C4*")) shows[getAtom(i).residue] = i;
    }
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const std::size_t from = shows[getAtom(i).residue];
        if (!inCartoon[i] || !looks[i].surface || from == kNone || looks[i].color != looks[from].color) continue;
        if (findScheme(looks[i].color) == ColorScheme::chainCarbons) appearance.colors[i] = appearance.colors[from];
    }
}

/// Splits all seen atoms by how they are drawn. @param looks  of the seen atoms
void partByStyle(const ResidueFacts& facts, const std::vector<AtomLook>& looks, const RepresentationOptions& options,
                 Appearance& appearance) {
    const std::vector<Rule>& rules = options.rules;
    const std::size_t count = appearance.atoms.size();
    std::vector<bool> inCartoon(count), besideCartoon(count), inSurface(count);
    std::vector<std::uint32_t> wanted;
    for (std::size_t i = 0; i < count; ++i) {
        if (looks[i].cartoon) wanted.push_back(appearance.atoms[i]);
        inSurface[i] = looks[i].surface;
    }
    if (!wanted.empty()) {
        const CartoonAtoms found = atomsOfCartoon(facts, wanted);
        const auto has = [&](const std::vector<std::uint32_t>& atoms, std::size_t i) {
            return looks[i].cartoon && std::binary_search(atoms.begin(), atoms.end(), appearance.atoms[i]);
        };
        for (std::size_t i = 0; i < count; ++i) {
            inCartoon[i] = has(found.drawn, i);
            besideCartoon[i] = looks[i].cartoon && (!inCartoon[i] || has(found.beside, i));
        }
    }
    const auto findStyle = [&](std::size_t i) {
        return looks[i].style == kBase ? appearance.style : rules[looks[i].style - 1].style;
    };
    const bool anyBackbone = std::ranges::any_of(rules, [](const Rule& r) { return r.style == Style::backbone; }) ||
                             appearance.style == Style::backbone;
    const std::vector<bool> guides = anyBackbone ? guideAtoms(facts) : std::vector<bool>();
    const std::vector<bool> bonded =
        wanted.empty() && !anyBackbone && std::ranges::none_of(looks, [](const AtomLook& look) { return look.beside; })
            ? std::vector<bool>()
            : bondedAmong(facts.molecule(), appearance.atoms);
    const auto opacity = [&](std::uint32_t rule, double ofAll) {
        return rule == kBase ? ofAll : rules[rule - 1].opacity.value_or(ofAll);
    };
    const auto inMaterial = [&](std::uint32_t rule, std::uint32_t color) {
        const std::optional<Material> material = rule == kBase ? std::nullopt : rules[rule - 1].material;
        return material ? withMaterial(color, *material) : color;
    };
    std::vector<bool> inLines(count), inSugars(count);
    Appearance atoms;
    for (std::size_t i = 0; i < count; ++i) {
        Style style = findStyle(i);
        const bool left = looks[i].bare && (looks[i].beside || besideCartoon[i]);
        if (!left && (looks[i].bare || (looks[i].covered && style == Style::spacefill))) continue;
        const std::uint32_t atom = appearance.atoms[i], residue = facts.molecule().atoms[atom].residue;
        const bool symbols = left ? options.carbohydrates != Carbohydrates::off : style == Style::carbohydrate;
        inSugars[i] = symbols && isSugar(facts.molecule(), residue);
        if (inSugars[i] ? !left || options.carbohydrates == Carbohydrates::on : !left && symbols) continue;
        if (left || (style == Style::backbone && !facts.isPolymer(residue)))
            style = bonded[i] ? Style::licorice : Style::ballAndStick;
        inLines[i] = style == Style::line;
        if (inLines[i] || (style == Style::backbone && !guides[atom])) continue;
        atoms.atoms.push_back(appearance.atoms[i]);
        atoms.styles.push_back(style);
        atoms.colors.push_back(inMaterial(looks[i].style, appearance.colors[i]));
        atoms.tints.push_back(appearance.tints[i]);
        atoms.opacity.push_back(opacity(looks[i].style, options.atomOpacity));
    }
    if (!wanted.empty())
        colorAsCartoon(
            facts.molecule(), looks, inCartoon,
            [&](std::uint32_t number) { return findColoring(options, number).scheme; }, appearance);
    const auto mesh = [&](const std::vector<bool>& chosen, std::uint32_t AtomLook::*rule, double ofAll) {
        MeshAtoms drawn;
        for (std::size_t i = 0; i < count; ++i) {
            if (!chosen[i]) continue;
            const std::uint32_t number = looks[i].*rule;
            drawn.atoms.push_back(appearance.atoms[i]);
            drawn.colors.push_back(inMaterial(number, appearance.colors[i]));
            drawn.tints.push_back(appearance.tints[i]);
            drawn.opacity.push_back(opacity(number, ofAll));
        }
        return drawn;
    };
    appearance.cartoon = mesh(inCartoon, &AtomLook::cartoonRule, options.cartoonOpacity);
    appearance.surface = mesh(inSurface, &AtomLook::surfaceRule, options.surfaceOpacity);
    appearance.lines = mesh(inLines, &AtomLook::style, 1);
    appearance.sugars = mesh(inSugars, &AtomLook::style, 1);
    appearance.seen = count;
    appearance.atoms = std::move(atoms.atoms);
    appearance.styles = std::move(atoms.styles);
    appearance.colors = std::move(atoms.colors);
    appearance.tints = std::move(atoms.tints);
    appearance.opacity = std::move(atoms.opacity);
    if (appearance.atoms.empty() && appearance.cartoon.atoms.empty() && appearance.surface.atoms.empty() &&
        appearance.lines.atoms.empty() && appearance.sugars.atoms.empty())
        appearance.seen = 0;
}

/// A colouring with the general palette, if its kind fits and the colouring has none of its own.
Coloring withPalette(Coloring coloring, const AnyPalette& palette) {
    const PaletteUse use = paletteUse(coloring.scheme);
    const bool fits = palette != Palette::automatic && use == (isRamp(palette) ? PaletteUse::ramp : PaletteUse::kinds);
    if (fits && coloring.palette == Palette::automatic) coloring.palette = palette;
    return coloring;
}

/// Colours the atoms of one colouring, and adds its legend.
void color(const ResidueFacts& facts, const Coloring& coloring, const std::string& selection,
           const std::vector<std::uint32_t>& slots, Appearance& appearance) {
    std::vector<std::uint32_t> atoms;
    atoms.reserve(slots.size());
    for (const std::uint32_t slot : slots) atoms.push_back(appearance.atoms[slot]);
    ColoredAtoms colored = colorAtoms(facts, atoms, coloring);
    for (std::size_t i = 0; i < slots.size(); ++i) {
        appearance.colors[slots[i]] = colored.colors[i];
        appearance.tints[slots[i]] = colored.tints.empty() ? 0 : colored.tints[i];
    }
    for (const std::uint32_t atom : atoms)
        appearance.legendIndex[atom] = static_cast<std::uint16_t>(appearance.legends.size());
    const std::string scheme = coloringText(coloring);
    if (!colored.warning.empty()) appearance.warnings.push_back("colour by " + scheme + ": " + colored.warning);
    appearance.legends.push_back({selection, scheme, std::move(colored.legend), colored.ramp, colored.stops});
}

}  // namespace

Appearance makeAppearance(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                          const RepresentationOptions& options) {
    const std::vector<Rule>& rules = options.rules;
    Appearance appearance;
    std::vector<AtomLook> looks = settle(facts, drawn, options, appearance.warnings);
    std::vector<std::vector<std::uint32_t>> slotsOfColoring(rules.size() + options.colorFrom.size() + 1);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (looks[i].hidden) continue;
        slotsOfColoring[looks[i].color].push_back(static_cast<std::uint32_t>(appearance.atoms.size()));
        appearance.atoms.push_back(drawn[i]);
    }
    appearance.sizes = options.sizes;
    appearance.cutsOctants = options.ellipsoids == EllipsoidForm::octants;
    appearance.style = options.style.value_or(defaultStyle(facts.molecule(), appearance.atoms, options.usual));
    std::erase_if(looks, [](const AtomLook& look) { return look.hidden; });
    appearance.colors.resize(appearance.atoms.size());
    appearance.tints.resize(appearance.atoms.size());
    appearance.legendIndex.assign(facts.molecule().atoms.size(), Appearance::kNoLegend);
    for (std::size_t i = 0; i < slotsOfColoring.size(); ++i) {
        if (slotsOfColoring[i].empty()) continue;
        const bool ofRule = i != kBase && i <= rules.size();
        color(facts, withPalette(findColoring(options, i), options.palette),
              ofRule ? rules[i - 1].selection.text : "all", slotsOfColoring[i], appearance);
    }
    partByStyle(facts, looks, options, appearance);
    std::vector<std::uint32_t> ellipsoids;
    for (std::size_t i = 0; i < appearance.atoms.size(); ++i)
        if (appearance.styles[i] == Style::ellipsoids) ellipsoids.push_back(appearance.atoms[i]);
    for (std::string& warning : AtomEllipsoids(facts.molecule(), options.sizes.probability).warnings(ellipsoids))
        appearance.warnings.push_back(std::move(warning));
    return appearance;
}

bool Appearance::anyByCopy() const {
    const auto any = [](const std::vector<std::uint32_t>& list) {
        return std::any_of(list.begin(), list.end(), [](std::uint32_t tint) { return tint != 0; });
    };
    return any(tints) || any(cartoon.tints) || any(surface.tints) || any(lines.tints);
}

SeenBalls seenBalls(const Molecule& molecule, const Appearance& appearance) {
    SeenBalls seen;
    const AtomEllipsoids ellipsoids(molecule, appearance.sizes.probability);
    const auto add = [&](std::uint32_t index, Style style) {
        const Atom& atom = molecule.atoms[index];
        seen.atoms.push_back(index);
        seen.balls.emplace_back(atom.position, style == Style::ellipsoids ? static_cast<float>(ellipsoids.reach(index))
                                                                          : drawnRadius(atom, style, appearance.sizes));
    };
    for (std::size_t i = 0; i < appearance.atoms.size(); ++i) add(appearance.atoms[i], appearance.styles[i]);
    for (const std::uint32_t atom : appearance.cartoon.atoms) add(atom, Style::cartoon);
    for (const std::uint32_t atom : appearance.surface.atoms) add(atom, Style::surface);
    for (const std::uint32_t atom : appearance.lines.atoms) add(atom, Style::line);
    for (const std::uint32_t atom : appearance.sugars.atoms) add(atom, Style::carbohydrate);
    return seen;
}

float drawnRadius(const Atom& atom, Style style, const Sizes& sizes) {
    switch (style) {
        case Style::ballAndStick:
            return static_cast<float>(sizes.ball) * vanDerWaalsRadius(atom);
        case Style::licorice:
            return static_cast<float>(sizes.stick);
        case Style::cartoon:
        case Style::carbohydrate:
            return kCartoonReach;
        case Style::backbone:
            return static_cast<float>(sizes.tube);
        case Style::line:
            return 0.1f;
        case Style::spacefill:
        case Style::surface:
        case Style::ellipsoids:
            break;
    }
    return vanDerWaalsRadius(atom);
}

bool haveMaterials(const std::vector<Rule>& rules) {
    return std::ranges::any_of(rules, [](const Rule& rule) { return rule.material.has_value(); });
}

Style defaultStyle(const Molecule& molecule, std::span<const std::uint32_t> drawn, Style usual) {
    if (drawn.size() >= kFewDrawn) return usual;
    const auto isDrawn = [&](std::uint32_t atom) { return std::binary_search(drawn.begin(), drawn.end(), atom); };
    const bool bonded = std::any_of(molecule.bonds.begin(), molecule.bonds.end(), [&](const Bond& bond) {
        return isDrawn(bond.a) && isDrawn(bond.b) && molecule.atoms[bond.a].position != molecule.atoms[bond.b].position;
    });
    return bonded ? Style::ballAndStick : Style::spacefill;
}

}  // namespace nacre
