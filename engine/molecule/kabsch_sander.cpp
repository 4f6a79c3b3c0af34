#include "engine/molecule/kabsch_sander.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "engine/molecule/zhang_skolnik.h"

namespace nacre {
namespace {

constexpr double kCouplingOfCharges = -27.888;  // -332 * 0.42 * 0.2 kcal/mol Å: the dipoles of N-H and C=O
constexpr double kWeakestBond = -0.5;           // kcal/mol
constexpr double kStrongestBond = -9.9;         // for nearly coinciding atoms
constexpr double kLeastDistance = 0.5;          // Å
constexpr double kLongestPeptideBond = 2.5;     // Å
constexpr float kFarthestCa = 9;                // Å, between residues whose peptide groups may be bonded
constexpr std::size_t kMostNeighbours = 400;    // real structures have about sixty
constexpr std::uint32_t kNone = 0xffffffffu;

struct HydrogenBond {
    std::uint32_t acceptor = kNone;
    double energy = 0;
};

/// A residue with a whole backbone.
struct Peptide {
    std::uint32_t residue = 0;
    std::uint32_t piece = 0;  ///< unbroken part of the chain
    int model = 1;
    bool donates = false;  ///< has a hydrogen: neither proline nor the first of its piece
    glm::dvec3 n{}, ca{}, c{}, o{}, h{};
    std::array<HydrogenBond, 2> bonds{};  ///< the two strongest that its N-H gives
};

std::vector<Peptide> wholeBackbones(const ResidueFacts& facts) {
    const Molecule& molecule = facts.molecule();
    const std::vector<std::uint32_t>& positions = facts.positions();
    struct Found {
        std::array<std::uint32_t, 4> atoms{kNone, kNone, kNone, kNone};
    };
    static constexpr std::array<std::string_view, 4> kNames{"N", "CA", "C", "O"};
    std::vector<Found> found(molecule.residues.size());
    for (const std::uint32_t index : facts.conformer()) {
        const Atom& atom = molecule.atoms[index];
        const std::string_view name = atom.name.view();
        for (std::size_t i = 0; i < kNames.size(); ++i)
            if (name == kNames[i] && found[positions[atom.residue]].atoms[i] == kNone)
                found[positions[atom.residue]].atoms[i] = index;
    }
    std::vector<Peptide> peptides;
    for (std::uint32_t r = 0; r < found.size(); ++r) {
        const auto& atoms = found[r].atoms;
        if (std::find(atoms.begin(), atoms.end(), kNone) != atoms.end()) continue;
        Peptide peptide{.residue = r, .model = molecule.chains[molecule.residues[r].chain].model};
        glm::dvec3* places[] = {&peptide.n, &peptide.ca, &peptide.c, &peptide.o};
        for (std::size_t i = 0; i < 4; ++i) *places[i] = molecule.atoms[atoms[i]].position;
        peptides.push_back(peptide);
    }
    return peptides;
}

void findPiecesAndHydrogens(const Molecule& molecule, std::vector<Peptide>& peptides) {
    for (std::size_t i = 1; i < peptides.size(); ++i) {
        const Peptide& before = peptides[i - 1];
        Peptide& peptide = peptides[i];
        const Residue &a = molecule.residues[before.residue], &b = molecule.residues[peptide.residue];
        const bool joined = a.chain == b.chain && glm::distance(before.c, peptide.n) <= kLongestPeptideBond;
        peptide.piece = before.piece + !joined;
        const double length = glm::distance(before.c, before.o);
        if (!joined || b.name == Name("PRO") || length == 0) continue;
        peptide.donates = true;
        peptide.h = peptide.n + (before.c - before.o) / length;
    }
}

/// kcal/mol, to three digits as in the original program.
double bondEnergy(const Peptide& donor, const Peptide& acceptor) {
    const double on = glm::distance(acceptor.o, donor.n), ch = glm::distance(acceptor.c, donor.h);
    const double oh = glm::distance(acceptor.o, donor.h), cn = glm::distance(acceptor.c, donor.n);
    if (std::min({on, ch, oh, cn}) < kLeastDistance) return kStrongestBond;
    const double energy = kCouplingOfCharges * (1 / oh + 1 / cn - 1 / on - 1 / ch);
    return std::max(std::round(energy * 1000) / 1000, kStrongestBond);
}

void considerBond(Peptide& donor, std::uint32_t acceptor, const Peptide& of) {
    if (!donor.donates) return;
    const HydrogenBond bond{acceptor, bondEnergy(donor, of)};
    if (bond.energy >= donor.bonds[1].energy) return;
    donor.bonds[1] = bond;
    if (bond.energy < donor.bonds[0].energy) std::swap(donor.bonds[0], donor.bonds[1]);
}

/// Residues in cells of 9 Å, sorted, so that those near one are found in nine ranges.
class Cells {
public:
    explicit Cells(const std::vector<Peptide>& peptides) {
        for (std::uint32_t i = 0; i < peptides.size(); ++i) entries_.push_back({findCell(peptides[i]), i});
        std::sort(entries_.begin(), entries_.end());
    }

    /// Peptides in its cell and the neighbouring ones; false if there are more than kMostNeighbours.
    bool near(const Peptide& peptide, std::vector<std::uint32_t>& neighbours) const {
        neighbours.clear();
        const auto [model, x, y, z] = findCell(peptide);
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                auto at =
                    std::lower_bound(entries_.begin(), entries_.end(), Entry{Cell{model, x + dx, y + dy, z - 1}, 0});
                for (; at != entries_.end() && at->first <= Cell{model, x + dx, y + dy, z + 1}; ++at) {
                    if (neighbours.size() == kMostNeighbours) return false;
                    neighbours.push_back(at->second);
                }
            }
        return true;
    }

private:
    using Cell = std::tuple<int, std::int64_t, std::int64_t, std::int64_t>;
    using Entry = std::pair<Cell, std::uint32_t>;

    static Cell findCell(const Peptide& peptide) {
        const glm::dvec3 cell = glm::floor(peptide.ca / static_cast<double>(kFarthestCa));
        return {peptide.model, static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y),
                static_cast<std::int64_t>(cell.z)};
    }

    std::vector<Entry> entries_;
};

/// Pairs of residues that may be bonded, lower index first.
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs nearPairs(const std::vector<Peptide>& peptides) {
    const Cells cells(peptides);
    Pairs pairs;
    std::vector<std::uint32_t> neighbours;
    for (std::uint32_t i = 0; i < peptides.size(); ++i) {
        if (!cells.near(peptides[i], neighbours)) continue;
        for (const std::uint32_t j : neighbours)
            if (i < j && glm::distance(peptides[i].ca, peptides[j].ca) < kFarthestCa) pairs.push_back({i, j});
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

enum class BridgeKind { none, parallel, antiparallel };

/// Consecutive bridges, with i ascending and j ascending or descending.
struct Ladder {
    BridgeKind kind = BridgeKind::none;
    std::vector<std::uint32_t> i, j;  ///< both ascending
};

class Assignment {
public:
    explicit Assignment(const std::vector<Peptide>& peptides)
        : peptides_(peptides), kinds_(peptides.size(), SecondaryStructure::none) {}

    std::vector<SecondaryStructure> run(const Pairs& pairs) {
        strands(pairs);
        helices();
        return std::move(kinds_);
    }

private:
    /// Whether the N-H of one residue is bonded to the C=O of another.
    bool bonded(std::uint32_t donor, std::uint32_t acceptor) const {
        for (const HydrogenBond& bond : peptides_[donor].bonds)
            if (bond.acceptor == acceptor && bond.energy < kWeakestBond) return true;
        return false;
    }

    /// Whether the chain has no break from one to the other.
    bool whole(std::uint32_t from, std::uint32_t to) const {
        return to < peptides_.size() && peptides_[from].piece == peptides_[to].piece;
    }

    BridgeKind bridge(std::uint32_t i, std::uint32_t j) const {
        if (i == 0 || j == 0 || !whole(i - 1, i + 1) || !whole(j - 1, j + 1)) return BridgeKind::none;
        if ((bonded(i + 1, j) && bonded(j, i - 1)) || (bonded(j + 1, i) && bonded(i, j - 1)))
            return BridgeKind::parallel;
        if ((bonded(i + 1, j - 1) && bonded(j + 1, i - 1)) || (bonded(j, i) && bonded(i, j)))
            return BridgeKind::antiparallel;
        return BridgeKind::none;
    }

    std::vector<Ladder> ladders(const Pairs& pairs) const {
        std::vector<Ladder> all;
        // Current end of a ladder: only the next residue can extend it, so older ones are skipped.
        std::size_t firstOpen = 0;
        for (const auto& pair : pairs) {
            const auto i = pair.first, j = pair.second;  // a lambda of Clang 14 takes no structured binding
            if (j < i + 3) continue;
            const BridgeKind kind = bridge(i, j);
            if (kind == BridgeKind::none) continue;
            while (firstOpen < all.size() && all[firstOpen].i.back() + 1 < i) ++firstOpen;
            const auto continues = [&](const Ladder& ladder) {
                if (ladder.kind != kind || ladder.i.back() + 1 != i) return false;
                return kind == BridgeKind::parallel ? ladder.j.back() + 1 == j : ladder.j.front() == j + 1;
            };
            const auto open = std::find_if(all.begin() + static_cast<std::ptrdiff_t>(firstOpen), all.end(), continues);
            if (open == all.end()) {
                all.push_back({kind, {i}, {j}});
                continue;
            }
            open->i.push_back(i);
            open->j.insert(kind == BridgeKind::parallel ? open->j.end() : open->j.begin(), j);
        }
        return all;
    }

    /// Whether two ladders form one with a bulge: at most one extra residue on one strand, and four on the other.
    bool bulge(const Ladder& a, const Ladder& b) const {
        const auto between = [](std::uint32_t from, std::uint32_t to) {
            return static_cast<std::int64_t>(to) - static_cast<std::int64_t>(from);
        };
        const std::int64_t gap = between(a.i.back(), b.i.front());
        if (a.kind != b.kind || gap <= 0 || gap >= 6) return false;
        if (!whole(std::min(a.i.front(), b.i.front()), std::max(a.i.back(), b.i.back())) ||
            !whole(std::min(a.j.front(), b.j.front()), std::max(a.j.back(), b.j.back())))
            return false;
        const std::int64_t other =
            a.kind == BridgeKind::parallel ? between(a.j.back(), b.j.front()) : between(b.j.back(), a.j.front());
        return other >= 0 && ((other < 6 && gap < 3) || other < 3);
    }

    void joinBulges(std::vector<Ladder>& all) const {
        std::stable_sort(all.begin(), all.end(), [](const Ladder& a, const Ladder& b) { return a.i[0] < b.i[0]; });
        for (std::size_t a = 0; a < all.size(); ++a)
            // Sorted: once one begins six residues after the end, all others do.
            for (std::size_t b = a + 1; b < all.size() && all[b].i.front() < all[a].i.back() + 6; ++b) {
                if (all[a].kind == BridgeKind::none || !bulge(all[a], all[b])) continue;
                all[a].i.insert(all[a].i.end(), all[b].i.begin(), all[b].i.end());
                all[a].j.insert(all[a].kind == BridgeKind::parallel ? all[a].j.end() : all[a].j.begin(),
                                all[b].j.begin(), all[b].j.end());
                all[b].kind = BridgeKind::none;
            }
        std::erase_if(all, [](const Ladder& ladder) { return ladder.kind == BridgeKind::none; });
    }

    void strands(const Pairs& pairs) {
        std::vector<Ladder> all = ladders(pairs);
        joinBulges(all);
        for (const Ladder& ladder : all)
            for (const auto* side : {&ladder.i, &ladder.j})
                for (std::uint32_t k = side->front(); k <= side->back(); ++k) kinds_[k] = SecondaryStructure::strand;
    }

    /// Two consecutive n-turns make a helix of the n residues between. Alpha takes precedence over strands, the others
    /// fill gaps, the pi helix also replaces alpha.
    void helices() {
        std::vector<int> turns(kinds_.size());  // turn length of the residue's helix
        for (const std::uint32_t n : {4u, 3u, 5u})
            for (std::uint32_t i = 1; i + n < peptides_.size(); ++i) {
                if (!turn(i - 1, n) || !turn(i, n)) continue;
                bool free = true;
                for (std::uint32_t k = i; k < i + n; ++k) {
                    const bool none = kinds_[k] == SecondaryStructure::none;
                    const bool same = turns[k] == static_cast<int>(n) || (n == 5 && turns[k] == 4);
                    free = free && (n == 4 || none || same);
                }
                if (!free) continue;
                for (std::uint32_t k = i; k < i + n; ++k) {
                    kinds_[k] = SecondaryStructure::helix;
                    turns[k] = static_cast<int>(n);
                }
            }
    }

    bool turn(std::uint32_t from, std::uint32_t n) const { return whole(from, from + n) && bonded(from + n, from); }

    const std::vector<Peptide>& peptides_;
    std::vector<SecondaryStructure> kinds_;
};

}  // namespace

std::vector<SecondaryStructure> kabschSander(const ResidueFacts& facts) {
    const Molecule& molecule = facts.molecule();
    std::vector<SecondaryStructure> kinds(molecule.residues.size(), SecondaryStructure::none);
    std::vector<Peptide> peptides = wholeBackbones(facts);
    if (peptides.empty()) return kinds;
    findPiecesAndHydrogens(molecule, peptides);
    const Pairs pairs = nearPairs(peptides);
    for (const auto& [i, j] : pairs) {
        considerBond(peptides[i], j, peptides[j]);
        if (j != i + 1) considerBond(peptides[j], i, peptides[i]);  // its N is bonded to the C before it
    }
    const std::vector<SecondaryStructure> found = Assignment(peptides).run(pairs);
    for (std::size_t i = 0; i < peptides.size(); ++i) kinds[peptides[i].residue] = found[i];
    for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = kinds[facts.positions()[i]];
    return kinds;
}

std::vector<SecondaryStructure> secondaryStructure(const ResidueFacts& facts) {
    const Molecule& molecule = facts.molecule();
    std::vector<SecondaryStructure> kinds(molecule.residues.size());
    std::vector<bool> stated(molecule.chains.size());
    for (std::size_t i = 0; i < kinds.size() && molecule.statesSecondaryStructure; ++i) {
        kinds[i] = molecule.residues[i].secondary;
        if (kinds[i] != SecondaryStructure::none) stated[molecule.residues[i].chain] = true;
    }
    if (std::find(stated.begin(), stated.end(), false) == stated.end()) return kinds;
    const std::vector<SecondaryStructure> ofBonds = kabschSander(facts);
    const std::vector<SecondaryStructure> ofCarbons = zhangSkolnik(facts);  // other chains'
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (!stated[molecule.residues[i].chain])
            kinds[i] = ofCarbons[i] != SecondaryStructure::none ? ofCarbons[i] : ofBonds[i];
    return kinds;
}

}  // namespace nacre
