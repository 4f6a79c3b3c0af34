#include "app/annotation/placed_words.h"

#include <algorithm>
#include <cctype>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "app/annotation/measurement.h"
#include "app/picture/color_values.h"
#include "app/picture/label_fields.h"
#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/molecule/residue_facts.h"
#include "engine/molecule/text.h"
#include "engine/scene/instances/sphere_levels.h"

namespace nacre::app {
namespace {

LabelScope parseScope(std::string_view text) {
    LabelScope scope = LabelScope::selection;
    eachPiece(
        text, [](std::string_view) {}, [&](const LabelField& field) { scope = std::max(scope, field.scope); });
    return scope;
}

/// A value from the file, escaped for markup; keeps primes.
std::string plainValue(std::string_view value) {
    std::string text;
    for (const char c : value) {
        if (c == '\'') {
            text += "′";
        } else if (c == '"') {
            text += "″";
        } else {
            if (c == '_' || c == '^' || c == '\\' || c == '{' || c == '}') text += '\\';
            text += c;
        }
    }
    return text;
}

std::string titled(std::string_view symbol) {
    std::string text(symbol);
    for (std::size_t i = 1; i < text.size(); ++i)
        text[i] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
    return text;
}

std::string fieldValue(std::string_view name, const Molecule& molecule, std::uint32_t index) {
    const Atom& atom = molecule.atoms[index];
    const Residue& residue = molecule.residues[atom.residue];
    const Chain& chain = molecule.chains[residue.chain];
    if (name == "residue") return plainValue(residue.name.view());
    if (name == "number")
        return std::to_string(residue.number) + (residue.insertionCode ? std::string(1, residue.insertionCode) : "");
    if (name == "letter") {
        const char amino = aminoAcidLetter(residue.name);
        const char letter = amino ? amino : nucleotideLetter(residue.name);
        return letter ? std::string(1, letter) : plainValue(residue.name.view());
    }
    if (name == "chain") return plainValue(chain.name);
    if (name == "model") return std::to_string(chain.model);
    if (name == "atom") return plainValue(atom.name.view());
    if (name == "element") return plainValue(titled(elementSymbol(atom.element)));
    if (name == "id") return std::to_string(index + 1);
    if (name == "altloc") return atom.alternate ? plainValue(std::string_view(&atom.alternate, 1)) : "";
    const double value = static_cast<double>(name == "b-factor" ? atom.temperatureFactor : atom.occupancy);
    return formatted(name == "b-factor" ? "%.1f" : "%.2f", value);
}

std::string filledIn(std::string_view text, const Molecule& molecule, std::uint32_t atom) {
    std::string filled;
    eachPiece(
        text, [&](std::string_view plain) { filled += plain; },
        [&](const LabelField& field) { filled += fieldValue(field.name, molecule, atom); });
    return filled;
}

/// The drawn atoms and their positions; in an assembly, in its first copy.
struct DrawnAtoms {
    struct Place {
        glm::dvec3 at{};
        double radius = -1;  ///< negative: not drawn
    };
    std::vector<Place> places;  ///< by atom

    DrawnAtoms(const Molecule& molecule, const Representation& scene) : places(molecule.atoms.size()) {
        const auto put = [&](std::size_t i, const glm::dmat4x3& transform) {
            // The balls of an atom come before those of its bonds.
            const std::uint32_t number = scene.sphereLooks[i].atom;
            if (scene.findContact(number) || places[number - 1].radius >= 0) return;
            places[number - 1] = {transform * glm::dvec4(scene.spheres[i].center, 1.0),
                                  static_cast<double>(scene.spheres[i].radius)};
        };
        if (scene.copies.transforms.empty())
            for (std::size_t i = 0; i < scene.spheres.size(); ++i) put(i, glm::dmat4x3(1.0));
        for (const PrimitiveRun& run : scene.copies.spheres)
            for (std::size_t i = run.first; i < run.first + run.count; ++i)
                put(i, scene.copies.transforms[scene.copies.lists[run.list].front()]);
        addMeshAtoms(molecule, scene);
        addLineAtoms(scene);
    }

    /// Positions of atoms that are drawn as lines.
    void addLineAtoms(const Representation& scene) {
        constexpr double kRadius = 0.1;  // Å
        const auto put = [&](const glm::vec3& end, std::uint32_t number) {
            if (number > 0 && number <= places.size() && places[number - 1].radius < 0)
                places[number - 1] = {glm::dvec3(end), kRadius};
        };
        for (std::size_t i = 0; i < scene.wires.size(); ++i) {
            put(scene.wires[i].a, scene.wireLooks[i].atomA);
            put(scene.wires[i].b, scene.wireLooks[i].atomB);
        }
    }

    /// Positions of atoms that cartoons and surfaces represent.
    void addMeshAtoms(const Molecule& molecule, const Representation& scene) {
        const auto put = [&](const Triangle& triangle, const glm::dmat4x3& transform) {
            for (const std::uint32_t vertex : {triangle.a, triangle.b, triangle.c}) {
                const std::uint32_t atom = scene.meshLooks[scene.meshVertices[vertex].look].atom - 1;
                if (places[atom].radius >= 0) continue;
                const glm::dvec3 center = glm::dvec3(molecule.atoms[atom].position) - scene.center;
                places[atom] = {transform * glm::dvec4(center, 1.0),
                                static_cast<double>(vanDerWaalsRadius(molecule.atoms[atom]))};
            }
        };
        if (scene.copies.transforms.empty())
            for (const Triangle& triangle : scene.triangles) put(triangle, glm::dmat4x3(1.0));
        for (const PrimitiveRun& run : scene.copies.triangles)
            for (std::size_t i = run.first; i < run.first + run.count; ++i)
                put(scene.triangles[i], scene.copies.transforms[scene.copies.lists[run.list].front()]);
    }
};

/// The drawn atoms of a selection. An empty result is an error unless allowed; then `placed` lists the selection.
std::vector<std::uint32_t> selectDrawn(const Selection& selection, const ResidueFacts& facts, const DrawnAtoms& drawn,
                                       const char* what, WordsOfHidden hidden, PlacedWords& placed) {
    const std::vector<bool> chosen = selectAtoms(facts, selection);
    std::vector<std::uint32_t> atoms;
    for (std::uint32_t i = 0; i < chosen.size(); ++i)
        if (chosen[i] && drawn.places[i].radius >= 0) atoms.push_back(i);
    if (!atoms.empty()) return atoms;
    const bool any = std::find(chosen.begin(), chosen.end(), true) != chosen.end();
    if (!any || hidden == WordsOfHidden::refused)
        throw Error(what, selection.text, any ? "none of its atoms is drawn" : "the molecule has no such atoms");
    placed.leftOut.push_back(selection.text);
    return {};
}

constexpr std::size_t kMostAsked = 24;  // atoms per label that are tested for visibility

/// All atoms in the residues of some atoms, as looks number them: atoms of the same residue do not hide a label.
std::vector<std::uint32_t> numbersOfResidues(const Molecule& molecule, const std::vector<std::uint32_t>& atoms) {
    std::set<std::uint32_t> residues;
    for (const std::uint32_t atom : atoms) residues.insert(molecule.atoms[atom].residue);
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t i : residues)
        for (std::uint32_t k = 0; k < molecule.residues[i].atomCount; ++k)
            numbers.push_back(molecule.residues[i].firstAtom + k + 1);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

/// Colours and offsets of labels by selection.
class LabelRules {
public:
    LabelRules(const Words& words, const ResidueFacts& facts) {
        for (const LabelColor& rule : words.labelColors)
            colors_.emplace_back(selectAtoms(facts, rule.selection),
                                 opaqueColor({rule.color[0], rule.color[1], rule.color[2], 1}));
        for (const LabelOffset& rule : words.labelOffsets)
            offsets_.emplace_back(selectAtoms(facts, rule.selection), glm::dvec2(rule.right, rule.up));
    }
    /// Applies the rules that select all atoms of a label; the last one wins.
    void apply(const std::vector<std::uint32_t>& atoms, PlacedLabel& label) const {
        for (const auto& [chosen, color] : colors_)
            if (holdsAll(chosen, atoms)) label.color = color;
        for (const auto& [chosen, offset] : offsets_)
            if (holdsAll(chosen, atoms)) label.offset = offset;
    }

private:
    static bool holdsAll(const std::vector<bool>& chosen, const std::vector<std::uint32_t>& atoms) {
        return std::ranges::all_of(atoms, [&](std::uint32_t atom) { return chosen[atom]; });
    }
    std::vector<std::pair<std::vector<bool>, std::uint32_t>> colors_;
    std::vector<std::pair<std::vector<bool>, glm::dvec2>> offsets_;
};

void placeLabel(const Label& label, const ResidueFacts& facts, const DrawnAtoms& drawn, const LabelRules& rules,
                WordsOfHidden hidden, PlacedWords& placed) {
    const Molecule& molecule = facts.molecule();
    const LabelScope scope = parseScope(label.text);
    // Groups of atoms per label, in file order of their first atom.
    std::map<std::uint32_t, std::size_t> groupIndex;
    std::vector<std::vector<std::uint32_t>> groups;
    for (const std::uint32_t atom : selectDrawn(label.selection, facts, drawn, "cannot label", hidden, placed)) {
        const std::uint32_t residue = molecule.atoms[atom].residue;
        const std::uint32_t key = scope == LabelScope::atom      ? atom
                                  : scope == LabelScope::residue ? residue
                                  : scope == LabelScope::chain   ? molecule.residues[residue].chain
                                                                 : 0;
        const auto [found, added] = groupIndex.emplace(key, groups.size());
        if (added) groups.emplace_back();
        groups[found->second].push_back(atom);
    }
    if (placed.labels.size() + groups.size() > kMostLabels)
        throw Error("cannot label", label.selection.text,
                    std::to_string(placed.labels.size() + groups.size()) + " labels are more than the limit of " +
                        std::to_string(kMostLabels) + " (select fewer atoms, or name residues or chains)");
    for (const std::vector<std::uint32_t>& group : groups) {
        PlacedLabel one;
        for (const std::uint32_t atom : group) one.at += drawn.places[atom].at / static_cast<double>(group.size());
        one.ofAtom = group.size() == 1;
        one.radius = drawn.places[group.front()].radius;
        one.text = filledIn(label.text, molecule, group.front());
        rules.apply(group, one);
        if (placed.sight) one.named.atoms = numbersOfResidues(molecule, group);
        const std::size_t step = (group.size() + kMostAsked - 1) / kMostAsked;
        for (std::size_t i = 0; i < group.size(); i += step) {
            one.named.places.push_back(drawn.places[group[i]].at);
            one.named.radii.push_back(drawn.places[group[i]].radius);
        }
        placed.labels.push_back(std::move(one));
    }
}

void placeMeasure(const Measure& measure, const ResidueFacts& facts, const DrawnAtoms& drawn, WordsOfHidden hidden,
                  PlacedWords& placed) {
    PlacedMeasure result;
    std::optional<std::uint32_t> before;
    for (const Selection& point : measure.points) {
        const std::vector<std::uint32_t> atoms = selectDrawn(point, facts, drawn, "cannot measure", hidden, placed);
        if (atoms.empty()) return;
        if (atoms.size() > 1)
            throw Error("cannot measure", point.text,
                        "it has " + std::to_string(atoms.size()) + " drawn atoms, where one is needed (name CA, say)");
        if (before == atoms.front()) throw Error("cannot measure", point.text, "it is the same atom as the one before");
        before = atoms.front();
        result.points.push_back(drawn.places[atoms.front()].at);
        result.atoms += (result.atoms.empty() ? "" : " to ") + shortAtomText(facts.molecule(), atoms.front());
    }
    result.of = measure.text;
    result.text = measuredValue(result.points);
    placed.measures.push_back(std::move(result));
}

/// Beside the middle of each line.
void placeDistances(const Representation& scene, PlacedWords& placed) {
    if (scene.contacts.size() > kMostLabels)
        throw Error("cannot label", "--interaction-labels",
                    std::to_string(scene.contacts.size()) + " interactions are more than the limit of " +
                        std::to_string(kMostLabels) + " labels (select fewer atoms or kinds)");
    for (const DrawnContact& contact : scene.contacts) {
        PlacedLabel label;
        const glm::dvec4 middle(contact.middle, 1.0);
        label.at = scene.copies.transforms.empty() ? contact.middle : scene.copies.transforms[contact.copy] * middle;
        label.text = formatted("%.1f", contact.interaction.distance);
        label.ofAtom = true;  // keeps the text off the line
        placed.labels.push_back(std::move(label));
    }
}

constexpr std::uint64_t kMostInSight = std::uint64_t{1} << 25;  // spheres that may hide labels: 640 MB

}  // namespace

PlacedWords placeWords(const Words& words, const ResidueFacts& facts, const Representation& scene,
                       WordsOfHidden hidden) {
    PlacedWords placed;
    placed.title = words.title;
    placed.scaleBar = words.scaleBar;
    if (words.legend) placed.legends = scene.legends;
    if (words.axes) placed.axes = makeAxes({});
    if (words.distances) placeDistances(scene, placed);
    if (words.labels.empty() && words.measures.empty()) return placed;
    const DrawnAtoms drawn(facts.molecule(), scene);
    if (words.seenOnly && !words.labels.empty() && spheresInCopies(scene) <= kMostInSight)
        placed.sight = std::make_shared<const LabelSight>(scene);
    const LabelRules rules(words, facts);
    for (const Label& label : words.labels) placeLabel(label, facts, drawn, rules, hidden, placed);
    for (const Measure& measure : words.measures) placeMeasure(measure, facts, drawn, hidden, placed);
    return placed;
}

void addLabels(const std::vector<Primitives::Label>& labels, const glm::dvec3& center, PlacedWords& words) {
    if (words.labels.size() + labels.size() > kMostPlacedLabels)
        throw Error("cannot label", "--primitives",
                    std::to_string(words.labels.size() + labels.size()) + " labels are more than the limit of " +
                        std::to_string(kMostPlacedLabels));
    for (const Primitives::Label& label : labels) {
        PlacedLabel& one = words.labels.emplace_back();
        one.at = label.at - center;
        one.text = label.text;
        one.size = label.size;
        one.color = label.color.value_or(0);
        one.plate = label.plate;
        one.named = {{}, {one.at}, {0.0}};
    }
}

}  // namespace nacre::app
