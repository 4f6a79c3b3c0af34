#include "app/input/fit_inputs.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "app/files/messages.h"
#include "engine/error.h"
#include "engine/molecule/align_structures.h"
#include "engine/molecule/displacement.h"
#include "engine/molecule/matched_atoms.h"
#include "engine/molecule/residue_facts.h"
#include "engine/molecule/superpose.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

int inputNumber(const Molecule& molecule, std::uint32_t atom) {
    return molecule.chains[molecule.residues[molecule.atoms[atom].residue].chain].model;
}

/// The INPUT to which the atoms belong. @throws Error if there are several
int soleInput(const Molecule& molecule, const std::vector<bool>& atoms, const Selection& selection) {
    int input = 0;
    for (std::uint32_t i = 0; i < atoms.size(); ++i) {
        if (!atoms[i] || inputNumber(molecule, i) == input) continue;
        if (input != 0) throw Error("cannot fit", selection.text, "it has atoms of several INPUTs: /NAME and ...");
        input = inputNumber(molecule, i);
    }
    if (input == 0) throw Error("cannot fit", selection.text, "it has no atoms");
    return input;
}

/// Root of the mean squared distance from the middle, Å.
double measureSpread(const std::vector<glm::dvec3>& points) {
    glm::dvec3 sum(0);
    for (const glm::dvec3& point : points) sum += point;
    const glm::dvec3 middle = sum / static_cast<double>(points.size());
    double squares = 0;
    for (const glm::dvec3& point : points) squares += glm::dot(point - middle, point - middle);
    return std::sqrt(squares / static_cast<double>(points.size()));
}

std::string threeDecimals(double value) { return formatted("%.3f", value); }

/// " (chain A on B, C on D)": the paired chains, at most six pairs.
std::string describeChains(const Molecule& molecule, const AtomPairs& pairs) {
    constexpr std::size_t kMostNamed = 6;
    std::string text;
    for (const auto& [moving, fixed] : std::span(pairs.chains).first(std::min(pairs.chains.size(), kMostNamed))) {
        const std::string &from = molecule.chains[moving].name, &to = molecule.chains[fixed].name;
        if (from.empty() || to.empty()) continue;
        text += (text.empty() ? " (chain " : ", ") + from + " on " + to;
    }
    if (pairs.chains.size() > kMostNamed) text += ", ...";
    return text.empty() ? text : text + ")";
}

/// The INPUT that moves. @throws Error unless the selections belong to two INPUTs
int movedInput(const Molecule& molecule, const FitOptions& fit, const std::vector<bool>& moving,
               const std::vector<bool>& fixed) {
    const int moved = soleInput(molecule, moving, fit.moving);
    if (moved == soleInput(molecule, fixed, fit.fixed))
        throw Error("cannot fit", fit.moving.text, "it is of the same INPUT as " + fit.fixed.text);
    return moved;
}

void move(Molecule& molecule, int input, const Superposition& motion) {
    for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i)
        if (inputNumber(molecule, i) == input) {
            molecule.atoms[i].position = glm::vec3(motion(glm::dvec3(molecule.atoms[i].position)));
            turnDisplacement(molecule, i, motion.rotation);
        }
}

std::string fitInput(Molecule& molecule, const FitOptions& fit) {
    const std::vector<bool> moving = selectAtoms(molecule, fit.moving), fixed = selectAtoms(molecule, fit.fixed);
    const int moved = movedInput(molecule, fit, moving, fixed);
    const AtomPairs pairs = matchAtoms(molecule, moving, fixed);
    if (pairs.first.size() < 3)
        throw Error("cannot fit", fit.moving.text,
                    "fewer than three of its atoms have a counterpart in " + fit.fixed.text);
    std::vector<glm::dvec3> from, to;
    for (const std::uint32_t atom : pairs.first) from.emplace_back(molecule.atoms[atom].position);
    for (const std::uint32_t atom : pairs.second) to.emplace_back(molecule.atoms[atom].position);
    const PrunedSuperposition fitted = superposePruned(to, from);
    move(molecule, moved, fitted.motion);
    // Worse fits than these indicate unrelated molecules.
    constexpr double kFarApart = 3, kShareOfSpread = 0.6;  // Å
    const bool unlike = 10 * pairs.sameResidues < 3 * pairs.residues;
    if (fitted.rmsdOfAll > kFarApart && (unlike || fitted.rmsdOfAll > kShareOfSpread * measureSpread(to)))
        sayWarning("the fit of " + fit.moving.text + " onto " + fit.fixed.text +
                   " may make no sense: " + std::to_string(pairs.sameResidues) + " of " +
                   std::to_string(pairs.residues) + " residues have a counterpart, and atoms end far from theirs");
    std::string said = "fit of " + fit.moving.text + " onto " + fit.fixed.text + describeChains(molecule, pairs) +
                       ": " + std::to_string(pairs.first.size()) + " pairs of atoms, RMSD " +
                       threeDecimals(fitted.rmsdOfAll) + " Å";
    if (fitted.count < pairs.first.size())
        said += "; " + std::to_string(fitted.count) + " pairs, RMSD " + threeDecimals(fitted.motion.rmsd) +
                " Å without " + std::to_string(pairs.first.size() - fitted.count) + " outliers";
    return said;
}

/// Residues of one chain that have an alpha carbon.
struct Trace {
    std::vector<TraceResidue> residues;
    std::vector<std::uint32_t> numbers;  ///< of residues in the molecule
    std::uint32_t chain = 0;
};

/// The chain with the most of the selected residues. @throws Error if they are too few or too many
Trace selectTrace(const ResidueFacts& facts, const std::vector<bool>& chosen, const Selection& selection) {
    const Molecule& m = facts.molecule();
    Trace longest, trace;
    const auto keep = [&] {
        if (trace.residues.size() > longest.residues.size()) longest = trace;
    };
    for (std::uint32_t r = 0; r < m.residues.size(); ++r) {
        const Residue& residue = m.residues[r];
        if (residue.chain != trace.chain) {
            keep();
            trace = {{}, {}, residue.chain};
        }
        if (facts.kinds()[r] != ResidueKind::protein || facts.positions()[r] != r) continue;
        for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i) {
            if (!chosen[i] || m.atoms[i].name != Name("CA")) continue;
            trace.residues.push_back({glm::dvec3(m.atoms[i].position), facts.folds()[r]});
            trace.numbers.push_back(r);
            break;
        }
    }
    keep();
    const std::size_t count = longest.residues.size();
    if (count < kFewestAligned || count > kMostAligned)
        throw Error("cannot align", selection.text,
                    "its longest chain has " + std::to_string(count) + " alpha carbons: it takes " +
                        std::to_string(kFewestAligned) + " to " + std::to_string(kMostAligned));
    return longest;
}

std::string alignInput(Molecule& molecule, const FitOptions& fit) {
    const std::vector<bool> inMoving = selectAtoms(molecule, fit.moving), inFixed = selectAtoms(molecule, fit.fixed);
    const int moved = movedInput(molecule, fit, inMoving, inFixed);
    const ResidueFacts facts(molecule);
    const Trace moving = selectTrace(facts, inMoving, fit.moving), fixed = selectTrace(facts, inFixed, fit.fixed);
    const StructureAlignment found = alignStructures(moving.residues, fixed.residues);
    AtomPairs chains;
    chains.chains.emplace_back(moving.chain, fixed.chain);
    std::size_t same = 0;
    for (const auto& [i, j] : found.pairs)
        same += molecule.residues[moving.numbers[i]].name == molecule.residues[fixed.numbers[j]].name ? 1 : 0;
    std::string said = "alignment of " + fit.moving.text + " onto " + fit.fixed.text +
                       describeChains(molecule, chains) + ": " + std::to_string(found.pairs.size()) +
                       " pairs of residues, " + std::to_string(same) + " of them equal, RMSD " +
                       threeDecimals(found.motion.rmsd) + " Å, TM-score " + threeDecimals(found.scoreByMoving) +
                       " by the " + std::to_string(moving.residues.size()) + " residues that move, " +
                       threeDecimals(found.scoreByFixed) + " by the other " + std::to_string(fixed.residues.size());
    // J. Xu and Y. Zhang, Bioinformatics 26 (2010) 889.
    constexpr double kSameFold = 0.5;
    if (std::max(found.scoreByMoving, found.scoreByFixed) < kSameFold) said += "; below 0.5 most folds differ";
    move(molecule, moved, found.motion);
    return said;
}

}  // namespace

void fitInputs(const InputOptions& input, Molecule& molecule, const std::function<void(const std::string&)>& tell) {
    for (const FitOptions& fit : input.fits) tell(fitInput(molecule, fit));
    for (const FitOptions& fit : input.alignments) tell(alignInput(molecule, fit));
}

}  // namespace nacre::app
