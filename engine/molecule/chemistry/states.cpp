// Charges, hydrogens and hybridisation at neutral pH, and delocalised bonds.

#include <utility>

#include "engine/molecule/bonds/residue_templates.h"
#include "engine/molecule/chemistry/steps.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

class StateFinder {
public:
    explicit StateFinder(ChemistryWork& work) : work_(work), chemistry_(work.chemistry) {
        const std::size_t count = work.molecule.atoms.size();
        chemistry_.charge.assign(count, 0);
        chemistry_.hydrogens.assign(count, 0);
        chemistry_.hybrid.assign(count, 0);
        hasHydrogens_.assign(work.molecule.residues.size(), 0);
        for (std::uint32_t i = 0; i < count; ++i)
            if (chemistry_.present[i] && work.isHydrogenAt(i) && work.degree(i) > 0)
                hasHydrogens_[work.atom(i).residue] = 1;
        metals_.assign(count, 0);
        ownMetals_.assign(count, 0);
        for (const Bond& bond : work.molecule.bonds) {
            if (!chemistry_.present[bond.a] || !chemistry_.present[bond.b]) continue;
            for (const auto& [atom, other] : {std::pair(bond.a, bond.b), std::pair(bond.b, bond.a)}) {
                if (!isMetal(work.element(other))) continue;
                metals_[atom] = 1;
                if (work.atom(atom).residue == work.atom(other).residue) ownMetals_[atom] = 1;
            }
        }
    }

    void run() {
        const auto count = static_cast<std::uint32_t>(chemistry_.present.size());
        for (std::uint32_t i = 0; i < count; ++i)
            if (chemistry_.present[i] && !work_.isHydrogenAt(i)) chemistry_.hybrid[i] = findHybrid(i);
        for (std::uint32_t i = 0; i < count; ++i)
            if (chemistry_.present[i] && !work_.isHydrogenAt(i)) setState(i);
        for (std::uint32_t i = 0; i < count; ++i)
            if (chemistry_.present[i]) markDelocalised(i);
    }

private:
    int countPi(std::uint32_t atom) const {
        return chemistry_.orders(atom) - static_cast<int>(chemistry_.of(atom).size());
    }

    bool planarAtom(std::uint32_t atom) const { return chemistry_.aromaticAtom[atom] || countPi(atom) == 1; }

    std::uint8_t findHybrid(std::uint32_t atom) const {
        const Element e = work_.element(atom);
        const int pi = countPi(atom);
        if (isMetal(e) || e == 0) return 0;
        if (e == kSulphur || e == kPhosphorus || e == kArsenic || e == kSelenium || e == kChlorine)
            if (work_.degree(atom) >= 3) return 3;
        if (pi >= 2) return 1;
        if (pi == 1 || chemistry_.aromaticAtom[atom]) return 2;
        if (e == kBoron) return 2;
        if (e != kNitrogen && e != kOxygen) return 3;
        // A lone pair next to a pi bond of carbon or nitrogen conjugates with it.
        std::size_t conjugated = 0;
        for (const Neighbour& n : chemistry_.of(atom))
            conjugated +=
                (work_.element(n.atom) == kCarbon || work_.element(n.atom) == kNitrogen) && planarAtom(n.atom);
        if (e == kNitrogen) return conjugated > 0 && work_.degree(atom) <= 3 ? 2 : 3;
        return conjugated == work_.heavyDegree(atom) && conjugated > 0 ? 2 : 3;
    }

    std::uint8_t hydrogensThere(std::uint32_t atom) const {
        return static_cast<std::uint8_t>(work_.degree(atom) - work_.heavyDegree(atom));
    }

    /// Hydrogens that complete the smallest usual valence. A charge shifts the valence to that of a neighbouring group
    /// of the periodic table: N+ binds like carbon, S+ like phosphorus. Only the third period and below exceed the
    /// octet.
    static int lackingHydrogens(Element e, int charge, int orders) {
        const int group = periodicGroup(e);
        if (group == 0) return 0;
        const int like = group - charge;  // 14: carbon
        const bool octet = e <= kFluorine || like <= 14;
        const int least = like <= 14 ? like - 10 : 18 - like;
        for (int valence = least; valence <= (octet ? least : 8 - least); valence += 2)
            if (valence >= orders) return valence - orders;
        return 0;
    }

    static int periodicGroup(Element e) {
        switch (e) {
            case kBoron:
                return 13;
            case kCarbon:
            case kSilicon:
                return 14;
            case kNitrogen:
            case kPhosphorus:
            case kArsenic:
                return 15;
            case kOxygen:
            case kSulphur:
            case kSelenium:
                return 16;
            case kFluorine:
            case kChlorine:
            case kBromine:
            case kIodine:
                return 17;
            default:
                return 0;
        }
    }

    void setState(std::uint32_t atom) {
        const Element e = work_.element(atom);
        const int sum = chemistry_.orders(atom);
        const Atom& record = work_.atom(atom);
        std::int8_t charge = record.charge;
        if (charge == 0) charge = static_cast<std::int8_t>(computeCharge(atom, e, sum));
        chemistry_.charge[atom] = charge;
        const std::uint8_t there = hydrogensThere(atom);
        if (hasHydrogens_[record.residue] && (there > 0 || e == kCarbon || stateOfHydrogensKnown(atom))) {
            chemistry_.hydrogens[atom] = there;
            return;
        }
        if (work_.degree(atom) == 0 && !standsAlone(atom)) return;
        const int missing = backboneEnd(atom) || bindsMetal(atom, e) ? 0 : lackingHydrogens(e, charge, sum);
        chemistry_.hydrogens[atom] = static_cast<std::uint8_t>(there + missing);
    }

    /// Whether an atom is a water, an ammonium or an ammine, and not an oxide, an ion, or the only modelled atom of a
    /// residue.
    bool standsAlone(std::uint32_t atom) const {
        const Element e = work_.element(atom);
        if (e == kOxygen) return ownMetals_[atom] == 0;
        return e == kNitrogen && !residueTemplate(work_.molecule.residues[work_.atom(atom).residue].name);
    }

    /// A thiolate at a metal, or an alkoxide at a metal of its own residue.
    bool bindsMetal(std::uint32_t atom, Element e) const {
        if (work_.degree(atom) != 1 || chemistry_.orders(atom) != 1) return false;
        return e == kSulphur || e == kSelenium ? metals_[atom] > 0 : e == kOxygen && ownMetals_[atom] > 0;
    }

    /// In a residue with hydrogens, atoms without any lack them by intent, even an acid's oxygen.
    bool stateOfHydrogensKnown(std::uint32_t atom) const { return work_.degree(atom) > 0; }

    /// Whether an atom is C of an amino acid at a gap: its neighbour is missing from the file, and it is no aldehyde.
    bool backboneEnd(std::uint32_t atom) const {
        const Name& name = work_.atom(atom).name;
        const Name& residue = work_.molecule.residues[work_.atom(atom).residue].name;
        return residueTemplate(residue) && (name == Name("C") || name == Name("P"));
    }

    int computeCharge(std::uint32_t atom, Element e, int sum) const {
        const bool known = hasHydrogens_[work_.atom(atom).residue] != 0;
        const std::size_t degree = work_.degree(atom);
        switch (e) {
            case kNitrogen:
                if (sum >= 4) return 1;
                if (besideDiazo(atom, sum)) return -1;
                if (degree == 0) return standsAlone(atom) && metals_[atom] == 0 ? 1 : 0;
                if (known) return 0;
                return amine(atom) || amidinium(atom) ? 1 : 0;
            case kPhosphorus:
            case kArsenic:
                return sum == 4 && degree == 4 ? 1 : 0;
            case kBoron:
                return sum == 4 ? -1 : 0;
            case kCarbon:
                return sum == 3 && degree == 1 && endsOfMonoxide(atom) ? -1 : 0;
            case kOxygen:
            case kSulphur:
            case kSelenium:
                if (sum == 3) return 1;
                if (sum != 1 || degree != 1) return 0;
                return (e != kSelenium && acidEnd(atom, known)) || bindsMetal(atom, e) ? -1 : 0;
            case kChlorine:
            case kBromine:
            case kIodine:
                return sum == 2 && degree == 2 ? 1 : 0;
            default:
                return 0;
        }
    }

    /// Whether a carbon is that of carbon monoxide or an isocyanide.
    bool endsOfMonoxide(std::uint32_t carbon) const {
        const std::uint32_t other = chemistry_.of(carbon).front().atom;
        const Element e = work_.element(other);
        return chemistry_.orders(other) == (e == kNitrogen ? 4 : 3) && (e == kNitrogen || e == kOxygen);
    }

    /// Whether an atom is the end of an azide or diazo group, N=[N+]=[N-], or its nitrogen in N-[N+]#N.
    bool besideDiazo(std::uint32_t atom, int sum) const {
        if (sum != 2) return false;
        for (const Neighbour& n : chemistry_.of(atom)) {
            const bool middle = work_.element(n.atom) == kNitrogen && work_.degree(n.atom) == 2 && countPi(n.atom) == 2;
            if (middle && (work_.degree(atom) == 1 || chemistry_.order[n.bond] == 1)) return true;
        }
        return false;
    }

    /// Whether an atom is an amine without electron-withdrawing groups: all its neighbours are tetrahedral carbons.
    bool amine(std::uint32_t atom) const {
        if (chemistry_.hybrid[atom] != 3) return false;
        for (const Neighbour& n : chemistry_.of(atom)) {
            const bool carbon = work_.element(n.atom) == kCarbon && chemistry_.hybrid[n.atom] == 3;
            if (!carbon && !work_.isHydrogenAt(n.atom)) return false;
        }
        return true;
    }

    /// Whether an atom is the doubly bonded nitrogen of C(=N)N, outside aromatic rings.
    bool amidinium(std::uint32_t atom) const {
        if (chemistry_.aromaticAtom[atom] || work_.degree(atom) > 2) return false;
        for (const Neighbour& n : chemistry_.of(atom)) {
            if (chemistry_.order[n.bond] != 2 || work_.element(n.atom) != kCarbon) continue;
            if (chemistry_.aromaticAtom[n.atom]) return false;
            return amidineCarbon(n.atom);
        }
        return false;
    }

    bool amidineCarbon(std::uint32_t carbon) const {
        std::size_t nitrogens = 0;
        for (const Neighbour& n : chemistry_.of(carbon)) {
            if (work_.element(n.atom) != kNitrogen) continue;
            ++nitrogens;
            for (const Neighbour& m : chemistry_.of(n.atom))  // next to an acyl or nitro group: not a base
                if (m.atom != carbon && !work_.isHydrogenAt(m.atom) && countPi(m.atom) > 0) return false;
        }
        return nitrogens >= 2;
    }

    /// Whether an atom is the singly bonded end of an acid that is ionised at neutral pH.
    bool acidEnd(std::uint32_t atom, bool known) const {
        const Neighbour n = chemistry_.of(atom).front();
        const Element e = work_.element(n.atom);
        if (known) return work_.element(atom) == kOxygen || e == kPhosphorus;
        if (e == kPhosphorus || e == kArsenic) return true;
        if (e == kNitrogen) return chemistry_.orders(n.atom) >= 4;
        for (const Neighbour& m : chemistry_.of(n.atom)) {
            if (m.atom == atom || chemistry_.order[m.bond] != 2 || work_.degree(m.atom) != 1) continue;
            const bool acid = e == kCarbon || e == kSulphur || e == kSelenium || periodicGroup(e) == 17;
            if (acid) return work_.element(m.atom) == kOxygen;
        }
        return false;
    }

    /// Marks bonds from a centre to the ends that share a charge or a pi bond.
    void markDelocalised(std::uint32_t centre) {
        const Element e = work_.element(centre);
        const bool guanidine =
            e == kCarbon && !chemistry_.aromaticAtom[centre] && countPi(centre) == 1 && amidineCarbon(centre);
        std::size_t ends = 0, twofold = 0;
        const auto counts = [&](const Neighbour& n) {
            const Element other = work_.element(n.atom);
            if (guanidine) return other == kNitrogen;
            const bool acid = e == kCarbon || e == kNitrogen || e == kPhosphorus || e == kSulphur || e == kArsenic;
            return acid && work_.degree(n.atom) == 1 && (other == kOxygen || other == kSulphur) &&
                   (chemistry_.order[n.bond] == 2 || chemistry_.charge[n.atom] < 0);
        };
        for (const Neighbour& n : chemistry_.of(centre)) {
            if (!counts(n)) continue;
            ++ends;
            twofold += chemistry_.order[n.bond] == 2;
        }
        if (ends < 2 || twofold == 0 || twofold == ends) return;
        for (const Neighbour& n : chemistry_.of(centre))
            if (counts(n)) chemistry_.delocalised[n.bond] = 1;
    }

    ChemistryWork& work_;
    Chemistry& chemistry_;
    std::vector<std::uint8_t> hasHydrogens_;        // by residue
    std::vector<std::uint8_t> metals_, ownMetals_;  // by atom: bonded to a metal; to one of its residue
};

}  // namespace

void findStates(ChemistryWork& work) { StateFinder(work).run(); }

}  // namespace nacre
