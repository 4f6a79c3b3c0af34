// The smallest rings: bridges first (Tarjan 1974), then shortest cycles through each atom (Horton 1987), of which those
// that are no sum of smaller ones are kept. The result is the union of all smallest sets of rings, so that no face of a
// cage is missing.

#include <algorithm>
#include <cmath>

#include "engine/molecule/chemistry/steps.h"

namespace nacre {
namespace {

/// Marks the bonds that lie on any cycle.
class CycleBonds {
public:
    explicit CycleBonds(const Chemistry& chemistry)
        : chemistry_(chemistry), entered_(chemistry.present.size()), lowest_(chemistry.present.size()) {}

    std::vector<std::uint8_t> find() {
        std::vector<std::uint8_t> cyclic(chemistry_.order.size());
        for (std::uint32_t i = 0; i < entered_.size(); ++i)
            if (chemistry_.present[i] && !entered_[i]) visit(i, cyclic);
        return cyclic;
    }

private:
    struct Frame {
        std::uint32_t atom, bond, next;
    };
    static constexpr std::uint32_t kNoBond = 0xffffffffu;

    void visit(std::uint32_t start, std::vector<std::uint8_t>& cyclic) {
        stack_.assign(1, {start, kNoBond, 0});
        entered_[start] = lowest_[start] = ++clock_;
        while (!stack_.empty()) {
            Frame& top = stack_.back();
            const auto around = chemistry_.of(top.atom);
            if (top.next == around.size()) {
                const Frame done = top;
                stack_.pop_back();
                if (stack_.empty()) break;
                const std::uint32_t parent = stack_.back().atom;
                lowest_[parent] = std::min(lowest_[parent], lowest_[done.atom]);
                cyclic[done.bond] = lowest_[done.atom] <= entered_[parent];
                continue;
            }
            const Neighbour n = around[top.next++];
            if (n.bond == top.bond) continue;
            if (entered_[n.atom]) {
                cyclic[n.bond] = 1;
                lowest_[top.atom] = std::min(lowest_[top.atom], entered_[n.atom]);
            } else {
                entered_[n.atom] = lowest_[n.atom] = ++clock_;
                stack_.push_back({n.atom, n.bond, 0});
            }
        }
    }

    const Chemistry& chemistry_;
    std::vector<std::uint32_t> entered_, lowest_;
    std::vector<Frame> stack_;
    std::uint32_t clock_ = 0;
};

struct Cycle {
    std::vector<std::uint32_t> atoms;
    std::vector<std::uint32_t> bonds;  // ascending
};

/// Shortest cycles through an atom, of at most kLargestRing atoms, by breadth-first search over cyclic bonds.
class ShortCycles {
public:
    ShortCycles(const Chemistry& chemistry, const std::vector<std::uint8_t>& cyclic)
        : chemistry_(chemistry), cyclic_(cyclic), depth_(chemistry.present.size()), from_(chemistry.present.size()) {}

    void through(std::uint32_t root, std::vector<Cycle>& found) {
        queue_.assign(1, root);
        depth_[root] = 1;
        from_[root] = {root, 0};
        const std::size_t before = found.size();
        for (std::size_t at = 0; at < queue_.size() && at < kMostVisited && found.size() - before < kMostPerAtom;
             ++at) {
            const std::uint32_t atom = queue_[at];
            for (const Neighbour& n : chemistry_.of(atom)) {
                if (!cyclic_[n.bond] || n.bond == from_[atom].bond) continue;
                if (depth_[n.atom] == 0) {
                    if (2 * depth_[atom] > kLargestRing) continue;
                    depth_[n.atom] = depth_[atom] + 1;
                    from_[n.atom] = {atom, n.bond};
                    queue_.push_back(n.atom);
                } else if (depth_[atom] + depth_[n.atom] - 1 <= kLargestRing && atom < n.atom) {
                    addCycle(root, atom, n, found);
                }
            }
        }
        for (const std::uint32_t atom : queue_) depth_[atom] = 0;
    }

private:
    // Far beyond any real cage; a crowd of atoms that are all bonded to each other would take forever.
    static constexpr std::size_t kMostVisited = 2000, kMostPerAtom = 60;

    void addCycle(std::uint32_t root, std::uint32_t a, const Neighbour& across, std::vector<Cycle>& found) {
        Cycle cycle;
        cycle.bonds.push_back(across.bond);
        std::vector<std::uint32_t> back;
        for (std::uint32_t i = a; i != root; i = from_[i].atom) {
            cycle.atoms.push_back(i);
            cycle.bonds.push_back(from_[i].bond);
        }
        for (std::uint32_t i = across.atom; i != root; i = from_[i].atom) {
            if (std::find(cycle.atoms.begin(), cycle.atoms.end(), i) != cycle.atoms.end()) return;
            back.push_back(i);
            cycle.bonds.push_back(from_[i].bond);
        }
        if (cycle.bonds.size() < 3) return;
        cycle.atoms.push_back(root);
        cycle.atoms.insert(cycle.atoms.end(), back.rbegin(), back.rend());
        std::sort(cycle.bonds.begin(), cycle.bonds.end());
        found.push_back(std::move(cycle));
    }

    const Chemistry& chemistry_;
    const std::vector<std::uint8_t>& cyclic_;
    std::vector<std::uint32_t> depth_;
    std::vector<Neighbour> from_;
    std::vector<std::uint32_t> queue_;
};

/// Number of independent cycles in each connected part of the cyclic bonds: bonds - atoms + 1.
class CyclesLeft {
public:
    CyclesLeft(const Chemistry& chemistry, const std::vector<std::uint8_t>& cyclic)
        : part_(chemistry.present.size(), kNoPart) {
        std::vector<std::uint32_t> stack;
        for (std::uint32_t i = 0; i < part_.size(); ++i) {
            if (!chemistry.present[i] || part_[i] != kNoPart) continue;
            std::int64_t atoms = 0, ends = 0;
            stack.assign(1, i);
            part_[i] = static_cast<std::uint32_t>(left_.size());
            while (!stack.empty()) {
                const std::uint32_t atom = stack.back();
                stack.pop_back();
                ++atoms;
                for (const Neighbour& n : chemistry.of(atom)) {
                    if (!cyclic[n.bond]) continue;
                    ++ends;
                    if (part_[n.atom] != kNoPart) continue;
                    part_[n.atom] = part_[i];
                    stack.push_back(n.atom);
                }
            }
            left_.push_back(ends / 2 - atoms + 1);
        }
    }

    /// Independent cycles not found yet in an atom's part.
    std::int64_t& at(std::uint32_t atom) { return left_[part_[atom]]; }

private:
    static constexpr std::uint32_t kNoPart = 0xffffffffu;
    std::vector<std::uint32_t> part_;  ///< per atom
    std::vector<std::int64_t> left_;   ///< per part
};

/// Sparse Gaussian elimination over GF(2): basis cycles by their last bond. In lattices, whose cycles come in the order
/// of their bonds, sums stay shorter than by the first one.
class CycleBasis {
public:
    CycleBasis(const Chemistry& chemistry, const std::vector<std::uint8_t>& cyclic)
        : rows_(chemistry.order.size()), left_(chemistry, cyclic) {}

    enum class Kind {
        sum,          ///< of cycles added so far
        independent,  ///< of them
        unknown       ///< after many steps
    };

    /// @param cycle  if independent, has its rest after this, so that another call goes on from there
    Kind reduce(Cycle& cycle) {
        if (left_.at(cycle.atoms.front()) == 0 || visited_ > kMostVisited) return Kind::sum;
        sum_.assign(cycle.bonds.rbegin(), cycle.bonds.rend());
        for (int step = 0; !sum_.empty(); ++step) {
            if (step > kMostSteps || sum_.size() > kMostBonds) return Kind::unknown;
            const std::vector<std::uint32_t>& row = rows_[sum_.front()];
            if (row.empty()) {
                cycle.bonds.assign(sum_.rbegin(), sum_.rend());
                return Kind::independent;
            }
            addRow(row);
        }
        return Kind::sum;
    }

    void add(Cycle& cycle) {
        if (reduce(cycle) != Kind::independent) return;
        --left_.at(cycle.atoms.front());
        rows_[sum_.front()] = sum_;
    }

private:
    // In a cage of thousands of rings, sums grow long. After this many steps a ring is kept.
    static constexpr int kMostSteps = 500;
    static constexpr std::size_t kMostBonds = 200;
    static constexpr std::size_t kMostVisited = 500'000'000;  // in all sums; beyond, atoms count as outside of rings

    /// Does not branch on comparisons, which are unpredictable.
    void addRow(const std::vector<std::uint32_t>& row) {
        visited_ += sum_.size() + row.size();
        next_.resize(sum_.size() + row.size());
        const std::uint32_t *a = sum_.data(), *const endOfA = a + sum_.size(),
                            *b = row.data(), *const endOfB = b + row.size();
        std::uint32_t* to = next_.data();
        while (a != endOfA && b != endOfB) {
            const std::uint32_t left = *a, right = *b;
            *to = std::max(left, right);
            to += left != right;
            a += left >= right;
            b += right >= left;
        }
        to = std::copy(b, endOfB, std::copy(a, endOfA, to));
        next_.resize(static_cast<std::size_t>(to - next_.data()));
        sum_.swap(next_);
    }

    std::vector<std::vector<std::uint32_t>> rows_;  ///< by their last bond, which stands first
    CyclesLeft left_;
    std::vector<std::uint32_t> sum_, next_;  ///< descending
    std::size_t visited_ = 0;
};

/// Largest mean torsion (degrees) of a flat ring of five and of six, as Open Babel has them for planar rings.
constexpr double kFlatFive = 7.5, kFlatSix = 12;

double meanTorsion(const ChemistryWork& work, const std::vector<std::uint32_t>& ring) {
    double sum = 0;
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec3 p[4] = {work.position(ring[i]), work.position(ring[(i + 1) % n]),
                                 work.position(ring[(i + 2) % n]), work.position(ring[(i + 3) % n])};
        const glm::dvec3 u = glm::cross(p[1] - p[0], p[2] - p[1]), v = glm::cross(p[2] - p[1], p[3] - p[2]);
        const double length = glm::length(u) * glm::length(v);
        if (length < 1e-9) return 180;
        sum += std::acos(std::clamp(glm::dot(u, v) / length, -1.0, 1.0)) * 180 / 3.14159265358979;
    }
    return sum / static_cast<double>(n);
}

/// Shortest first, each once.
void sortCycles(std::vector<Cycle>& cycles) {
    std::sort(cycles.begin(), cycles.end(), [](const Cycle& l, const Cycle& r) {
        return l.bonds.size() != r.bonds.size() ? l.bonds.size() < r.bonds.size() : l.bonds < r.bonds;
    });
    cycles.erase(
        std::unique(cycles.begin(), cycles.end(), [](const Cycle& l, const Cycle& r) { return l.bonds == r.bonds; }),
        cycles.end());
}

constexpr std::size_t kMostCycles = 1'000'000;  // held at once; beyond, atoms count as outside of rings

void addRing(ChemistryWork& work, std::vector<std::uint32_t> atoms) {
    Ring ring{std::move(atoms)};
    const auto size = static_cast<std::uint8_t>(ring.atoms.size());
    const double torsion = meanTorsion(work, ring.atoms);
    work.ringTorsion.push_back(static_cast<float>(torsion));
    if (size == 5 || size == 6) ring.planar = torsion <= (size == 5 ? kFlatFive : kFlatSix);
    for (const std::uint32_t atom : ring.atoms) {
        std::uint8_t& smallest = work.ringAtom[atom];
        if (smallest == 0 || size < smallest) smallest = size;
        if (ring.planar && work.flatRing[atom] == 0) work.flatRing[atom] = size;
    }
    work.chemistry.rings.push_back(std::move(ring));
}

}  // namespace

std::vector<std::uint8_t> cyclicBonds(const Chemistry& chemistry) { return CycleBonds(chemistry).find(); }

void findRings(ChemistryWork& work) {
    Chemistry& chemistry = work.chemistry;
    work.ringAtom.assign(chemistry.present.size(), 0);
    work.flatRing.assign(chemistry.present.size(), 0);
    work.inRing = cyclicBonds(chemistry);
    std::vector<Cycle> cycles;
    ShortCycles shortest(chemistry, work.inRing);
    for (std::uint32_t i = 0; i < chemistry.present.size(); ++i) {
        if (!chemistry.present[i]) continue;
        const auto around = chemistry.of(i);
        if (std::any_of(around.begin(), around.end(), [&](const Neighbour& n) { return work.inRing[n.bond] != 0; }))
            shortest.through(i, cycles);
        if (cycles.size() < kMostCycles) continue;
        sortCycles(cycles);
        if (cycles.size() > kMostCycles / 2) break;
    }
    sortCycles(cycles);
    CycleBasis basis(chemistry, work.inRing);
    for (std::size_t begin = 0, end = 0; begin < cycles.size(); begin = end) {
        while (end < cycles.size() && cycles[end].bonds.size() == cycles[begin].bonds.size()) ++end;
        std::vector<CycleBasis::Kind> kinds;
        for (std::size_t i = begin; i < end; ++i) kinds.push_back(basis.reduce(cycles[i]));
        for (std::size_t i = begin; i < end; ++i)
            if (kinds[i - begin] == CycleBasis::Kind::independent) basis.add(cycles[i]);
        for (std::size_t i = begin; i < end; ++i)
            if (kinds[i - begin] != CycleBasis::Kind::sum) addRing(work, std::move(cycles[i].atoms));
    }
}

}  // namespace nacre
