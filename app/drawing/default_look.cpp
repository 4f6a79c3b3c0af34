#include "app/drawing/default_look.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/picture/appearance_values.h"
#include "app/picture/input_names.h"
#include "app/picture/looks.h"
#include "app/picture/option_text.h"
#include "engine/molecule/selection/selection.h"

namespace nacre::app {
namespace {

/// Whether rules hide each atom of the molecule.
std::vector<bool> hiddenBy(const std::vector<Rule>& rules, const ResidueFacts& facts) {
    std::vector<bool> hidden(facts.molecule().atoms.size());
    const auto hides = [](const Rule& rule) { return rule.on && rule.action == Rule::Action::hide; };
    if (std::ranges::none_of(rules, hides)) return hidden;
    for (const Rule& rule : rules) {
        if (!rule.on || rule.action == Rule::Action::color) continue;
        const std::vector<bool> selected = selectAtoms(facts, rule.selection);
        for (std::size_t i = 0; i < hidden.size(); ++i)
            if (selected[i]) hidden[i] = hides(rule);
    }
    return hidden;
}

}  // namespace

void takeDefaultLook(const ResidueFacts& facts, std::span<const std::uint32_t> drawn, const PictureDescription& picture,
                     RepresentationOptions& look) {
    const Molecule& molecule = facts.molecule();
    const bool predicted = molecule.file.confidence;
    if (look.style || molecule.guide || !molecule.file.packed.empty()) return;
    const auto showsSurface = [](const Rule& rule) {
        return rule.action == Rule::Action::show && rule.style == Style::surface;
    };
    if (!picture.maps.surface.file.empty() && std::ranges::none_of(look.rules, showsSurface)) {
        look.style = Style::surface;
        return;
    }
    if (!picture.maps.files.empty() && !predicted) return;
    const std::vector<bool> hidden = hiddenBy(look.rules, facts);
    std::size_t aminoAcids = 0;
    for (const std::uint32_t atom : drawn) {
        const Atom& a = molecule.atoms[atom];
        aminoAcids += !hidden[atom] && a.name.view() == "CA" && facts.kinds()[a.residue] == ResidueKind::protein;
    }
    if (predicted ? aminoAcids == 0 : aminoAcids < kFewestOfCartoon) return;
    const bool colored = look.color != Coloring() || picture.given.contains("color");
    const Coloring color = look.color;
    setStyle(Style::cartoon, look);
    if (colored)
        look.color = color;
    else if (predicted)
        look.color = ColorScheme::plddt;
    if (!look.contacts.of) return;
    Rule sticks =
        parseShow("byres (within " + numberText(kPocketReach) + " of (" + look.contacts.of->text + "))=licorice");
    if (picture.input.several()) nameInputs(inputNames(picture.input), sticks.selection);
    look.rules.insert(look.rules.begin(), std::move(sticks));
}

}  // namespace nacre::app
