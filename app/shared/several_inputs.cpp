#include "app/shared/several_inputs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "app/shared/messages.h"
#include "engine/error.h"
#include "engine/molecule/matched_atoms.h"
#include "engine/molecule/overlay_models.h"
#include "engine/molecule/superpose.h"
#include "engine/scene/palettes.h"

namespace nacre::app {
namespace {

/// "1crn" of "data/1crn.cif.gz", "dna" of "sample:dna".
std::string nameOf(const std::string& path) {
    std::string name = std::filesystem::path(path.substr(path.rfind(':') + 1)).filename().string();
    name.resize(std::min(name.find('.'), name.size()));
    for (char& c : name)
        if (!isInputName(std::string(1, c))) c = '_';
    return name.empty() || path == "-" ? "input" : name;
}

int modelOf(const Molecule& molecule, std::uint32_t atom) {
    return molecule.chains[molecule.residues[molecule.atoms[atom].residue].chain].model;
}

/// The one INPUT that some atoms are of. @throws Error if there are several
int inputOf(const Molecule& molecule, const std::vector<bool>& atoms, const Selection& selection) {
    int input = 0;
    for (std::uint32_t i = 0; i < atoms.size(); ++i) {
        if (!atoms[i] || modelOf(molecule, i) == input) continue;
        if (input != 0) throw Error("cannot fit", selection.text, "it has atoms of several INPUTs: /NAME and ...");
        input = modelOf(molecule, i);
    }
    if (input == 0) throw Error("cannot fit", selection.text, "it has no atoms");
    return input;
}

/// Root of the mean squared distance from the middle, Å.
double spreadOf(const std::vector<glm::dvec3>& points) {
    glm::dvec3 sum(0);
    for (const glm::dvec3& point : points) sum += point;
    const glm::dvec3 middle = sum / static_cast<double>(points.size());
    double squares = 0;
    for (const glm::dvec3& point : points) squares += glm::dot(point - middle, point - middle);
    return std::sqrt(squares / static_cast<double>(points.size()));
}

std::string fitInput(Molecule& molecule, const FitOptions& fit) {
    const std::vector<bool> moving = selectAtoms(molecule, fit.moving), fixed = selectAtoms(molecule, fit.fixed);
    const int moved = inputOf(molecule, moving, fit.moving);
    if (moved == inputOf(molecule, fixed, fit.fixed))
        throw Error("cannot fit", fit.moving.text, "it is of the same INPUT as " + fit.fixed.text);
    const AtomPairs pairs = matchAtoms(molecule, moving, fixed);
    if (pairs.first.size() < 3)
        throw Error("cannot fit", fit.moving.text,
                    "fewer than three of its atoms have their like in " + fit.fixed.text);
    std::vector<glm::dvec3> from, to;
    for (const std::uint32_t atom : pairs.first) from.emplace_back(molecule.atoms[atom].position);
    for (const std::uint32_t atom : pairs.second) to.emplace_back(molecule.atoms[atom].position);
    const Superposition onto = superpose(to, from);
    for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i)
        if (modelOf(molecule, i) == moved)
            molecule.atoms[i].position = glm::vec3(onto(glm::dvec3(molecule.atoms[i].position)));
    // Of what belongs together less, were its sequences ever so different.
    constexpr double kFarApart = 3, kShareOfSpread = 0.6;  // Å
    const bool unlike = 10 * pairs.sameResidues < 3 * pairs.residues;
    if (onto.rmsd > kFarApart && (unlike || onto.rmsd > kShareOfSpread * spreadOf(to)))
        sayWarning("the fit of " + fit.moving.text + " onto " + fit.fixed.text +
                   " may make no sense: " + std::to_string(pairs.sameResidues) + " of " +
                   std::to_string(pairs.residues) + " residues have their like, and atoms end far from theirs");
    char rmsd[40];
    std::snprintf(rmsd, sizeof rmsd, "%.3f", onto.rmsd);
    return "fit of " + fit.moving.text + " onto " + fit.fixed.text + ": " + std::to_string(pairs.first.size()) +
           " pairs of atoms, RMSD " + rmsd + " Å";
}

}  // namespace

bool isInputName(const std::string& text) {
    constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return !text.empty() && text.find_first_not_of(kLetters) == std::string::npos;
}

void addInput(InputOptions& input, const std::string& text) {
    if (input.further.size() + 1 >= kMostInputs)
        throw std::invalid_argument("more than " + std::to_string(kMostInputs) + " of them");
    const std::size_t equals = text.find('=');
    std::error_code error;
    FurtherInput next{"", text, ""};
    if (equals != std::string::npos && isInputName(text.substr(0, equals)) && !std::filesystem::exists(text, error))
        next = {text.substr(0, equals), text.substr(equals + 1), ""};
    if (input.path.empty()) {
        input.path = next.path;
        input.name = next.name;
    } else {
        input.further.push_back(next);
    }
}

std::vector<std::string> inputNames(const InputOptions& input) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name, const std::string& path) {
        std::string wanted = name.empty() ? nameOf(path) : name, free = wanted;
        for (int i = 2; std::find(names.begin(), names.end(), free) != names.end(); ++i)
            free = wanted + "_" + std::to_string(i);
        names.push_back(free);
    };
    add(input.name, input.path);
    for (const FurtherInput& further : input.further) add(further.name, further.path);
    return names;
}

void nameInputs(const std::vector<std::string>& names, Selection& selection) {
    for (SelectionStep& step : selection.steps) {
        if (step.test != SelectionTest::chain) continue;
        std::vector<NumberRange> models;
        for (const std::string& word : step.words) {
            const auto at = std::find(names.begin(), names.end(), word);
            if (at == names.end()) break;
            const auto number = static_cast<std::int32_t>(at - names.begin() + 1);
            models.push_back({number, number, '\0', '\0'});
        }
        if (models.empty() || models.size() != step.words.size()) continue;
        step.test = SelectionTest::model;
        step.words.clear();
        step.numbers = models;
    }
}

void nameInputs(SavedView& view) {
    if (view.further.empty()) return;
    const std::vector<std::string> names = inputNames(inputOf(view));
    for (Rule& rule : view.look.rules) nameInputs(names, rule.selection);
    for (Label& label : view.words.labels) nameInputs(names, label.selection);
    if (view.uncover) nameInputs(names, *view.uncover);
    for (FitOptions& fit : view.fits) {
        nameInputs(names, fit.moving);
        nameInputs(names, fit.fixed);
    }
}

void colorApart(const std::vector<std::string>& names, RepresentationOptions& look, std::size_t from) {
    if (look.color != Coloring(ColorScheme::element)) return;
    std::vector<Rule> rules;
    for (std::size_t i = from; i < names.size(); ++i) {
        Rule rule;
        rule.action = Rule::Action::color;
        const auto number = static_cast<std::int32_t>(i + 1);
        SelectionStep step;
        step.test = SelectionTest::model;
        step.numbers.push_back({number, number, '\0', '\0'});
        rule.selection.text = "/" + names[i];
        rule.selection.steps.push_back(step);
        rule.coloring = Coloring::elementWithCarbons(kindColor(i));
        rules.push_back(rule);
    }
    look.rules.insert(look.rules.begin(), rules.begin(), rules.end());
}

Molecule joinInputs(const InputOptions& input, std::vector<Molecule> molecules,
                    const std::function<void(const std::string&)>& tell) {
    for (std::size_t i = 0; i < molecules.size(); ++i)
        for (Chain& chain : molecules[i].chains) chain.model = static_cast<int>(i + 1);
    Molecule whole = overlayModels(input.path, std::move(molecules), kMaxAtoms);
    whole.modelsAreInputs = true;
    whole.assemblies.clear();  // they place one of the molecules, not all
    for (const FitOptions& fit : input.fits) tell(fitInput(whole, fit));
    return whole;
}

}  // namespace nacre::app
