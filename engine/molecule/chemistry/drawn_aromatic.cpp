// Which aromatic rings are drawn with an inner line or circle, and which as a Kekulé structure, as textbooks draw them.

#include <algorithm>

#include "engine/molecule/chemistry/steps.h"
#include "engine/molecule/disjoint_sets.h"

namespace nacre {
namespace {

/// Rings of conjugated atoms that share bonds, directly or through further rings. Rings too large for
/// Chemistry::rings take part by their bonds.
class ConjugatedSystems {
public:
    explicit ConjugatedSystems(const ChemistryWork& work)
        : work_(work), chemistry_(work.chemistry), systems_(work.molecule.atoms.size()) {
        cyclic_ = conjugatedCycles();
        for (std::uint32_t b = 0; b < cyclic_.size(); ++b)
            if (cyclic_[b]) systems_.join(work.molecule.bonds[b].a, work.molecule.bonds[b].b);
    }

    /// The number of an atom's system.
    std::uint32_t of(std::uint32_t atom) { return systems_.findRoot(atom); }
    bool cyclic(std::uint32_t bond) const { return cyclic_[bond] != 0; }

private:
    bool conjugated(std::uint32_t atom) const { return chemistry_.aromaticAtom[atom] || chemistry_.hybrid[atom] == 2; }

    /// Bonds on cycles of conjugated atoms only.
    std::vector<std::uint8_t> conjugatedCycles() const {
        Chemistry part;
        part.present = chemistry_.present;
        part.order = chemistry_.order;
        part.first.assign(1, 0);
        for (std::uint32_t i = 0; i < part.present.size(); ++i) {
            part.present[i] = part.present[i] && conjugated(i);
            if (part.present[i])
                for (const Neighbour& n : chemistry_.of(i))
                    if (work_.inRing[n.bond] && conjugated(n.atom)) part.neighbours.push_back(n);
            part.first.push_back(static_cast<std::uint32_t>(part.neighbours.size()));
        }
        return cyclicBonds(part);
    }

    const ChemistryWork& work_;
    const Chemistry& chemistry_;
    DisjointSets systems_;
    std::vector<std::uint8_t> cyclic_;  // by bond
};

/// Whether a ring is a pyrrole of a porphyrin: its nitrogen binds a metal, and bonds of a larger ring lead out of it.
/// The bonds between the pyrroles may look saturated in a poor model.
bool inPorphyrin(const ChemistryWork& work, const std::vector<std::uint8_t>& atMetal, const Ring& ring) {
    if (ring.atoms.size() != 5) return false;
    bool holds = false;
    std::size_t outward = 0;
    for (const std::uint32_t atom : ring.atoms) {
        holds = holds || (atMetal[atom] && work.element(atom) == kNitrogen);
        for (const Neighbour& n : work.chemistry.of(atom))
            outward += work.inRing[n.bond] && std::ranges::find(ring.atoms, n.atom) == ring.atoms.end();
    }
    return holds && outward >= 2;
}

}  // namespace

void chooseDrawnRings(ChemistryWork& work) {
    Chemistry& chemistry = work.chemistry;
    ConjugatedSystems systems(work);
    std::vector<std::uint8_t> kekule(work.molecule.atoms.size());  // by system
    for (std::uint32_t b = 0; b < work.molecule.bonds.size(); ++b) {
        const Bond& bond = work.molecule.bonds[b];
        if (systems.cyclic(b) && !chemistry.aromatic[b]) kekule[systems.of(bond.a)] = 1;
        // A carbonyl group or similar on an aromatic ring.
        if (work.inRing[b] || chemistry.order[b] != 2) continue;
        if (chemistry.aromaticAtom[bond.a]) kekule[systems.of(bond.a)] = 1;
        if (chemistry.aromaticAtom[bond.b]) kekule[systems.of(bond.b)] = 1;
    }
    const std::vector<std::uint8_t> atMetal = boundToMetals(work);
    for (const Ring& ring : chemistry.rings) {
        const bool whole = std::ranges::all_of(
            ring.atoms, [&](std::uint32_t atom) { return systems.of(atom) == systems.of(ring.atoms.front()); });
        // Neighbouring rings may make all bonds of a non-aromatic ring aromatic, such as a pentagon of a fullerene.
        if ((whole && !ring.aromatic) || inPorphyrin(work, atMetal, ring)) kekule[systems.of(ring.atoms.front())] = 1;
    }
    for (Ring& ring : chemistry.rings) ring.drawnAromatic = ring.aromatic && !kekule[systems.of(ring.atoms.front())];
}

}  // namespace nacre
