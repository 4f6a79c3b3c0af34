#include "engine/molecule/residue_distances.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/molecule/matched_atoms.h"

namespace nacre {
namespace {

std::vector<bool> atomsOfInput(const Molecule& molecule, int input) {
    std::vector<bool> atoms(molecule.atoms.size());
    for (std::size_t i = 0; i < atoms.size(); ++i)
        atoms[i] = molecule.chains[molecule.residues[molecule.atoms[i].residue].chain].model == input;
    return atoms;
}

/// The paired atoms of one residue.
struct PairedResidue {
    std::uint32_t counterpart = 0;
    double squares = 0, main = -1;  ///< sum of squared distances; distance of the main atoms, if they are paired
    int count = 0;
    double distance() const { return main >= 0 ? main : std::sqrt(squares / count); }
};

void addDistances(const Molecule& molecule, const AtomPairs& pairs, std::vector<double>& distances) {
    std::vector<PairedResidue> paired(molecule.residues.size());
    for (std::size_t i = 0; i < pairs.first.size(); ++i) {
        const Atom &atom = molecule.atoms[pairs.first[i]], &other = molecule.atoms[pairs.second[i]];
        const double distance = glm::distance(glm::dvec3(atom.position), glm::dvec3(other.position));
        PairedResidue& residue = paired[atom.residue];
        residue.counterpart = other.residue;
        residue.squares += distance * distance;
        ++residue.count;
        if (atom.name == Name("CA") || atom.name == Name("C4'") || atom.name == Name("C4*")) residue.main = distance;
    }
    for (std::size_t i = 0; i < paired.size(); ++i) {
        if (paired[i].count == 0) continue;
        distances[i] = paired[i].distance();
        double& other = distances[paired[i].counterpart];
        if (std::isnan(other)) other = distances[i];
    }
}

}  // namespace

std::vector<double> residueDistances(const ResidueFacts& facts) {
    const Molecule& molecule = facts.molecule();
    std::vector<double> distances(molecule.residues.size(), std::numeric_limits<double>::quiet_NaN());
    const std::vector<bool> first = atomsOfInput(molecule, 1);
    for (int input = 2; input <= static_cast<int>(molecule.inputs.size()); ++input)
        addDistances(molecule, matchAtoms(facts, atomsOfInput(molecule, input), first, Placing::settled), distances);
    return distances;
}

}  // namespace nacre
