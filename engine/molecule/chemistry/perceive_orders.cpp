// Bond orders from geometry. Where carbons have hydrogens, these show which atoms have pi bonds; elsewhere lengths,
// angles and rings do (order_features.h). The best distribution of pi bonds over each system decides (pi_bonds.cpp).

#include <algorithm>
#include <array>

#include "engine/molecule/chemistry/order_features.h"
#include "engine/molecule/chemistry/steps.h"

namespace nacre {
namespace {

/// Weights of the distribution. A pi bond gains from +1 at the length of a double bond to -1 at that of a single one,
/// bounded a little beyond. Leaving a certainly planar atom without a pi bond costs more than any length can gain.
constexpr float kLongestGain = 1.4f;
constexpr float kLengthError = 0.06f;      // Å, of bonds to the ends of a group, at the resolution of protein crystals
constexpr double kLeastPlanarAngle = 114;  // degrees, mean of three
constexpr float kCertain = 4, kLikely = 2, kMaybe = 1;

float computeGain(float length, float lower, float upper) {
    return std::clamp((0.5f * (lower + upper) - length) / (0.5f * (upper - lower)), -2 * kLongestGain, kLongestGain);
}

class OrderPerception {
public:
    explicit OrderPerception(ChemistryWork& work) : work_(work), features_(work), open_(work.molecule.atoms.size()) {}

    void run() {
        for (std::uint32_t b = 0; b < work_.source.size(); ++b) {
            if (work_.source[b] != OrderSource::unknown) continue;
            work_.chemistry.order[b] = 1;
            const Bond& bond = work_.molecule.bonds[b];
            if (!work_.chemistry.present[bond.a] || !work_.chemistry.present[bond.b]) continue;
            open_[bond.a] = open_[bond.b] = 1;
        }
        findHydrogenated();
        for (std::uint32_t i = 0; i < open_.size(); ++i)
            if (open_[i]) setGroup(i);
        placePiBonds();
    }

private:
    bool unknown(std::uint32_t bond) const { return work_.source[bond] == OrderSource::unknown; }

    void settle(std::uint32_t bond, std::uint8_t order) {
        work_.chemistry.order[bond] = order;
        work_.source[bond] = OrderSource::stated;
    }

    /// Finds residues whose carbons have hydrogens: in these, missing neighbours of a carbon (of four) are pi bonds.
    void findHydrogenated() {
        hydrogenated_.assign(work_.molecule.residues.size(), 0);
        for (std::uint32_t i = 0; i < open_.size(); ++i) {
            if (!open_[i] || work_.element(i) != kCarbon) continue;
            for (const Neighbour& n : work_.chemistry.of(i))
                if (work_.isHydrogenAt(n.atom)) hydrogenated_[work_.atom(i).residue] = 1;
        }
    }

    /// Terminal neighbours that may have a double bond, the likeliest first.
    std::vector<Neighbour> findEnds(std::uint32_t atom) const {
        std::vector<Neighbour> left, ends;
        for (const Neighbour& n : work_.chemistry.of(atom)) {
            const Element e = work_.element(n.atom);
            if (work_.degree(n.atom) == 1 && (e == kOxygen || e == kSulphur) && unknown(n.bond)) left.push_back(n);
        }
        // Oxygen before sulphur, then by length; lengths that differ by less than their error keep the file's order.
        const auto measure = [&](const Neighbour& n) {
            return work_.length(atom, n.atom) + (work_.element(n.atom) == kSulphur ? 1 : 0);
        };
        while (!left.empty()) {
            const auto shortest =
                std::min_element(left.begin(), left.end(),
                                 [&](const Neighbour& l, const Neighbour& r) { return measure(l) < measure(r); });
            const float most = measure(*shortest) + kLengthError;
            const auto next = std::ranges::find_if(left, [&](const Neighbour& n) { return measure(n) <= most; });
            ends.push_back(*next);
            left.erase(next);
        }
        return ends;
    }

    /// Sets orders of hypervalent groups, nitro groups and carboxylates as chemists draw them.
    void setGroup(std::uint32_t atom) {
        const Element e = work_.element(atom);
        const std::size_t degree = work_.degree(atom);
        std::size_t doubles = 0;
        if (e == kSulphur || e == kSelenium) doubles = degree == 4 ? 2 : degree == 3 ? 1 : 0;
        if (e == kPhosphorus || e == kArsenic) doubles = degree == 4 || degree == 3 ? 1 : 0;
        if (e == kChlorine || e == kBromine || e == kIodine) doubles = degree == 4 ? 3 : degree == 3 ? 2 : 0;
        if (e == kNitrogen && degree == 2) return settleDiazo(atom);
        const std::vector<Neighbour> ends = findEnds(atom);
        if (e == kNitrogen && degree == 3 && ends.size() >= 2) doubles = 1;
        if (e == kCarbon && degree == 3 && ends.size() == 2 && features_.angle(atom) > kLeastPlanarAngle) doubles = 1;
        if (doubles == 0) return;
        for (std::size_t i = 0; i < ends.size() && i < doubles; ++i) settle(ends[i].bond, 2);
        for (const Neighbour& n : work_.chemistry.of(atom))
            if (unknown(n.bond)) settle(n.bond, 1);
    }

    /// Azides and diazo groups: X=[N+]=[N-], recognised by a straight middle. A diazonium group keeps its triple bond.
    void settleDiazo(std::uint32_t middle) {
        constexpr float kLeastStraight = 150;  // degrees
        const auto around = work_.chemistry.of(middle);
        const auto isEnd = [&](const Neighbour& n) {
            return work_.element(n.atom) == kNitrogen && work_.degree(n.atom) == 1;
        };
        if (features_.angle(middle) < kLeastStraight || isEnd(around[0]) == isEnd(around[1])) return;
        const Neighbour& other = isEnd(around[0]) ? around[1] : around[0];
        const Element e = work_.element(other.atom);
        if ((e != kNitrogen && e != kCarbon) || (e == kCarbon && work_.flatRing[other.atom] > 0)) return;
        if (!unknown(around[0].bond) || !unknown(around[1].bond) || settledPi(other.atom) > 0) return;
        settle(around[0].bond, 2);
        settle(around[1].bond, 2);
    }

    /// Pi bonds that the file, a template or a group already settles.
    std::uint8_t settledPi(std::uint32_t atom) const {
        int pi = 0;
        for (const Neighbour& n : work_.chemistry.of(atom))
            if (!unknown(n.bond)) pi += std::min<int>(work_.chemistry.order[n.bond], 3) - 1;
        return static_cast<std::uint8_t>(pi);
    }

    PiSystem::Atom impossible() const { return {{0, 0, 0}, 0}; }

    PiSystem::Atom piAtom(std::uint32_t atom) const {
        const std::uint8_t most = open_[atom] && settledPi(atom) == 0 ? mostPi(atom) : std::uint8_t{0};
        if (most == 0) return impossible();
        if (hydrogenated(atom)) return withHydrogens(atom);
        PiSystem::Atom costs{{0, 0, 0}, most};
        for (int count = 0; count <= most; ++count)
            features_.atom(atom, count, [&](std::size_t feature, float value) {
                costs.cost[count] += value * kOrderWeight[feature];
            });
        return costs;
    }

    std::uint8_t mostPi(std::uint32_t atom) const {
        constexpr float kLeastLinear = 140;  // degrees
        const std::size_t degree = work_.degree(atom);
        switch (work_.element(atom)) {
            case kCarbon:
            case kNitrogen:
                if (degree == 2) return features_.angle(atom) > kLeastLinear ? 2 : 1;
                return degree == 1 ? 2 : degree == 3 ? 1 : 0;
            case kOxygen:
            case kSulphur:
            case kSelenium:
                return degree == 1 ? 1 : 0;
            default:
                return 0;
        }
    }

    bool hydrogenated(std::uint32_t atom) const { return hydrogenated_[work_.atom(atom).residue] != 0; }

    /// An atom of a residue with hydrogens: missing ones are pi bonds.
    PiSystem::Atom withHydrogens(std::uint32_t atom) const {
        const std::size_t degree = work_.degree(atom);
        if (work_.element(atom) == kCarbon)
            return degree == 3 ? PiSystem::Atom{{kCertain, 0, 0}, 1} : PiSystem::Atom{{2 * kCertain, kLikely, 0}, 2};
        if (work_.element(atom) != kNitrogen) return {{kLikely, 0, 0}, 1};
        if (degree == 3) return {{0, features_.angle(atom) > 116 ? 1.5f : kCertain, 0}, 1};
        if (degree == 1) return {{kCertain, kLikely, 0}, 2};
        return features_.angle(atom) > 155 ? PiSystem::Atom{{kLikely, kMaybe, 0}, 2}
                                           : PiSystem::Atom{{kCertain, 0, 0}, 1};
    }

    /// Whether an oxygen's carbon also has a nitrogen or another oxygen: then it is a carbonyl of an amide, lactam,
    /// urea, acid or ester, whatever its length in a poor model.
    bool amideOxygen(std::uint32_t oxygen, std::uint32_t carbon) const {
        if (work_.element(oxygen) != kOxygen || work_.degree(oxygen) != 1 || work_.element(carbon) != kCarbon)
            return false;
        for (const Neighbour& n : work_.chemistry.of(carbon))
            if (n.atom != oxygen && (work_.element(n.atom) == kNitrogen || work_.element(n.atom) == kOxygen))
                return true;
        return false;
    }

    /// Prefers pi bonds inside flat rings to those that lead out of them, except carbonyl groups.
    float ringBonus(std::uint32_t bond, std::uint32_t a, std::uint32_t b) const {
        if (amideOxygen(a, b) || amideOxygen(b, a)) return kMaybe;
        if (work_.inRing[bond]) return work_.flatRing[a] && work_.flatRing[b] ? 0.3f : 0;
        const bool leadsOut = work_.flatRing[a] || work_.flatRing[b];
        const bool carbonyl = work_.element(a) == kOxygen || work_.element(b) == kOxygen;
        return leadsOut && !carbonyl ? -0.6f : 0;
    }

    /// Gains of 0, 1 and 2 pi bonds for a bond.
    std::array<float, 3> gains(std::uint32_t index, const BondLengths& lengths) const {
        const Bond& bond = work_.molecule.bonds[index];
        if (hydrogenated(bond.a) || hydrogenated(bond.b)) {
            const float length = work_.length(bond.a, bond.b);
            const float one = computeGain(length, lengths.twofold, lengths.single) + ringBonus(index, bond.a, bond.b);
            return {0, one, one + computeGain(length, lengths.threefold, lengths.twofold)};
        }
        float one = 0, second = 0;
        features_.pi(index, lengths, [&](std::size_t feature, float value) { one += value * kOrderWeight[feature]; });
        features_.secondPi(index, lengths,
                           [&](std::size_t feature, float value) { second += value * kOrderWeight[feature]; });
        return {0, one, one + second};
    }

    void placePiBonds() {
        PiSystem system;
        std::vector<std::uint32_t> bonds, index(open_.size(), kNone);
        const auto place = [&](std::uint32_t atom) {
            if (index[atom] != kNone) return index[atom];
            system.atoms.push_back(piAtom(atom));
            return index[atom] = static_cast<std::uint32_t>(system.atoms.size() - 1);
        };
        for (std::uint32_t b = 0; b < work_.source.size(); ++b) {
            const Bond& bond = work_.molecule.bonds[b];
            if (!unknown(b) || !work_.chemistry.present[bond.a] || !work_.chemistry.present[bond.b]) continue;
            const BondLengths* lengths = bondLengths(work_.element(bond.a), work_.element(bond.b));
            if (!lengths) continue;
            const std::uint32_t i = place(bond.a), j = place(bond.b);
            if (std::min(system.atoms[i].most, system.atoms[j].most) == 0) continue;
            const std::array<float, 3> gain = gains(b, *lengths);
            system.bonds.push_back({i, j, {gain[0], gain[1], gain[2]}});
            bonds.push_back(b);
        }
        const std::vector<std::uint8_t> pi = bestPiBonds(system);
        for (std::size_t i = 0; i < bonds.size(); ++i)
            work_.chemistry.order[bonds[i]] = static_cast<std::uint8_t>(1 + pi[i]);
    }

    static constexpr std::uint32_t kNone = 0xffffffffu;
    ChemistryWork& work_;
    OrderFeatures features_;
    std::vector<std::uint8_t> open_;          // by atom: it has bonds of unknown order
    std::vector<std::uint8_t> hydrogenated_;  // by residue
};

}  // namespace

void perceiveOrders(ChemistryWork& work) { OrderPerception(work).run(); }

void kekulise(ChemistryWork& work) {
    PiSystem system;
    std::vector<std::uint32_t> bonds, index(work.molecule.atoms.size(), 0xffffffffu);
    const auto place = [&](std::uint32_t atom) {
        if (index[atom] != 0xffffffffu) return index[atom];
        index[atom] = static_cast<std::uint32_t>(system.atoms.size());
        const Element e = work.element(atom);
        const std::size_t degree = work.degree(atom);
        PiSystem::Atom pi{{e == kCarbon ? 4.0f : 1.0f, 0, 0}, 1};
        if (e == kNitrogen && degree == 3) pi = {{0, 1.5f, 0}, 1};
        if (e != kCarbon && e != kNitrogen && degree != 1) pi.most = 0;
        for (const Neighbour& n : work.chemistry.of(atom))
            if (work.molecule.bonds[n.bond].order == 2 || work.molecule.bonds[n.bond].order == 3) pi.most = 0;
        system.atoms.push_back(pi);
        return index[atom];
    };
    for (std::uint32_t b = 0; b < work.molecule.bonds.size(); ++b) {
        const Bond& bond = work.molecule.bonds[b];
        if (bond.order != 4) continue;
        work.chemistry.order[b] = 1;
        if (!work.chemistry.present[bond.a] || !work.chemistry.present[bond.b]) continue;
        const std::uint32_t i = place(bond.a), j = place(bond.b);
        system.bonds.push_back({i, j, {0, 0.5f, -100}});
        bonds.push_back(b);
    }
    const std::vector<std::uint8_t> pi = bestPiBonds(system);
    for (std::size_t i = 0; i < bonds.size(); ++i)
        work.chemistry.order[bonds[i]] = static_cast<std::uint8_t>(1 + pi[i]);
}

}  // namespace nacre
