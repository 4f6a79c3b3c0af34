#include "engine/scene/color/color_classes.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "engine/molecule/element.h"
#include "engine/scene/build/chain_entities.h"
#include "engine/scene/color/colors.h"
#include "engine/scene/color/palettes.h"

namespace nacre {
namespace {

constexpr std::uint32_t kOther = packedColor(0xd3ccc0);

/// The classes of a scheme and the class of each atom; the legend shows those that occur, in the order of `entries`.
struct Classes {
    std::vector<LegendEntry> entries;
    std::vector<std::uint32_t> ofAtom;  ///< same length as the atoms
    std::string warning;
};

template <typename Classify>
void sortAtoms(Classes& classes, std::span<const std::uint32_t> atoms, const Classify& classify) {
    classes.ofAtom.reserve(atoms.size());
    for (const std::uint32_t atom : atoms) classes.ofAtom.push_back(static_cast<std::uint32_t>(classify(atom)));
}

/// @param carbon  colour of carbons; 0 for their usual one
Classes byElement(const Molecule& molecule, std::span<const std::uint32_t> atoms, std::uint32_t carbon) {
    constexpr std::size_t kCarbon = 6;
    Classes classes;
    for (int i = 0; i < 120; ++i) {
        const auto element = static_cast<Element>(i);
        classes.entries.push_back({i == 0 ? "unknown" : std::string(elementSymbol(element)), elementColor(element)});
    }
    if (carbon != 0) classes.entries[kCarbon].color = carbon;
    sortAtoms(classes, atoms, [&](std::uint32_t i) {
        const Element element = molecule.atoms[i].element;
        return element < 120 ? element : Element{0};
    });
    return classes;
}

/// A chain has the same colour in every model. Chains of one model with equal names are distinguished by order; chains
/// of different molecules always are.
/// @param before  prefix of a chain's name in the legend
Classes byChain(const ResidueFacts& facts, std::span<const std::uint32_t> atoms, const AnyPalette& palette,
                const std::string& before = "") {
    const Molecule& molecule = facts.molecule();
    std::map<std::pair<int, std::string_view>, int> namesakes;
    std::map<std::tuple<int, std::string_view, int>, std::uint32_t> known;
    Classes classes;
    std::vector<std::uint32_t> ofChain;
    const std::vector<std::string> labels = chainLabels(facts, before);
    for (std::uint32_t i = 0; i < molecule.chains.size(); ++i) {
        const Chain& chain = molecule.chains[i];
        const auto next = static_cast<std::uint32_t>(classes.entries.size());
        const int namesake = namesakes[{chain.model, chain.name}]++, input = molecule.inputs.empty() ? 0 : chain.model;
        const auto [found, added] = known.emplace(std::tuple(input, std::string_view(chain.name), namesake), next);
        if (added) classes.entries.push_back({labels[i], kindColor(next, palette)});
        ofChain.push_back(found->second);
    }
    sortAtoms(classes, atoms,
              [&](std::uint32_t i) { return ofChain[molecule.residues[molecule.atoms[i].residue].chain]; });
    return classes;
}

/// Carbons of ligands keep the element's colour if there is a polymer, which distinguishes them from their chain.
Classes byChainCarbons(const ResidueFacts& facts, std::span<const std::uint32_t> atoms, const AnyPalette& palette) {
    constexpr Element kCarbon = 6;
    const Molecule& molecule = facts.molecule();
    const Classes elements = byElement(molecule, atoms, 0);
    Classes classes = byChain(facts, atoms, palette, "chain ");
    const auto chains = static_cast<std::uint32_t>(classes.entries.size());
    for (LegendEntry& entry : classes.entries) entry.label = "C of " + entry.label;
    classes.entries.insert(classes.entries.end(), elements.entries.begin(), elements.entries.end());
    const std::vector<ResidueKind>& kinds = facts.kinds();
    const bool polymers = std::ranges::any_of(
        kinds, [](ResidueKind kind) { return kind == ResidueKind::protein || kind == ResidueKind::nucleic; });
    if (polymers) classes.entries[chains + kCarbon].label = "C of ligands";
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        const Atom& atom = molecule.atoms[atoms[i]];
        const bool ofLigand = polymers && kinds[atom.residue] == ResidueKind::ligand;
        if (atom.element != kCarbon || ofLigand) classes.ofAtom[i] = chains + elements.ofAtom[i];
    }
    return classes;
}

Classes byInput(const Molecule& molecule, std::span<const std::uint32_t> atoms, const AnyPalette& palette) {
    Classes classes;
    for (std::size_t i = 0; i < molecule.inputs.size(); ++i)
        classes.entries.push_back({molecule.inputs[i], kindColor(i, palette)});
    if (molecule.inputs.empty()) {
        classes.entries.push_back({"the only INPUT", kindColor(0, palette)});
        classes.warning = "there is one INPUT";
    }
    sortAtoms(classes, atoms, [&](std::uint32_t i) {
        return molecule.inputs.empty() ? 0
                                       : molecule.chains[molecule.residues[molecule.atoms[i].residue].chain].model - 1;
    });
    return classes;
}

/// A class with its sort key in the legend: rank, then label.
struct RankedEntry {
    LegendEntry entry;
    double rank = 0;
};

/// One class per residue name; `findEntry` gives its look.
template <typename FindEntry>
Classes byResidueName(const Molecule& molecule, std::span<const std::uint32_t> atoms, const FindEntry& findEntry) {
    std::map<std::array<char, 8>, std::uint32_t> known;
    std::vector<RankedEntry> kinds;
    std::vector<std::uint32_t> ofResidue;
    ofResidue.reserve(molecule.residues.size());
    for (const Residue& residue : molecule.residues) {
        const auto next = static_cast<std::uint32_t>(kinds.size());
        const auto [found, added] = known.emplace(residue.name.bytes, next);
        if (added) kinds.push_back(findEntry(residue.name));
        ofResidue.push_back(found->second);
    }
    std::vector<std::uint32_t> order(kinds.size()), places(kinds.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(kinds[a].rank, kinds[a].entry.label) < std::tie(kinds[b].rank, kinds[b].entry.label);
    });
    Classes classes;
    for (const std::uint32_t kind : order) {
        places[kind] = static_cast<std::uint32_t>(classes.entries.size());
        classes.entries.push_back(std::move(kinds[kind].entry));
    }
    sortAtoms(classes, atoms, [&](std::uint32_t i) { return places[ofResidue[molecule.atoms[i].residue]]; });
    return classes;
}

struct Hydropathy {
    char letter;
    float value;
};
// Kyte and Doolittle 1982, table 2.
constexpr Hydropathy kHydropathies[] = {{'I', 4.5f},  {'V', 4.2f},  {'L', 3.8f},  {'F', 2.8f},  {'C', 2.5f},
                                        {'M', 1.9f},  {'A', 1.8f},  {'G', -0.4f}, {'T', -0.7f}, {'S', -0.8f},
                                        {'W', -0.9f}, {'Y', -1.3f}, {'P', -1.6f}, {'H', -3.2f}, {'E', -3.5f},
                                        {'Q', -3.5f}, {'D', -3.5f}, {'N', -3.5f}, {'K', -3.9f}, {'R', -4.5f}};

Classes byHydrophobicity(const Molecule& molecule, std::span<const std::uint32_t> atoms, const AnyPalette& ramp) {
    bool any = false;
    Classes classes = byResidueName(molecule, atoms, [&](const Name& name) {
        const char letter = aminoAcidLetter(name);
        for (const Hydropathy& entry : kHydropathies) {
            if (entry.letter != letter) continue;
            any = true;
            const int tenths = static_cast<int>(entry.value * 10 + (entry.value < 0 ? -0.5f : 0.5f));
            std::string label = std::string(name.view()) + (tenths < 0 ? " -" : " ") +
                                std::to_string(std::abs(tenths) / 10) + "." + std::to_string(std::abs(tenths) % 10);
            const double place = (static_cast<double>(entry.value) + 4.5) / 9.0;
            return RankedEntry{{std::move(label), paletteColor(ramp, place)}, -tenths / 10.0};
        }
        return RankedEntry{{std::string(kNoAminoAcid), kOther}, 100};
    });
    if (!any) classes.warning = "there is no amino acid whose hydrophobicity is known";
    return classes;
}

enum Charge { kNegative, kNeutral, kPositive };

/// @param kind  of the atom's residue
Charge classifyCharge(const Atom& atom, const Residue& residue, ResidueKind kind) {
    if (kind == ResidueKind::nucleic) return kNegative;  // for its phosphate
    if (kind == ResidueKind::protein) {
        const std::string_view name = residue.name.view();
        for (const std::string_view neutral : {"ASH", "GLH", "LYN"})
            if (name == neutral) return kNeutral;
        if (name == "HIP" || name == "HSP") return kPositive;
        if (name == "CYM") return kNegative;
        const char letter = aminoAcidLetter(residue.name);
        if (letter == 'D' || letter == 'E') return kNegative;
        if (letter == 'K' || letter == 'R') return kPositive;
        return kNeutral;
    }
    if (kind == ResidueKind::ion && atom.charge == 0)
        return isMetal(atom.element) || residue.name == Name("NH4") ? kPositive : kNegative;
    return atom.charge > 0 ? kPositive : atom.charge < 0 ? kNegative : kNeutral;
}

Classes byCharge(const ResidueFacts& facts, std::span<const std::uint32_t> atoms) {
    const Molecule& molecule = facts.molecule();
    const std::vector<ResidueKind>& kinds = facts.kinds();
    Classes classes;
    classes.entries = {
        {"negative", packedColor(0xdd5548)}, {"neutral", packedColor(0xe9e6df)}, {"positive", packedColor(0x5279c7)}};
    sortAtoms(classes, atoms, [&](std::uint32_t i) {
        const std::uint32_t residue = molecule.atoms[i].residue;
        return classifyCharge(molecule.atoms[i], molecule.residues[residue], kinds[residue]);
    });
    return classes;
}

Classes bySecondaryStructure(const ResidueFacts& facts, std::span<const std::uint32_t> atoms) {
    const Molecule& molecule = facts.molecule();
    const std::vector<ResidueKind>& kinds = facts.kinds();
    Classes classes;
    // Hues of Paul Tol's "bright" scheme (SRON/EPS/TN/09-002, 2021).
    classes.entries = {{"helix", packedColor(0xee6677)},
                       {"strand", packedColor(0xddcc55)},
                       {"other protein", packedColor(0xe4e2dd)},
                       {"nucleic acid", packedColor(0x66ccee)},
                       {"not in a chain", packedColor(0xa9a59d)}};
    const std::vector<SecondaryStructure>& folds = facts.folds();
    sortAtoms(classes, atoms, [&](std::uint32_t i) {
        const std::uint32_t residue = molecule.atoms[i].residue;
        const SecondaryStructure secondary = folds[residue];
        if (kinds[residue] == ResidueKind::nucleic) return 3;
        if (kinds[residue] != ResidueKind::protein) return 4;
        return secondary == SecondaryStructure::helix ? 0 : secondary == SecondaryStructure::strand ? 1 : 2;
    });
    if (std::find(kinds.begin(), kinds.end(), ResidueKind::protein) == kinds.end())
        classes.warning = "there is no protein, whose helices and strands this shows";
    return classes;
}

Classes byConfidence(const Molecule& molecule, std::span<const std::uint32_t> atoms) {
    Classes classes;
    // The bands and colours of the AlphaFold Protein Structure Database, https://alphafold.ebi.ac.uk.
    classes.entries = {{"very high (above 90)", packedColor(0x0053d6)},
                       {"confident (70 to 90)", packedColor(0x65cbf3)},
                       {"low (50 to 70)", packedColor(0xffdb13)},
                       {"very low (below 50)", packedColor(0xff7d45)}};
    float largest = 0;
    sortAtoms(classes, atoms, [&](std::uint32_t i) {
        const float value = molecule.atoms[i].temperatureFactor;
        largest = std::max(largest, value);
        return value > 90 ? 0 : value >= 70 ? 1 : value >= 50 ? 2 : 3;
    });
    if (!molecule.file.confidence)
        classes.warning =
            "the file does not say that it is a prediction, so its B factors are not confidence (--color b-factor "
            "shows "
            "them as what they are)";
    if (largest > 100) classes.warning = "some B factors are above 100, so they are not pLDDT";
    if (largest <= 1) classes.warning = "no B factor is above 1, so they are not pLDDT, which goes to 100";
    return classes;
}

/// Entities of several compartments ("root.membrane.spike") get shades of their compartments' colours.
void shadeByCompartment(std::vector<LegendEntry>& entities, const AnyPalette& palette) {
    std::map<std::string_view, std::size_t> compartments;
    std::vector<std::size_t> compartmentIndex, members;
    for (const LegendEntry& entity : entities) {
        const std::string_view label = entity.label, compartment = label.substr(0, label.find_last_of('.') + 1);
        compartmentIndex.push_back(compartments.emplace(compartment, compartments.size()).first->second);
        members.resize(compartments.size());
        ++members[compartmentIndex.back()];
    }
    if (compartments.size() < 2) return;
    std::vector<std::size_t> next(members.size());
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const std::size_t compartment = compartmentIndex[i];
        entities[i].color =
            tintedColor(kindColor(compartment, palette), copyTint(next[compartment]++, members[compartment]));
    }
}

Classes byEntity(const ResidueFacts& facts, std::span<const std::uint32_t> atoms, const AnyPalette& palette) {
    const Molecule& molecule = facts.molecule();
    const ResidueEntities entities = residueEntities(facts);
    Classes classes;
    for (std::size_t i = 0; i < entities.labels.size(); ++i)
        classes.entries.push_back({entities.labels[i], kindColor(i, palette)});
    if (!molecule.file.packed.empty()) shadeByCompartment(classes.entries, palette);
    sortAtoms(classes, atoms, [&](std::uint32_t i) { return entities.ofResidue[molecule.atoms[i].residue]; });
    return classes;
}

Classes classifyAtoms(const ResidueFacts& facts, std::span<const std::uint32_t> atoms, const Coloring& coloring) {
    const Molecule& molecule = facts.molecule();
    const auto palette = [&](Palette own) {
        return coloring.palette == Palette::automatic ? AnyPalette(own) : coloring.palette;
    };
    switch (coloring.scheme) {
        case ColorScheme::chain:
            return byChain(facts, atoms, palette(kChainPalette));
        case ColorScheme::chainCarbons:
            return byChainCarbons(facts, atoms, palette(kChainPalette));
        case ColorScheme::input:
            return byInput(molecule, atoms, palette(kChainPalette));
        case ColorScheme::residue:
            return byResidueName(molecule, atoms, [](const Name& name) {
                const std::string_view text = name.view();
                return RankedEntry{{text.empty() ? "(no name)" : std::string(text), residueColor(text)}};
            });
        case ColorScheme::hydrophobicity:
            return byHydrophobicity(molecule, atoms, palette(Palette::lipophilicity));
        case ColorScheme::charge:
            return byCharge(facts, atoms);
        case ColorScheme::secondaryStructure:
            return bySecondaryStructure(facts, atoms);
        case ColorScheme::plddt:
            return byConfidence(molecule, atoms);
        case ColorScheme::entity:
            return byEntity(facts, atoms, palette(Palette::okabeIto));
        default:
            return byElement(molecule, atoms, coloring.color);
    }
}

}  // namespace

std::vector<std::string> chainLabels(const ResidueFacts& facts, const std::string& before) {
    const Molecule& molecule = facts.molecule();
    std::vector<std::string> labels;
    for (const Chain& chain : molecule.chains) labels.push_back(chain.name.empty() ? "" : before + chain.name);
    // Names an entity without a name by its contents: a polymer, residues of one name except water, or several.
    constexpr std::string_view kWater = "water";
    std::vector<bool> polymer(labels.size());
    for (std::uint32_t r = 0; r < molecule.residues.size(); ++r) {
        const std::uint32_t chain = molecule.residues[r].chain;
        const bool water = facts.kinds()[r] == ResidueKind::water;
        if (!molecule.chains[chain].name.empty() || polymer[chain] || (water && !labels[chain].empty())) continue;
        const std::string name(molecule.residues[r].name.view());
        std::string& label = labels[chain];
        polymer[chain] = facts.isPolymer(r);
        if (polymer[chain])
            label = facts.kinds()[r] == ResidueKind::protein ? "protein" : "nucleic acid";
        else if (water)
            label = kWater;
        else if (name.empty() || (!label.empty() && label != kWater && label != name))
            label = "ligand";
        else
            label = name;
    }
    for (std::size_t i = 0; i < labels.size() && !molecule.inputs.empty(); ++i)
        labels[i] += " of " + molecule.inputs[static_cast<std::size_t>(molecule.chains[i].model) - 1];
    return labels;
}

ColoredAtoms colorByClass(const ResidueFacts& facts, std::span<const std::uint32_t> atoms, const Coloring& coloring) {
    const Classes classes = classifyAtoms(facts, atoms, coloring);
    ColoredAtoms result;
    result.warning = classes.warning;
    result.colors.reserve(atoms.size());
    std::vector<bool> occurs(classes.entries.size());
    std::set<std::string_view> labels;
    for (const std::uint32_t which : classes.ofAtom) {
        occurs[which] = true;
        result.colors.push_back(classes.entries[which].color);
    }
    for (std::size_t i = 0; i < occurs.size(); ++i) {
        const LegendEntry& entry = classes.entries[i];
        if (occurs[i] && labels.insert(entry.label).second) result.legend.push_back(entry);
    }
    return result;
}

}  // namespace nacre
