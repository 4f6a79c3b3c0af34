#include "engine/molecule/matched_atoms.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"

namespace nacre {
namespace {

constexpr std::size_t kMostResidues = 20'000;

constexpr std::string_view kLetters = "ARNDCQEGHILKMFPSTWYV";
/// For each letter its scores with the letters up to itself.
constexpr std::int8_t kBlosum62[] = {4,                                                                          //
                                     -1, 5,                                                                      //
                                     -2, 0,  6,                                                                  //
                                     -2, -2, 1,  6,                                                              //
                                     0,  -3, -3, -3, 9,                                                          //
                                     -1, 1,  0,  0,  -3, 5,                                                      //
                                     -1, 0,  0,  2,  -4, 2,  5,                                                  //
                                     0,  -2, 0,  -1, -3, -2, -2, 6,                                              //
                                     -2, 0,  1,  -1, -3, 0,  0,  -2, 8,                                          //
                                     -1, -3, -3, -3, -1, -3, -3, -4, -3, 4,                                      //
                                     -1, -2, -3, -4, -1, -2, -3, -4, -3, 2,  4,                                  //
                                     -1, 2,  0,  -1, -3, 1,  1,  -2, -1, -3, -2, 5,                              //
                                     -1, -1, -2, -3, -1, 0,  -2, -3, -2, 1,  2,  -1, 5,                          //
                                     -2, -3, -3, -3, -2, -3, -3, -3, -1, 0,  0,  -3, 0,  6,                      //
                                     -1, -2, -2, -1, -3, -1, -1, -2, -2, -3, -3, -1, -2, -4, 7,                  //
                                     1,  -1, 1,  0,  -1, 0,  0,  0,  -1, -2, -2, 0,  -1, -2, -1, 4,              //
                                     0,  -1, 0,  -1, -1, -1, -1, -2, -2, -1, -1, -1, -1, -2, -1, 1,  5,          //
                                     -3, -3, -4, -4, -2, -2, -3, -2, -2, -3, -2, -3, -1, 1,  -4, -3, -2, 11,     //
                                     -2, -2, -2, -3, -2, -1, -2, -3, 2,  -1, -1, -2, -1, 3,  -3, -2, -2, 2,  7,  //
                                     0,  -3, -3, -3, -1, -2, -2, -3, -3, 3,  1,  -2, 1,  -1, -2, -2, 0,  -3, -1, 4};
constexpr int kSameName = 5, kOtherName = -4, kGapBegin = -11, kGapMore = -1;

/// A residue as the alignment sees it.
struct Unit {
    Name name;
    std::size_t letter = std::string_view::npos;  ///< index into kLetters, if it is an amino acid of these
};

int scoreOf(const Unit& a, const Unit& b) {
    if (a.letter == std::string_view::npos || b.letter == std::string_view::npos)
        return a.name == b.name ? kSameName : kOtherName;
    const auto [low, high] = std::minmax(a.letter, b.letter);
    return kBlosum62[high * (high + 1) / 2 + low];
}

/// Fills the table of an alignment and walks back through it.
class Alignment {
public:
    Alignment(std::span<const Unit> a, std::span<const Unit> b)
        : a_(a), b_(b), from_(a.size() * b.size()), best_(b.size() + 1), gapInB_(b.size() + 1, kGapBegin) {
        for (std::size_t i = 0; i < a_.size(); ++i) fillRow(i);
    }

    std::vector<std::pair<std::size_t, std::size_t>> pairs() const {
        std::vector<std::pair<std::size_t, std::size_t>> pairs;
        std::size_t i = endA_, j = endB_;
        std::uint8_t state = kPair;
        while (i > 0 && j > 0) {
            const std::uint8_t from = from_[(i - 1) * b_.size() + j - 1];
            if (state == kPair) state = static_cast<std::uint8_t>(from & kStates);
            if (state == kPair) {
                pairs.emplace_back(--i, --j);
            } else {
                const bool inA = state == kGapInA;
                if ((from & (inA ? kMoreInA : kMoreInB)) == 0) state = kPair;
                --(inA ? j : i);
            }
        }
        std::reverse(pairs.begin(), pairs.end());
        return pairs;
    }

private:
    /// How the best alignment of two beginnings ends; and whether the gaps that end there are longer than one.
    enum : std::uint8_t { kPair = 0, kGapInA = 1, kGapInB = 2, kStates = 3, kMoreInA = 4, kMoreInB = 8 };

    void fillRow(std::size_t i) {
        int diagonal = best_[0], gapInA = kGapBegin;
        for (std::size_t j = 0; j < b_.size(); ++j) {
            std::uint8_t& from = from_[i * b_.size() + j];
            const int openA = best_[j] + kGapBegin, openB = best_[j + 1] + kGapBegin;
            const int moreA = gapInA + kGapMore, moreB = gapInB_[j + 1] + kGapMore;
            gapInA = std::max(openA, moreA);
            gapInB_[j + 1] = std::max(openB, moreB);
            const int pair = diagonal + scoreOf(a_[i], b_[j]);
            diagonal = best_[j + 1];
            int& best = best_[j + 1] = std::max({pair, gapInA, gapInB_[j + 1]});
            from = best == pair ? kPair : best == gapInA ? kGapInA : kGapInB;
            from = static_cast<std::uint8_t>(from | (moreA > openA ? kMoreInA : 0) | (moreB > openB ? kMoreInB : 0));
            const bool atEnd = i + 1 == a_.size() || j + 1 == b_.size();
            if (!atEnd || (endA_ > 0 && best <= endScore_)) continue;
            endScore_ = best;
            endA_ = i + 1;
            endB_ = j + 1;
        }
    }

    std::span<const Unit> a_, b_;
    std::vector<std::uint8_t> from_;
    std::vector<int> best_, gapInB_;  ///< of the latest row
    int endScore_ = 0;
    std::size_t endA_ = 0, endB_ = 0;  ///< where the best alignment ends
};

/// Selected atoms, at each position those of the conformer that is drawn, if there are any.
std::vector<bool> inDrawnConformer(const ResidueFacts& facts, const std::vector<bool>& selected) {
    const Molecule& molecule = facts.molecule();
    std::vector<bool> drawn(selected.size()), settled(molecule.residues.size());
    const auto positionOf = [&](std::size_t atom) { return facts.positions()[molecule.atoms[atom].residue]; };
    for (const std::uint32_t atom : facts.conformer()) {
        drawn[atom] = selected[atom];
        if (selected[atom]) settled[positionOf(atom)] = true;
    }
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (selected[i] && !settled[positionOf(i)]) drawn[i] = true;
    return drawn;
}

/// Residues with a selected atom, in order. Excludes waters: their order differs arbitrarily between files.
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

std::vector<Unit> sequenceOf(const Molecule& molecule, const std::vector<std::uint32_t>& residues) {
    std::vector<Unit> units;
    for (const std::uint32_t residue : residues) {
        const Name& name = molecule.residues[residue].name;
        const char letter = aminoAcidLetter(name);
        units.push_back({name, letter ? kLetters.find(letter) : std::string_view::npos});
    }
    return units;
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

AtomPairs matchAtoms(const ResidueFacts& facts, const std::vector<bool>& first, const std::vector<bool>& second) {
    const Molecule& molecule = facts.molecule();
    const std::vector<bool> inFirst = inDrawnConformer(facts, first), inSecond = inDrawnConformer(facts, second);
    const std::vector<std::uint32_t> a = residuesOf(molecule, inFirst), b = residuesOf(molecule, inSecond);
    AtomPairs pairs;
    pairs.residues = std::min(a.size(), b.size());
    const std::vector<Unit> one = sequenceOf(molecule, a), two = sequenceOf(molecule, b);
    for (const auto& [i, j] : Alignment(one, two).pairs()) {
        const Residue &residue = molecule.residues[a[i]], &other = molecule.residues[b[j]];
        pairs.sameResidues += residue.name == other.name ? 1 : 0;
        const std::vector<std::uint32_t> others = namedAtoms(molecule, other, inSecond);
        for (const std::uint32_t atom : namedAtoms(molecule, residue, inFirst))
            for (const std::uint32_t like : others) {
                if (molecule.atoms[atom].name != molecule.atoms[like].name) continue;
                pairs.first.push_back(atom);
                pairs.second.push_back(like);
            }
    }
    return pairs;
}

}  // namespace nacre
