#include "engine/molecule/matched_atoms.h"

#include <algorithm>
#include <gemmi/fail.hpp>
// After what it lacks in some versions.
#include <gemmi/seqalign.hpp>
#include <string>

#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"

namespace nacre {
namespace {

constexpr std::size_t kMostResidues = 20'000;

/// A match counts 1, a mismatch and each residue of a gap -1. gemmi takes them by reference until 0.5, by pointer
/// since.
struct Scores {
    gemmi::AlignmentScoring scoring;
    operator const gemmi::AlignmentScoring&() const { return scoring; }
    operator const gemmi::AlignmentScoring*() const { return &scoring; }
};

/// Residues with a selected atom, in their order. Waters are none: their order in two files says nothing.
std::vector<std::uint32_t> residuesOf(const Molecule& molecule, const std::vector<bool>& selected) {
    std::vector<std::uint32_t> residues;
    for (std::uint32_t i = 0; i < molecule.residues.size(); ++i) {
        const Residue& residue = molecule.residues[i];
        if (isWater(residue.name)) continue;
        for (std::uint32_t atom = residue.firstAtom; atom < residue.firstAtom + residue.atomCount; ++atom) {
            if (!selected[atom]) continue;
            residues.push_back(i);
            break;
        }
    }
    if (residues.size() > kMostResidues)
        throw Error("cannot fit", "", "a selection has more than " + std::to_string(kMostResidues) + " residues");
    return residues;
}

std::vector<std::string> sequenceOf(const Molecule& molecule, const std::vector<std::uint32_t>& residues) {
    std::vector<std::string> names;
    for (const std::uint32_t residue : residues) names.emplace_back(molecule.residues[residue].name.view());
    return names;
}

/// The first selected atom of each name of a residue.
std::vector<std::uint32_t> namedAtoms(const Molecule& molecule, const Residue& residue,
                                      const std::vector<bool>& selected) {
    std::vector<std::uint32_t> atoms;
    for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i) {
        bool known = !selected[i];
        for (const std::uint32_t other : atoms) known = known || molecule.atoms[other].name == molecule.atoms[i].name;
        if (!known) atoms.push_back(i);
    }
    return atoms;
}

}  // namespace

AtomPairs matchAtoms(const Molecule& molecule, const std::vector<bool>& first, const std::vector<bool>& second) {
    const std::vector<std::uint32_t> a = residuesOf(molecule, first), b = residuesOf(molecule, second);
    AtomPairs pairs;
    pairs.residues = std::min(a.size(), b.size());
    if (pairs.residues == 0) return pairs;
    const gemmi::AlignmentResult aligned =
        gemmi::align_string_sequences(sequenceOf(molecule, a), sequenceOf(molecule, b), {}, Scores());
    if (aligned.cigar.empty()) throw Error("cannot fit", "", "the residues have names of more than 255 kinds");
    std::size_t i = 0, j = 0;
    for (const gemmi::AlignmentResult::Item& item : aligned.cigar) {
        const std::size_t length = item.len();
        if (item.op() == 'M') {
            for (std::size_t k = 0; k < length; ++k) {
                pairs.sameResidues += molecule.residues[a[i + k]].name == molecule.residues[b[j + k]].name ? 1 : 0;
                const auto others = namedAtoms(molecule, molecule.residues[b[j + k]], second);
                for (const std::uint32_t atom : namedAtoms(molecule, molecule.residues[a[i + k]], first))
                    for (const std::uint32_t other : others) {
                        if (molecule.atoms[atom].name != molecule.atoms[other].name) continue;
                        pairs.first.push_back(atom);
                        pairs.second.push_back(other);
                    }
            }
        }
        if (item.op() != 'D') i += length;
        if (item.op() != 'I') j += length;
    }
    return pairs;
}

}  // namespace nacre
