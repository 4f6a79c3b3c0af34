#pragma once
// The steps of perceiveChemistry() and their shared data. Internal to this folder.

#include <glm/geometric.hpp>

#include "engine/molecule/chemistry/chemistry.h"

namespace nacre {

/// Atomic numbers used in the rules.
enum : Element {
    kHydrogenAtom = 1,
    kBoron = 5,
    kCarbon = 6,
    kNitrogen = 7,
    kOxygen = 8,
    kFluorine = 9,
    kSodium = 11,
    kSilicon = 14,
    kPhosphorus = 15,
    kSulphur = 16,
    kChlorine = 17,
    kArsenic = 33,
    kSelenium = 34,
    kBromine = 35,
    kIodine = 53
};

/// Source of a bond's order.
enum class OrderSource : std::uint8_t { unknown, stated, residueTemplate };

struct ChemistryWork {
    const Molecule& molecule;
    Chemistry& chemistry;
    std::vector<OrderSource> source;     ///< by bond
    std::vector<std::uint8_t> inRing;    ///< by bond
    std::vector<std::uint8_t> flatRing;  ///< by atom: size of its smallest flat ring of five or six, else 0
    std::vector<std::uint8_t> ringAtom;  ///< by atom: size of its smallest ring, else 0
    std::vector<float> ringTorsion;      ///< by ring: mean torsion, degrees

    const Atom& atom(std::uint32_t i) const { return molecule.atoms[i]; }
    Element element(std::uint32_t i) const { return molecule.atoms[i].element; }
    glm::vec3 position(std::uint32_t i) const { return molecule.atoms[i].position; }
    bool isHydrogenAt(std::uint32_t i) const { return element(i) == kHydrogenAtom || element(i) == 119; }
    std::size_t degree(std::uint32_t i) const { return chemistry.of(i).size(); }
    std::size_t heavyDegree(std::uint32_t i) const {
        std::size_t count = 0;
        for (const Neighbour& n : chemistry.of(i)) count += !isHydrogenAt(n.atom);
        return count;
    }
    float length(std::uint32_t i, std::uint32_t j) const { return glm::distance(position(i), position(j)); }
};

/// Fills Chemistry::rings, ::inRing and ::ringAtom, and marks flat rings.
void findRings(ChemistryWork& work);

/// By bond: whether it lies on any cycle. Reads present atoms, neighbours and the number of bonds.
std::vector<std::uint8_t> cyclicBonds(const Chemistry& chemistry);

/// By atom: whether a bond leads to a metal.
std::vector<std::uint8_t> boundToMetals(const ChemistryWork& work);

/// Orders of the bonds with unknown source, from lengths and angles.
void perceiveOrders(ChemistryWork& work);

/// One Kekulé structure for stated aromatic bonds (order 4).
void kekulise(ChemistryWork& work);

/// Marks aromatic rings, their atoms and bonds. Needs orders.
void findAromatic(ChemistryWork& work);

/// Charges, hydrogens, hybridisation and delocalised bonds. Needs aromatic rings.
void findStates(ChemistryWork& work);

/// Sets Ring::drawnAromatic. Needs hybridisation.
void chooseDrawnRings(ChemistryWork& work);

/// Atoms that may share pi bonds, as input for the best distribution.
struct PiSystem {
    struct Atom {
        float cost[3] = {0, 0, 0};  ///< cost of 0, 1, 2 pi bonds
        std::uint8_t most = 1;      ///< maximum number of pi bonds
    };
    struct Bond {
        std::uint32_t a = 0, b = 0;  ///< into atoms
        float gain[3] = {0, 0, 0};   ///< gain of 0, 1, 2 pi bonds here
    };
    std::vector<Atom> atoms;
    std::vector<Bond> bonds;
};

/// Pi bonds of each bond that maximise the sum of gains less costs. Exact up to kMostPiStates open distributions (fewer
/// with very many bonds, to limit memory), which rings fused in a row or a plane never exceed; beyond that, keeps the
/// best ones.
std::vector<std::uint8_t> bestPiBonds(const PiSystem& system);
constexpr std::size_t kMostPiStates = 4000, kMostPiStatesInAll = 8'000'000;

}  // namespace nacre
