#include "app/input/join_inputs.h"

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "app/files/messages.h"
#include "app/picture/input_names.h"
#include "engine/error.h"
#include "engine/molecule/join_models.h"
#include "engine/molecule/matched_atoms.h"
#include "engine/molecule/superpose.h"

namespace nacre::app {
namespace {

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
                    "fewer than three of its atoms have a counterpart in " + fit.fixed.text);
    std::vector<glm::dvec3> from, to;
    for (const std::uint32_t atom : pairs.first) from.emplace_back(molecule.atoms[atom].position);
    for (const std::uint32_t atom : pairs.second) to.emplace_back(molecule.atoms[atom].position);
    const Superposition onto = superpose(to, from);
    for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i)
        if (modelOf(molecule, i) == moved)
            molecule.atoms[i].position = glm::vec3(onto(glm::dvec3(molecule.atoms[i].position)));
    // Less related molecules give worse fits than these.
    constexpr double kFarApart = 3, kShareOfSpread = 0.6;  // Å
    const bool unlike = 10 * pairs.sameResidues < 3 * pairs.residues;
    if (onto.rmsd > kFarApart && (unlike || onto.rmsd > kShareOfSpread * spreadOf(to)))
        sayWarning("the fit of " + fit.moving.text + " onto " + fit.fixed.text +
                   " may make no sense: " + std::to_string(pairs.sameResidues) + " of " +
                   std::to_string(pairs.residues) + " residues have a counterpart, and atoms end far from theirs");
    char rmsd[40];
    std::snprintf(rmsd, sizeof rmsd, "%.3f", onto.rmsd);
    return "fit of " + fit.moving.text + " onto " + fit.fixed.text + ": " + std::to_string(pairs.first.size()) +
           " pairs of atoms, RMSD " + rmsd + " Å";
}

}  // namespace

Molecule joinInputs(const InputOptions& input, std::vector<Molecule> molecules,
                    const std::function<void(const std::string&)>& tell) {
    for (std::size_t i = 0; i < molecules.size(); ++i)
        for (Chain& chain : molecules[i].chains) chain.model = static_cast<int>(i + 1);
    Molecule whole = joinModels(input.path, std::move(molecules), kMaxAtoms);
    whole.modelsAreInputs = true;
    whole.inputs = inputNames(input);
    whole.assemblies.clear();  // they arrange one molecule, not all
    for (const FitOptions& fit : input.fits) tell(fitInput(whole, fit));
    return whole;
}

}  // namespace nacre::app
