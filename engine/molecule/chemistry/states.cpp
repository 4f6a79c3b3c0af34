// Charges, hydrogens and hybridisation at neutral pH, and bonds that are delocalised.

#include <algorithm>

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
    }

    void run() {
        const auto count = static_cast<std::uint32_t>(chemistry_.present.size());
        for (std::uint32_t i = 0; i < count; ++i)
            if (chemistry_.present[i] && !work_.isHydrogenAt(i)) chemistry_.hybrid[i] = hybridOf(i);
        for (std::uint32_t i = 0; i < count; ++i)
            if (chemistry_.present[i] && !work_.isHydrogenAt(i)) setState(i);
        for (std::uint32_t i = 0; i < count; ++i)
            if (chemistry_.present[i]) markDelocalised(i);
    }

private:
    int piOf(std::uint32_t atom) const {
        return chemistry_.orders(atom) - static_cast<int>(chemistry_.of(atom).size());
    }

    bool planarAtom(std::uint32_t atom) const { return chemistry_.aromaticAtom[atom] || piOf(atom) == 1; }

    std::uint8_t hybridOf(std::uint32_t atom) const {
        const Element e = work_.element(atom);
        const int pi = piOf(atom);
        if (isMetal(e) || e == 0) return 0;
        if (e == kSulphur || e == kPhosphorus || e == kArsenic || e == kSelenium || e == kChlorine)
            if (work_.degree(atom) >= 3) return 3;
        if (pi >= 2) return 1;
        if (pi == 1 || chemistry_.aromaticAtom[atom]) return 2;
        if (e == kBoron) return 2;
        if (e != kNitrogen && e != kOxygen) return 3;
        // A lone pair beside a pi bond of carbon or nitrogen is part of it.
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

    static int valenceOf(Element e, int orders) {
        switch (e) {
            case kCarbon:
            case kSilicon:
                return 4;
            case kNitrogen:
            case kBoron:
                return 3;
            case kPhosphorus:
            case kArsenic:
                return orders <= 3 ? 3 : 5;
            case kOxygen:
                return 2;
            case kSulphur:
            case kSelenium:
                return orders <= 2 ? 2 : orders <= 4 ? 4 : 6;
            case kFluorine:
            case kChlorine:
            case kBromine:
            case kIodine:
                return orders <= 1 ? 1 : 7;
            default:
                return 0;
        }
    }

    void setState(std::uint32_t atom) {
        const Element e = work_.element(atom);
        const int sum = chemistry_.orders(atom);
        const Atom& record = work_.atom(atom);
        std::int8_t charge = record.charge;
        if (charge == 0) charge = static_cast<std::int8_t>(chargeOf(atom, e, sum));
        chemistry_.charge[atom] = charge;
        const std::uint8_t there = hydrogensThere(atom);
        if (hasHydrogens_[record.residue] && (there > 0 || e == kCarbon || stateOfHydrogensKnown(atom))) {
            chemistry_.hydrogens[atom] = there;
            return;
        }
        if (work_.degree(atom) == 0 && !isWaterLike(atom)) return;
        int missing = valenceOf(e, sum) - sum;
        if (e == kNitrogen || e == kOxygen || e == kPhosphorus || e == kSulphur) missing += charge;
        if (e == kCarbon || e == kBoron) missing -= std::abs(charge);
        if (backboneEnd(atom)) missing = 0;
        chemistry_.hydrogens[atom] = static_cast<std::uint8_t>(there + std::clamp(missing, 0, 4));
    }

    bool isWaterLike(std::uint32_t atom) const { return work_.element(atom) == kOxygen; }

    /// Where a residue has hydrogens, what has none is without them by intent, be it an acid's oxygen.
    bool stateOfHydrogensKnown(std::uint32_t atom) const { return work_.degree(atom) > 0; }

    /// C of an amino acid at a gap: its neighbour is missing from the file, it is no aldehyde.
    bool backboneEnd(std::uint32_t atom) const {
        const Name& name = work_.atom(atom).name;
        const Name& residue = work_.molecule.residues[work_.atom(atom).residue].name;
        return residueTemplate(residue) && (name == Name("C") || name == Name("P"));
    }

    int chargeOf(std::uint32_t atom, Element e, int sum) const {
        const bool known = hasHydrogens_[work_.atom(atom).residue] != 0;
        if (e == kNitrogen) {
            if (sum >= 4) return 1;
            if (known) return 0;
            return amine(atom) || amidinium(atom) ? 1 : 0;
        }
        if ((e == kOxygen || e == kSulphur) && sum == 1 && work_.degree(atom) == 1)
            return acidEnd(atom, known) ? -1 : 0;
        if (e == kSulphur && sum == 3 && work_.degree(atom) == 3) return 1;
        if (e == kPhosphorus && sum == 4 && work_.degree(atom) == 4) return 1;
        return 0;
    }

    /// An amine that nothing withdraws electrons from: all its neighbours are tetrahedral carbons.
    bool amine(std::uint32_t atom) const {
        if (chemistry_.hybrid[atom] != 3 || work_.degree(atom) == 0) return false;
        for (const Neighbour& n : chemistry_.of(atom)) {
            const bool carbon = work_.element(n.atom) == kCarbon && chemistry_.hybrid[n.atom] == 3;
            if (!carbon && !work_.isHydrogenAt(n.atom)) return false;
        }
        return true;
    }

    /// The doubly bonded nitrogen of C(=N)N, neither in an aromatic ring.
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
            for (const Neighbour& m : chemistry_.of(n.atom))  // of an acyl group or a nitro group: no base
                if (m.atom != carbon && !work_.isHydrogenAt(m.atom) && piOf(m.atom) > 0) return false;
        }
        return nitrogens >= 2;
    }

    /// The singly bonded end of an acid that is ionised at neutral pH.
    bool acidEnd(std::uint32_t atom, bool known) const {
        const Neighbour n = chemistry_.of(atom).front();
        const Element e = work_.element(n.atom);
        if (known) return work_.element(atom) == kOxygen || e == kPhosphorus;
        if (e == kPhosphorus || e == kArsenic) return true;
        if (e == kNitrogen) return chemistry_.orders(n.atom) >= 4;
        for (const Neighbour& m : chemistry_.of(n.atom)) {
            if (m.atom == atom || chemistry_.order[m.bond] != 2 || work_.degree(m.atom) != 1) continue;
            if (e == kCarbon || e == kSulphur || e == kChlorine) return work_.element(m.atom) == kOxygen;
        }
        return false;
    }

    /// Bonds from a centre to the ends that share a charge or a pi bond.
    void markDelocalised(std::uint32_t centre) {
        const Element e = work_.element(centre);
        const bool guanidine =
            e == kCarbon && !chemistry_.aromaticAtom[centre] && piOf(centre) == 1 && amidineCarbon(centre);
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
    std::vector<std::uint8_t> hasHydrogens_;  // by residue
};

}  // namespace

void findStates(ChemistryWork& work) { StateFinder(work).run(); }

}  // namespace nacre
