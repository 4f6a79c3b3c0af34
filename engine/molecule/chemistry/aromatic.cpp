// Hückel's rule over the smallest rings and over rings fused to each other.

#include <algorithm>
#include <set>

#include "engine/molecule/chemistry/steps.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

constexpr int kNoElectrons = -1;
constexpr std::size_t kLargestAromatic = 7;

/// Pi electrons that an atom contributes to a set of rings; kNoElectrons if it interrupts them.
/// @param inside  by atom of the molecule: it belongs to the rings
class PiElectrons {
public:
    explicit PiElectrons(const ChemistryWork& work) : work_(work), atMetal_(boundToMetals(work)) {}

    int of(std::uint32_t atom, const std::set<std::uint32_t>& inside) const {
        const Chemistry& chemistry = work_.chemistry;
        std::size_t bonds = 0;
        int pi = 0;
        bool within = false, toHetero = false;
        for (const Neighbour& n : chemistry.of(atom)) {
            ++bonds;
            if (chemistry.order[n.bond] == 1) continue;
            pi += chemistry.order[n.bond] - 1;
            if (work_.inRing[n.bond]) within = true;
            if (!inside.contains(n.atom) && work_.element(n.atom) != kCarbon) toHetero = true;
        }
        if (pi > 1) return kNoElectrons;
        if (pi == 1) return within ? 1 : toHetero ? 0 : kNoElectrons;
        return lonePair(atom, bonds);
    }

private:
    int lonePair(std::uint32_t atom, std::size_t bonds) const {
        switch (work_.element(atom)) {
            case kNitrogen:
            case kPhosphorus:
                return bonds <= 3 ? 2 : kNoElectrons;
            case kOxygen:
            case kSulphur:
            case kSelenium:
                return bonds == 2 ? 2 : kNoElectrons;
            case kBoron:
                return bonds <= 3 ? 0 : kNoElectrons;
            case kCarbon:  // a cyclopentadienide at a metal has a lone pair
                if (work_.atom(atom).charge == -1 || (atMetal_[atom] && bonds <= 3)) return 2;
                return work_.atom(atom).charge == 1 ? 0 : kNoElectrons;
            default:
                return kNoElectrons;
        }
    }

    const ChemistryWork& work_;
    std::vector<std::uint8_t> atMetal_;  // by atom
};

/// Whether the file states that all bonds of a ring are aromatic.
bool statedAromatic(const ChemistryWork& work, const Ring& ring) {
    for (std::size_t i = 0; i < ring.atoms.size(); ++i) {
        const std::uint32_t next = ring.atoms[(i + 1) % ring.atoms.size()];
        for (const Neighbour& n : work.chemistry.of(ring.atoms[i]))
            if (n.atom == next &&
                (work.molecule.bonds[n.bond].order != 4 || work.source[n.bond] == OrderSource::unknown))
                return false;
    }
    return true;
}

bool obeysHueckel(const PiElectrons& electrons, const std::set<std::uint32_t>& atoms) {
    int sum = 0;
    for (const std::uint32_t atom : atoms) {
        const int count = electrons.of(atom, atoms);
        if (count == kNoElectrons) return false;
        sum += count;
    }
    return sum % 4 == 2;
}

/// Rings that could be aromatic by their atoms alone.
std::vector<std::uint32_t> candidates(const ChemistryWork& work, const PiElectrons& electrons) {
    std::vector<std::uint32_t> list;
    for (std::uint32_t r = 0; r < work.chemistry.rings.size(); ++r) {
        const std::vector<std::uint32_t>& ring = work.chemistry.rings[r].atoms;
        if (ring.size() < 5 || ring.size() > kLargestAromatic) continue;
        const std::set<std::uint32_t> atoms(ring.begin(), ring.end());
        const bool able = std::all_of(ring.begin(), ring.end(),
                                      [&](std::uint32_t atom) { return electrons.of(atom, atoms) != kNoElectrons; });
        if (able) list.push_back(r);
    }
    return list;
}

void markRing(ChemistryWork& work, Ring& ring) {
    ring.aromatic = true;
    Chemistry& chemistry = work.chemistry;
    for (std::size_t i = 0; i < ring.atoms.size(); ++i) {
        chemistry.aromaticAtom[ring.atoms[i]] = 1;
        const std::uint32_t next = ring.atoms[(i + 1) % ring.atoms.size()];
        for (const Neighbour& n : chemistry.of(ring.atoms[i]))
            if (n.atom == next) chemistry.aromatic[n.bond] = 1;
    }
}

}  // namespace

std::vector<std::uint8_t> boundToMetals(const ChemistryWork& work) {
    std::vector<std::uint8_t> bound(work.molecule.atoms.size());
    for (const Bond& bond : work.molecule.bonds) {
        bound[bond.a] |= isMetal(work.element(bond.b));
        bound[bond.b] |= isMetal(work.element(bond.a));
    }
    return bound;
}

void findAromatic(ChemistryWork& work) {
    std::vector<Ring>& rings = work.chemistry.rings;
    const PiElectrons electrons(work);
    const std::vector<std::uint32_t> able = candidates(work, electrons);
    std::vector<std::vector<std::uint32_t>> atomRings(work.molecule.atoms.size());
    for (Ring& ring : rings)
        if (ring.atoms.size() >= 5 && ring.atoms.size() <= kLargestAromatic && statedAromatic(work, ring))
            markRing(work, ring);
    for (const std::uint32_t r : able) {
        for (const std::uint32_t atom : rings[r].atoms) atomRings[atom].push_back(r);
        if (obeysHueckel(electrons, {rings[r].atoms.begin(), rings[r].atoms.end()})) markRing(work, rings[r]);
    }
    // Azulene and the like: two rings that share a bond.
    for (const std::uint32_t r : able) {
        if (rings[r].aromatic) continue;
        std::set<std::uint32_t> others;
        for (const std::uint32_t atom : rings[r].atoms) others.insert(atomRings[atom].begin(), atomRings[atom].end());
        for (const std::uint32_t other : others) {
            if (other == r) continue;
            std::set<std::uint32_t> both(rings[r].atoms.begin(), rings[r].atoms.end());
            both.insert(rings[other].atoms.begin(), rings[other].atoms.end());
            const std::size_t shared = rings[r].atoms.size() + rings[other].atoms.size() - both.size();
            if (shared != 2 || !obeysHueckel(electrons, both)) continue;
            markRing(work, rings[r]);
            markRing(work, rings[other]);
        }
    }
}

}  // namespace nacre
