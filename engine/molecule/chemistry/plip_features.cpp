// Donors, acceptors, charges and rings by the definitions of PLIP 2.4: for the receptor by names of amino acids, for
// ligands by functional groups of heavy atoms; polar hydrogens by neutral valence.

#include <algorithm>
#include <numeric>
#include <optional>

#include "engine/molecule/chemistry/features.h"
#include "engine/molecule/chemistry/hydrogens.h"
#include "engine/molecule/chemistry/interaction_search.h"
#include "engine/molecule/chemistry/place_grid.h"
#include "engine/molecule/chemistry/steps.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

class PlipFeatures {
public:
    PlipFeatures(const Molecule& molecule, const Chemistry& chemistry)
        : molecule_(molecule), chemistry_(chemistry), features_(sharedFeatures(molecule, chemistry)) {}

    Features run() {
        // The program mistakes sodium's symbol for the PDBQT type of a nitrogen: it reports no sodium.
        std::erase_if(features_.metals, [&](std::uint32_t metal) { return element(metal) == kSodium; });
        countMetalBonds();
        matchFiveRings();
        addUnits();
        for (std::uint32_t i = 0; i < chemistry_.present.size(); ++i) {
            if (!chemistry_.present[i] || features_.waterOxygen[i]) continue;
            addPolar(i);
            if (receptor(i) ? receptorBindsMetal(i) : ligandBindsMetal(i)) features_.metalBinders.push_back(i);
            if (receptor(i)) continue;
            addLigandGroup(i);
            addLinkedCarbon(i);
        }
        features_.metalBinders.insert(features_.metalBinders.end(), features_.waters.begin(), features_.waters.end());
        addSideChains();
        for (std::uint32_t r = 0; r < chemistry_.rings.size(); ++r)
            if (isFlatRing(chemistry_.rings[r])) features_.rings.push_back(r);
        return std::move(features_);
    }

private:
    /// A ring of five or six atoms that is aromatic, or whose normals at all atoms are within 5 degrees of each other.
    /// Aromaticity of rings that bind a metal depends on how their bonds are drawn: there only the normals decide.
    bool isFlatRing(const Ring& ring) const {
        constexpr double kMostBend = 5;
        if (ring.atoms.size() != 5 && ring.atoms.size() != 6) return false;
        const bool holdsMetal = std::any_of(ring.atoms.begin(), ring.atoms.end(),
                                            [&](std::uint32_t atom) { return metalBonds_[atom] > 0; });
        if (ring.aromatic && (!holdsMetal || receptor(ring.atoms[0]))) return true;
        std::vector<glm::dvec3> normals;
        for (std::size_t i = 0; i < ring.atoms.size(); ++i) {
            const auto at = [&](std::size_t k) {
                return glm::dvec3(molecule_.atoms[ring.atoms[k % ring.atoms.size()]].position);
            };
            normals.push_back(glm::cross(at(i + 1) - at(i), at(i + ring.atoms.size() - 1) - at(i)));
        }
        for (const glm::dvec3& u : normals)
            for (const glm::dvec3& v : normals) {
                const double angle = angleBetween(u, v);
                if (angle > kMostBend && angle < 180 - kMostBend) return false;
            }
        return true;
    }

    /// Bonded residues form one ligand, except water and receptors.
    void addUnits() {
        std::vector<std::uint32_t>& unit = features_.unit;
        unit.resize(molecule_.residues.size());
        std::iota(unit.begin(), unit.end(), 0u);
        const auto root = [&](std::uint32_t r) {
            while (unit[r] != r) r = unit[r] = unit[unit[r]];
            return r;
        };
        for (const Bond& bond : molecule_.bonds) {
            const std::uint32_t a = molecule_.atoms[bond.a].residue, b = molecule_.atoms[bond.b].residue;
            if (a == b || features_.receptor[a] || features_.receptor[b]) continue;
            if (features_.waterOxygen[bond.a] || features_.waterOxygen[bond.b]) continue;
            const std::uint32_t low = std::min(root(a), root(b)), high = std::max(root(a), root(b));
            unit[high] = low;
        }
        for (std::uint32_t r = 0; r < unit.size(); ++r) unit[r] = root(r);
    }

    /// A ligand is considered without what it is bonded to: its carbon there is hydrophobic if its other neighbours
    /// are.
    void addLinkedCarbon(std::uint32_t atom) {
        if (element(atom) != kCarbon) return;
        bool linked = false, others = true, already = true;
        for (const Neighbour& n : chemistry_.of(atom)) {
            const bool plain = element(n.atom) == kCarbon || element(n.atom) == kHydrogenAtom;
            already = already && plain;
            if (receptor(n.atom))
                linked = true;
            else
                others = others && plain;
        }
        if (linked && others && !already) features_.hydrophobic.push_back(atom);
    }

    Element element(std::uint32_t atom) const { return molecule_.atoms[atom].element; }
    bool receptor(std::uint32_t atom) const { return features_.receptor[molecule_.atoms[atom].residue] != 0; }
    std::string_view residueName(std::uint32_t atom) const {
        return molecule_.residues[molecule_.atoms[atom].residue].name.view();
    }
    std::string_view atomName(std::uint32_t atom) const { return molecule_.atoms[atom].name.view(); }

    std::size_t count(std::uint32_t atom, Element e) const {
        std::size_t number = 0;
        for (const Neighbour& n : chemistry_.of(atom)) number += element(n.atom) == e;
        return number;
    }

    /// Terminal oxygens of a neighbour: those before this one in Open Babel's order, and all of them.
    struct Ends {
        std::size_t before = 0, all = 0;
    };
    Ends acidEnds(std::uint32_t atom) const {
        Ends ends;
        const auto around = heavyNeighbours(molecule_, chemistry_, atom);
        if (around.size() != 1) return ends;
        const Neighbour* self = nullptr;
        for (const Neighbour& n : chemistry_.of(around[0]))
            if (n.atom == atom) self = &n;
        for (const Neighbour& n : chemistry_.of(around[0])) {
            if (element(n.atom) != kOxygen || heavyNeighbours(molecule_, chemistry_, n.atom).size() != 1) continue;
            if (metalBonds_[n.atom] > 0 && element(around[0]) != kCarbon) continue;
            ++ends.all;
            if (n.atom != atom && comesLater(molecule_, *self, n)) ++ends.before;
        }
        return ends;
    }

    /// Number of double bonds that Open Babel gives the ends of an acid: none for sulphonates and bent carbons.
    std::optional<std::size_t> twofoldEnds(std::uint32_t centre, std::size_t ends) const {
        constexpr double kPlanar = 115;  // degrees; a carbon with a larger mean angle is planar
        const Element e = element(centre);
        if (e == kCarbon && ends > 0 && !receptor(centre) && meanAngle(centre) <= kPlanar) return 0;
        if (e == kPhosphorus || (e == kCarbon && ends == 2)) return 1;
        if (e == kSulphur && ends >= 2) return ends == 3 ? 0 : 2;
        return std::nullopt;
    }

    double meanAngle(std::uint32_t atom) const {
        std::vector<glm::dvec3> ways;
        double sum = 0, angles = 0;
        for (const std::uint32_t other : heavyNeighbours(molecule_, chemistry_, atom)) {
            const glm::dvec3 way(molecule_.atoms[other].position - molecule_.atoms[atom].position);
            for (const glm::dvec3& before : ways) sum += angleBetween(way, before), ++angles;
            ways.push_back(way);
        }
        return sum / angles;
    }

    /// Missing hydrogens of an uncharged N, O or S.
    std::uint8_t missing(std::uint32_t atom) const {
        const Element e = element(atom);
        int valence = (e == kNitrogen ? 3 : 2) + molecule_.atoms[atom].charge - metalBonds_[atom];
        if (receptor(atom)) {
            // By Open Babel's kekulisation: arginine's double bond is at NE, tryptophan's nitrogen has no hydrogen, and
            // histidine's ND1 has one if it is above CD2.
            const std::string_view residue = residueName(atom), name = atomName(atom);
            if (residue == "ARG" && name == "NE") return 0;
            if (residue == "ARG" && (name == "NH1" || name == "NH2")) return 2;
            if (residue == "TRP" && name == "NE1") return 0;
            if (residue == "HIS" && name == "NE2") return 0;
            if (residue == "HIS" && name == "ND1") return aboveItsRing(atom) ? 1 : 0;
        }
        if (e == kOxygen && heavyNeighbours(molecule_, chemistry_, atom).size() == 1) {
            const std::uint32_t centre = heavyNeighbours(molecule_, chemistry_, atom)[0];
            const Ends ends = acidEnds(atom);
            if (const auto twofold = twofoldEnds(centre, ends.all)) {
                const int bonds = ends.before < *twofold && metalBonds_[atom] == 0 ? 2 : 1;
                valence -= bonds + static_cast<int>(count(atom, kHydrogenAtom));
                return static_cast<std::uint8_t>(std::clamp(valence, 0, 1));
            }
        }
        if (!fiveRings_.empty() && fiveRings_[atom]) return fiveRings_[atom] == kUnmatched ? 1 : 0;
        if (const auto guanine = hydrogensOfGuanine(atom)) return *guanine;
        for (const Neighbour& n : chemistry_.of(atom))  // nitro groups and N-oxides
            if (e == kOxygen && element(n.atom) == kNitrogen && chemistry_.orders(n.atom) >= 4) return 0;
        return static_cast<std::uint8_t>(std::clamp(valence - chemistry_.orders(atom), 0, 3));
    }

    /// An aromatic ring of five, whose atoms all need a double bond (imidazole, pyrrole): Open Babel gives one to the
    /// first atom and its first bonded neighbour, then to the two that follow that neighbour. The hydrogen goes to the
    /// atom that is left, which may be a carbon.
    void matchFiveRings() {
        std::vector<std::uint8_t> rings(molecule_.atoms.size());
        for (const Ring& ring : chemistry_.rings)
            for (const std::uint32_t atom : ring.atoms)
                rings[atom] = static_cast<std::uint8_t>(rings[atom] < 2 ? rings[atom] + 1 : 2);
        const auto wants = [&](std::uint32_t atom) {
            const auto around = chemistry_.of(atom);
            const bool twofold = std::ranges::any_of(
                around, [&](const Neighbour& n) { return rings[n.atom] == 0 && chemistry_.order[n.bond] > 1; });
            if (rings[atom] != 1 || twofold || receptor(atom)) return false;
            return element(atom) == kCarbon || (element(atom) == kNitrogen && around.size() == 2);
        };
        for (const Ring& ring : chemistry_.rings) {
            if (ring.atoms.size() != 5 || !ring.aromatic || !std::ranges::all_of(ring.atoms, wants)) continue;
            const std::uint32_t first = *std::ranges::min_element(ring.atoms);
            const Neighbour* last = nullptr;
            for (const Neighbour& n : chemistry_.of(first))
                if (rings[n.atom] == 1 && std::find(ring.atoms.begin(), ring.atoms.end(), n.atom) != ring.atoms.end() &&
                    (!last || comesLater(molecule_, n, *last)))
                    last = &n;
            fiveRings_.resize(molecule_.atoms.size());
            for (const std::uint32_t atom : ring.atoms) fiveRings_[atom] = atom == last->atom ? kUnmatched : kMatched;
        }
    }

    /// Open Babel moves the hydrogen of guanine's N1 to N3, and that of isocytosines likewise: from the nitrogen beside
    /// the carbonyl to the other neighbour of the carbon that bears the amine. Empty for other atoms.
    std::optional<std::uint8_t> hydrogensOfGuanine(std::uint32_t atom) const {
        if (element(atom) != kNitrogen || heavyNeighbours(molecule_, chemistry_, atom).size() != 2) return std::nullopt;
        for (const Neighbour& n : chemistry_.of(atom)) {
            if (element(n.atom) != kCarbon || !chemistry_.aromaticAtom[n.atom]) continue;
            std::optional<std::uint32_t> other;
            bool amine = false;
            for (const std::uint32_t m : findNeighbours(n.atom, kNitrogen)) {
                const std::size_t heavy = heavyNeighbours(molecule_, chemistry_, m).size();
                amine = amine || heavy == 1;
                if (m != atom && heavy == 2) other = m;
            }
            if (amine && other && besideCarbonyl(atom) != besideCarbonyl(*other)) return besideCarbonyl(atom) ? 0 : 1;
        }
        return std::nullopt;
    }

    bool besideCarbonyl(std::uint32_t nitrogen) const {
        const auto carbons = findNeighbours(nitrogen, kCarbon);
        return std::any_of(carbons.begin(), carbons.end(), [&](std::uint32_t carbon) {
            const auto oxygens = findNeighbours(carbon, kOxygen);
            return std::any_of(oxygens.begin(), oxygens.end(), [&](std::uint32_t oxygen) {
                return heavyNeighbours(molecule_, chemistry_, oxygen).size() == 1;
            });
        });
    }

    /// Whether an atom of histidine lies higher (z) than CD2 of the same residue.
    bool aboveItsRing(std::uint32_t atom) const {
        const Residue& residue = molecule_.residues[molecule_.atoms[atom].residue];
        const std::uint32_t count = std::min(residue.atomCount, kLargestAminoAcid);
        for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + count; ++i)
            if (chemistry_.present[i] && atomName(i) == "CD2")
                return molecule_.atoms[atom].position.z > molecule_.atoms[i].position.z;
        return false;
    }

    /// Open Babel bonds metals to everything near enough; each such bond replaces a hydrogen.
    void countMetalBonds() {
        metalBonds_.assign(molecule_.atoms.size(), 0);
        ownMetal_.assign(molecule_.atoms.size(), 0);
        std::vector<glm::vec3> places;
        float largest = 0;
        for (const std::uint32_t metal : features_.metals) {
            places.push_back(molecule_.atoms[metal].position);
            largest = std::max(largest, covalentRadius(element(metal)));
        }
        if (places.empty()) return;
        constexpr double kTolerance = 0.45, kLargestNeighbour = 1.2;
        const PlaceGrid grid(places, static_cast<double>(largest) + kLargestNeighbour + kTolerance);
        for (std::uint32_t i = 0; i < metalBonds_.size(); ++i) {
            if (!chemistry_.present[i] || isMetal(element(i))) continue;
            grid.near(molecule_.atoms[i].position, [&](std::uint32_t index, double squared) {
                const std::uint32_t metal = features_.metals[index];
                const double most =
                    static_cast<double>(covalentRadius(element(metal)) + covalentRadius(element(i))) + kTolerance;
                if (squared >= most * most) return;
                ++metalBonds_[i];
                ownMetal_[i] += molecule_.atoms[metal].residue == molecule_.atoms[i].residue;
            });
        }
    }

    void addPolar(std::uint32_t atom) {
        const Element e = element(atom);
        if (e != kNitrogen && e != kOxygen && e != kSulphur) return;
        const std::uint8_t lacking = e == kSulphur ? 0 : missing(atom);
        const std::size_t there = chemistry_.of(atom).size() - heavyNeighbours(molecule_, chemistry_, atom).size();
        if (e != kSulphur && lacking + there > 0) features_.donors.push_back({atom, lacking});
        if (accepts(atom, lacking)) features_.acceptors.push_back(atom);
    }

    /// Open Babel's IsHbondAcceptor().
    bool accepts(std::uint32_t atom, std::uint8_t lacking) const {
        const Element e = element(atom);
        const std::size_t heavy = heavyNeighbours(molecule_, chemistry_, atom).size();
        if (e == kNitrogen) {
            const std::size_t bonds = chemistry_.of(atom).size() + lacking + ownMetal_[atom];
            return !((bonds == 4 && chemistry_.hybrid[atom] == 3) || (bonds == 3 && chemistry_.hybrid[atom] == 2));
        }
        if (e != kOxygen || chemistry_.aromaticAtom[atom]) return false;
        std::size_t aromatic = 0;
        for (const Neighbour& n : chemistry_.of(atom)) {
            const Element other = element(n.atom);
            if (other == kNitrogen && chemistry_.orders(n.atom) >= 4) return false;
            if (other == kSulphur && count(n.atom, kOxygen) == 2 && count(n.atom, kCarbon) == 2)
                return false;  // sulphone
            aromatic += chemistry_.aromaticAtom[n.atom] != 0;
            if (!chemistry_.aromaticAtom[n.atom] && heavy == 2 && acyl(n.atom, atom)) return false;
        }
        return aromatic < 2;
    }

    /// Whether a carbon has a double bond to an oxygen other than this one: then this one is an ester's.
    bool acyl(std::uint32_t carbon, std::uint32_t oxygen) const {
        if (element(carbon) != kCarbon) return false;
        for (const Neighbour& n : chemistry_.of(carbon))
            if (n.atom != oxygen && element(n.atom) == kOxygen && chemistry_.order[n.bond] == 2) return true;
        return false;
    }

    void addCharge(std::vector<std::uint32_t> atoms, std::vector<std::uint32_t> centre, bool positive,
                   bool tertiary = false) {
        if (!atoms.empty()) features_.charged.push_back({std::move(atoms), std::move(centre), positive, tertiary});
    }

    void addSideChains() {
        for (std::uint32_t r = 0; r < molecule_.residues.size(); ++r) {
            if (!features_.receptor[r]) continue;
            const std::string_view name = molecule_.residues[r].name.view();
            const bool positive = name == "ARG" || name == "HIS" || name == "LYS";
            if (!positive && name != "ASP" && name != "GLU") continue;
            const auto atoms = sideChainAtoms(molecule_, chemistry_, r, positive ? kNitrogen : kOxygen);
            addCharge(atoms, atoms, positive);
        }
    }

    std::vector<std::uint32_t> findNeighbours(std::uint32_t atom, Element e) const {
        std::vector<std::uint32_t> list;
        for (const Neighbour& n : chemistry_.of(atom))
            if (element(n.atom) == e) list.push_back(n.atom);
        return list;
    }

    /// PLIP's functional groups of ligands.
    void addLigandGroup(std::uint32_t atom) {
        const auto around = heavyNeighbours(molecule_, chemistry_, atom);
        const std::size_t degree = around.size(), oxygens = count(atom, kOxygen);
        switch (element(atom)) {
            case kNitrogen:
                if (degree == 4) addCharge({atom}, {atom}, true);
                if (degree == 3 && chemistry_.hybrid[atom] == 3) addCharge({atom}, {atom}, true, true);
                break;
            case kSulphur:
                if (degree == 3) addCharge({atom}, {atom}, true);
                if (degree != 3 && (oxygens == 3 || oxygens == 4)) {
                    std::vector<std::uint32_t> atoms = findNeighbours(atom, kOxygen);
                    atoms.push_back(atom);
                    addCharge(atoms, {atom}, false);
                }
                break;
            case kPhosphorus:
                if (degree > 0 && oxygens == degree) {
                    std::vector<std::uint32_t> atoms = around;
                    atoms.push_back(atom);
                    addCharge(atoms, {atom}, false);
                }
                break;
            case kCarbon:
                if (oxygens == 2 && count(atom, kCarbon) == 1) {
                    const auto ends = findNeighbours(atom, kOxygen);
                    addCharge(ends, ends, false);
                } else if (degree == 3 && count(atom, kNitrogen) == 3) {
                    const bool end = std::ranges::any_of(
                        around, [&](std::uint32_t n) { return heavyNeighbours(molecule_, chemistry_, n).size() == 1; });
                    if (end) addCharge(around, {atom}, true);
                }
                break;
            default:
                break;
        }
    }

    bool receptorBindsMetal(std::uint32_t atom) const {
        const std::string_view residue = residueName(atom);
        const bool side = isSideChain(molecule_, atom);
        if (element(atom) == kOxygen)
            return !side || residue == "ASP" || residue == "GLU" || residue == "SER" || residue == "THR" ||
                   residue == "TYR";
        if (element(atom) == kNitrogen) return side && residue == "HIS";
        return element(atom) == kSulphur && residue == "CYS";
    }

    bool ligandBindsMetal(std::uint32_t atom) const {
        const Element e = element(atom);
        if (e == kNitrogen) return count(atom, kCarbon) == 2;
        if (e != kOxygen && e != kSulphur) return false;
        for (const Neighbour& n : chemistry_.of(atom)) {
            if (chemistry_.aromaticAtom[n.atom] && !chemistry_.aromaticAtom[atom]) return true;
            if (e == kOxygen && element(n.atom) == kPhosphorus && count(n.atom, kOxygen) >= 2) return true;
            if (e == kOxygen && element(n.atom) == kCarbon && count(n.atom, kOxygen) == 2 &&
                count(n.atom, kCarbon) == 1)
                return true;
        }
        return false;
    }

    static constexpr std::uint8_t kMatched = 1, kUnmatched = 2;
    const Molecule& molecule_;
    const Chemistry& chemistry_;
    Features features_;
    std::vector<std::uint8_t> fiveRings_;   // by atom: kMatched, kUnmatched, or 0: no such ring; may be empty
    std::vector<std::uint8_t> metalBonds_;  // by atom
    std::vector<std::uint8_t> ownMetal_;    // those to metals of the same residue
};

}  // namespace

Features plipFeatures(const Molecule& molecule, const Chemistry& chemistry) {
    return PlipFeatures(molecule, chemistry).run();
}

}  // namespace nacre
