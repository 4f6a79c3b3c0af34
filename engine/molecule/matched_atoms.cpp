#include "engine/molecule/matched_atoms.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>

#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/superpose.h"

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

/// A residue for the alignment.
struct Unit {
    Name name;
    std::size_t letter = std::string_view::npos;  ///< index into kLetters, if it is one of these amino acids
    friend auto operator<=>(const Unit& a, const Unit& b) {
        return std::tie(a.letter, a.name.bytes) <=> std::tie(b.letter, b.name.bytes);
    }
};

int computeScore(const Unit& a, const Unit& b) {
    if (a.letter == std::string_view::npos || b.letter == std::string_view::npos)
        return a.name == b.name ? kSameName : kOtherName;
    const auto [low, high] = std::minmax(a.letter, b.letter);
    return kBlosum62[high * (high + 1) / 2 + low];
}

/// Fills an alignment's table, and traces the best path back.
class Alignment {
public:
    Alignment(std::span<const Unit> a, std::span<const Unit> b)
        : a_(a), b_(b), from_(a.size() * b.size()), best_(b.size() + 1), gapInB_(b.size() + 1, kGapBegin) {
        for (std::size_t i = 0; i < a_.size(); ++i) fillRow(i);
    }

    int score() const { return endScore_; }

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
    /// How the best alignment of two prefixes ends, and whether gaps that end there are longer than one.
    enum : std::uint8_t { kPair = 0, kGapInA = 1, kGapInB = 2, kStates = 3, kMoreInA = 4, kMoreInB = 8 };

    void fillRow(std::size_t i) {
        int diagonal = best_[0], gapInA = kGapBegin;
        for (std::size_t j = 0; j < b_.size(); ++j) {
            std::uint8_t& from = from_[i * b_.size() + j];
            const int openA = best_[j] + kGapBegin, openB = best_[j + 1] + kGapBegin;
            const int moreA = gapInA + kGapMore, moreB = gapInB_[j + 1] + kGapMore;
            gapInA = std::max(openA, moreA);
            gapInB_[j + 1] = std::max(openB, moreB);
            const int pair = diagonal + computeScore(a_[i], b_[j]);
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
    std::vector<int> best_, gapInB_;  ///< of the current row
    int endScore_ = 0;
    std::size_t endA_ = 0, endB_ = 0;  ///< where the best alignment ends
};

/// Selected atoms; at each position only those of the drawn conformer, if any is selected.
std::vector<bool> inDrawnConformer(const ResidueFacts& facts, const std::vector<bool>& selected) {
    const Molecule& molecule = facts.molecule();
    std::vector<bool> drawn(selected.size()), settled(molecule.residues.size());
    const auto findPosition = [&](std::size_t atom) { return facts.positions()[molecule.atoms[atom].residue]; };
    for (const std::uint32_t atom : facts.conformer()) {
        drawn[atom] = selected[atom];
        if (selected[atom]) settled[findPosition(atom)] = true;
    }
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (selected[i] && !settled[findPosition(i)]) drawn[i] = true;
    return drawn;
}

/// Residues with a selected atom, in order. Excludes waters: their order differs arbitrarily between files.
std::vector<std::uint32_t> listResidues(const Molecule& molecule, const std::vector<bool>& selected) {
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

std::vector<Unit> makeSequence(const Molecule& molecule, const std::vector<std::uint32_t>& residues) {
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

/// Selected residues of one chain.
struct Strand {
    std::vector<std::uint32_t> residues;
    std::size_t sequence = 0;  ///< index of the sequence; equal sequences share one
};

/// Paired residues of two strands, as positions in them.
struct StrandPair {
    std::size_t first = 0, second = 0;  ///< strands
    double rmsd = 0;                    ///< of the first paired atoms of each residue, as placed
};

using ResiduePairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// The alignment of two sequences.
struct Likeness {
    ResiduePairs pairs;
    int score = 0;
    std::size_t same = 0;  ///< pairs of equal names
};

/// Fraction of equal residues from which two sequences are similar. Short ones agree by chance: Sander and Schneider,
/// Proteins 9 (1991) 56, require 290.15 * length^-0.562 percent for 10 to 80 residues.
double leastSame(std::size_t length) {
    constexpr double kLeast = 0.3, kShortest = 10;
    const double most = static_cast<double>(length);
    return most * std::max(kLeast, std::min(1.0, 2.9015 * std::pow(std::max(most, kShortest), -0.562)));
}

/// Pairs the strands of two selections.
class StrandMatch {
public:
    StrandMatch(const Molecule& molecule, const std::vector<bool>& inFirst, const std::vector<bool>& inSecond,
                bool byChain)
        : molecule_(molecule),
          inFirst_(inFirst),
          inSecond_(inSecond),
          byChain_(byChain),
          first_(findStrands(inFirst)),
          second_(findStrands(inSecond)) {}

    AtomPairs pairs(Placing placing) {
        if (first_.empty() || second_.empty()) return {};
        std::vector<StrandPair> chosen;
        if (first_.size() == 1 && second_.size() == 1)
            chosen.push_back({});
        else if (placing == Placing::settled)
            chosen = nearest({}, Superposition{}, kAnyDistance);
        else
            chosen = bestStart();
        std::sort(chosen.begin(), chosen.end(),
                  [](const StrandPair& l, const StrandPair& r) { return l.first < r.first; });
        return collectAtoms(chosen);
    }

private:
    static constexpr double kNear = 8, kAnyDistance = 1e9;  // Å

    std::vector<Strand> findStrands(const std::vector<bool>& selected) {
        std::vector<Strand> strands;
        std::map<std::uint32_t, std::size_t> ofChain;
        for (const std::uint32_t residue : listResidues(molecule_, selected)) {
            const std::uint32_t chain = byChain_ ? molecule_.residues[residue].chain : 0;
            const auto [at, added] = ofChain.emplace(chain, strands.size());
            if (added) strands.emplace_back();
            strands[at->second].residues.push_back(residue);
        }
        for (Strand& strand : strands) {
            const auto known =
                sequences_.try_emplace(makeSequence(molecule_, strand.residues), sequences_.size()).first;
            strand.sequence = known->second;
        }
        return strands;
    }

    /// Computed once for each pair of different sequences.
    const Likeness& likeness(std::size_t first, std::size_t second) {
        const Strand &one = first_[first], &other = second_[second];
        const auto [at, added] = known_.try_emplace({one.sequence, other.sequence});
        if (!added) return at->second;
        const std::vector<Unit> a = makeSequence(molecule_, one.residues), b = makeSequence(molecule_, other.residues);
        const Alignment alignment(a, b);
        Likeness like{alignment.pairs(), alignment.score()};
        for (const auto& [i, j] : like.pairs) like.same += a[i].name == b[j].name;
        return at->second = std::move(like);
    }

    bool alike(std::size_t first, std::size_t second) {
        const std::size_t shorter = std::min(first_[first].residues.size(), second_[second].residues.size());
        const Likeness& like = likeness(first, second);
        return like.pairs.size() >= 3 && static_cast<double>(like.same) >= leastSame(shorter);
    }

    void addAtoms(const StrandPair& pair, AtomPairs& atoms) {
        const Strand &a = first_[pair.first], &b = second_[pair.second];
        for (const auto& [i, j] : likeness(pair.first, pair.second).pairs) {
            const Residue &residue = molecule_.residues[a.residues[i]], &other = molecule_.residues[b.residues[j]];
            const std::vector<std::uint32_t> others = namedAtoms(molecule_, other, inSecond_);
            for (const std::uint32_t atom : namedAtoms(molecule_, residue, inFirst_))
                for (const std::uint32_t like : others) {
                    if (molecule_.atoms[atom].name != molecule_.atoms[like].name) continue;
                    atoms.first.push_back(atom);
                    atoms.second.push_back(like);
                }
        }
    }

    AtomPairs collectAtoms(const std::vector<StrandPair>& chosen) {
        AtomPairs atoms;
        for (const StrandPair& pair : chosen) {
            addAtoms(pair, atoms);
            const Strand &a = first_[pair.first], &b = second_[pair.second];
            atoms.residues += std::min(a.residues.size(), b.residues.size());
            atoms.sameResidues += likeness(pair.first, pair.second).same;
            if (byChain_)
                atoms.chains.emplace_back(molecule_.residues[a.residues.front()].chain,
                                          molecule_.residues[b.residues.front()].chain);
        }
        return atoms;
    }

    Superposition superposed(const AtomPairs& atoms) const {
        std::vector<glm::dvec3> from, to;
        for (const std::uint32_t atom : atoms.first) from.emplace_back(molecule_.atoms[atom].position);
        for (const std::uint32_t atom : atoms.second) to.emplace_back(molecule_.atoms[atom].position);
        return to.empty() ? Superposition{} : superpose(to, from);
    }

    /// RMSD over the first paired atom of each residue.
    double computeRmsd(const StrandPair& pair, const Superposition& motion) {
        double squares = 0;
        std::size_t count = 0;
        for (const auto& [i, j] : likeness(pair.first, pair.second).pairs) {
            const std::optional<glm::dvec3> a = findPlace(first_[pair.first].residues[i], inFirst_);
            const std::optional<glm::dvec3> b = findPlace(second_[pair.second].residues[j], inSecond_);
            if (!a || !b) continue;
            const glm::dvec3 d = motion(*a) - *b;
            squares += glm::dot(d, d);
            ++count;
        }
        return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : kAnyDistance;
    }

    /// The alpha carbon or the phosphorus, else the first selected atom.
    std::optional<glm::dvec3> findPlace(std::uint32_t index, const std::vector<bool>& selected) const {
        const Residue& residue = molecule_.residues[index];
        std::optional<glm::dvec3> place;
        for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i) {
            if (!selected[i]) continue;
            const Name& name = molecule_.atoms[i].name;
            if (name == Name("CA") || name == Name("P")) return glm::dvec3(molecule_.atoms[i].position);
            if (!place) place = glm::dvec3(molecule_.atoms[i].position);
        }
        return place;
    }

    /// Adds the nearest pairs of similar strands to the settled pairs.
    std::vector<StrandPair> nearest(std::vector<StrandPair> settled, const Superposition& motion, double most) {
        std::vector<StrandPair> near;
        for (std::size_t i = 0; i < first_.size(); ++i)
            for (std::size_t j = 0; j < second_.size(); ++j) {
                if (!alike(i, j)) continue;
                StrandPair pair{i, j};
                pair.rmsd = computeRmsd(pair, motion);
                if (pair.rmsd <= most) near.push_back(pair);
            }
        std::stable_sort(near.begin(), near.end(),
                         [](const StrandPair& l, const StrandPair& r) { return l.rmsd < r.rmsd; });
        for (const StrandPair& pair : near) {
            const bool taken = std::any_of(settled.begin(), settled.end(), [&](const StrandPair& other) {
                return other.first == pair.first || other.second == pair.second;
            });
            if (!taken) settled.push_back(pair);
        }
        return settled;
    }

    /// Tries each best pair of strands as the first pair.
    std::vector<StrandPair> bestStart() {
        StrandPair top;
        for (std::size_t i = 0; i < first_.size(); ++i)
            for (std::size_t j = 0; j < second_.size(); ++j)
                if (likeness(i, j).score > likeness(top.first, top.second).score) top = {i, j};
        std::vector<StrandPair> best;
        std::size_t most = 0;
        double rmsd = kAnyDistance;
        for (std::size_t j = 0; j < second_.size(); ++j) {
            if (likeness(top.first, j).score < likeness(top.first, top.second).score) continue;
            AtomPairs start;
            addAtoms({top.first, j}, start);
            const std::vector<StrandPair> found = nearest({{top.first, j}}, superposed(start), kNear);
            const AtomPairs atoms = collectAtoms(found);
            const double rmsdOfAll = superposed(atoms).rmsd;
            if (atoms.first.size() < most || (atoms.first.size() == most && rmsdOfAll >= rmsd)) continue;
            best = found;
            most = atoms.first.size();
            rmsd = rmsdOfAll;
        }
        return best;
    }

    const Molecule& molecule_;
    const std::vector<bool>&inFirst_, &inSecond_;
    bool byChain_;
    std::map<std::vector<Unit>, std::size_t> sequences_;  ///< their numbers; findStrands() fills it, so it comes first
    std::vector<Strand> first_, second_;
    std::map<std::pair<std::size_t, std::size_t>, Likeness> known_;
};

bool anyPolymer(const ResidueFacts& facts, const std::vector<bool>& selected) {
    for (std::uint32_t i = 0; i < selected.size(); ++i)
        if (selected[i] && facts.isPolymer(facts.molecule().atoms[i].residue)) return true;
    return false;
}

}  // namespace

AtomPairs matchAtoms(const ResidueFacts& facts, const std::vector<bool>& first, const std::vector<bool>& second,
                     Placing placing) {
    const Molecule& molecule = facts.molecule();
    std::vector<bool> inFirst = inDrawnConformer(facts, first), inSecond = inDrawnConformer(facts, second);
    const bool polymer = anyPolymer(facts, inFirst) && anyPolymer(facts, inSecond);
    for (std::uint32_t i = 0; polymer && i < inFirst.size(); ++i)
        if (!facts.isPolymer(molecule.atoms[i].residue)) inFirst[i] = inSecond[i] = false;
    return StrandMatch(molecule, inFirst, inSecond, polymer).pairs(placing);
}

}  // namespace nacre
