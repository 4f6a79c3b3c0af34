#include "app/viewer/explanation.h"

#include <algorithm>
#include <set>

#include "app/picture/option_text.h"
#include "app/picture/options.h"

namespace nacre::app {
namespace {

/// Folds, ligands and elements that a scene draws.
struct Drawn {
    bool helices = false, strands = false;  ///< as ribbons
    bool ligands = false;                   ///< as atoms or bonds
    std::set<int> elements{};               ///< of atoms or bonds
};

Drawn drawnBy(const Representation& scene, const ResidueFacts& facts) {
    const Molecule& m = facts.molecule();
    Drawn drawn;
    const auto addAtom = [&](std::uint32_t number) {
        if (number == 0 || number > m.atoms.size()) return;
        const Atom& atom = m.atoms[number - 1];
        drawn.elements.insert(atom.element);
        drawn.ligands |= facts.kinds()[atom.residue] == ResidueKind::ligand;
    };
    for (const SphereLook& look : scene.sphereLooks) addAtom(look.atom);
    for (const CylinderLook& look : scene.cylinderLooks) addAtom(look.atomA), addAtom(look.atomB);
    if (scene.style != Style::cartoon) return drawn;
    for (const SphereLook& look : scene.meshLooks) {
        if (look.atom == 0 || look.atom > m.atoms.size()) continue;
        const SecondaryStructure fold = facts.folds()[m.atoms[look.atom - 1].residue];
        drawn.helices |= fold == SecondaryStructure::helix;
        drawn.strands |= fold == SecondaryStructure::strand;
    }
    return drawn;
}

std::string findMeaning(std::string_view key, std::string_view value) {
    for (const auto& choice : option(key).control.choices)
        if (choice.value == value) return choice.meaning;
    return {};
}

bool acts(const PictureDescription& picture, Rule::Action action) {
    return std::ranges::any_of(picture.look.rules, [&](const Rule& rule) { return rule.on && rule.action == action; });
}

std::string styleText(Style style, const Drawn& drawn) {
    std::string text = findMeaning("style", styleName(style));
    if (drawn.helices && drawn.strands) text += " Coils are helices, arrows are strands.";
    if (drawn.helices != drawn.strands) text += drawn.helices ? " Coils are helices." : " Arrows are strands.";
    if ((style == Style::cartoon || style == Style::backbone) && drawn.ligands) text += " Ligands are sticks.";
    return text;
}

/// "Oxygen is red, nitrogen blue.", for the drawn elements.
std::string elementsText(const std::set<int>& elements, bool carbons) {
    constexpr std::pair<int, const char*> kCommon[] = {{6, "carbon# grey"},
                                                       {8, "oxygen# red"},
                                                       {7, "nitrogen# blue"},
                                                       {16, "sulfur# yellow"},
                                                       {15, "phosphorus# orange"}};
    std::string text;
    for (const auto& [element, words] : kCommon) {
        if (!elements.contains(element) || (element == 6 && !carbons)) continue;
        std::string word = words;
        word.replace(word.find('#'), 1, text.empty() ? " is" : "");
        if (text.empty()) word[0] = static_cast<char>(word[0] - 'a' + 'A');
        text += (text.empty() ? "" : ", ") + word;
    }
    return text.empty() ? "" : " " + text + ".";
}

std::string colorText(const PictureDescription& picture, const Drawn& drawn) {
    const Coloring& coloring = picture.look.color;
    switch (coloring.scheme) {
        case ColorScheme::uniform:
            return acts(picture, Rule::Action::color) ? "All that has no colour of its own has one colour."
                                                      : "Everything has one colour.";
        case ColorScheme::element:
            if (drawn.elements.empty()) return {};
            if (coloring == Coloring(ColorScheme::element))
                return findMeaning("color", "element") + elementsText(drawn.elements, true);
            return "Carbon has one colour." + elementsText(drawn.elements, false);
        case ColorScheme::chainCarbons:
            if (drawn.elements.empty()) return findMeaning("color", "chain");
            return std::string("Carbon has the colour of its chain") + (drawn.ligands ? ", in ligands grey." : ".") +
                   elementsText(drawn.elements, false);
        default:
            return findMeaning("color", colorSchemeName(coloring.scheme));
    }
}

std::string rulesText(const PictureDescription& picture) {
    std::string text = acts(picture, Rule::Action::hide) ? "Some atoms are hidden." : "";
    const bool styled = acts(picture, Rule::Action::show), colored = acts(picture, Rule::Action::color);
    if (!styled && !colored) return text;
    return text + (text.empty() ? "" : " ") + "Some parts have " +
           (!colored ? "a style"
            : styled ? "a style and colours"
                     : "colours") +
           " of their own.";
}

}  // namespace

std::string explanationText(const PictureDescription& picture, const Drawing& drawing) {
    const Representation& scene = drawing.scene();
    if (scene.drawnAtoms == 0)
        return picture.maps.files.empty() ? "All atoms are hidden."
                                          : "Lines and surfaces join points of equal density.";
    const Drawn drawn = drawnBy(scene, drawing.facts());
    std::string text = styleText(scene.style, drawn);
    for (const std::string& part : {colorText(picture, drawn), rulesText(picture)})
        if (!part.empty()) text += " " + part;
    return text;
}

}  // namespace nacre::app
