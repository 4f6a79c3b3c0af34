// Water between two partners.

#include <algorithm>
#include <map>
#include <set>

#include "engine/molecule/chemistry/interaction_search.h"
#include "engine/molecule/chemistry/place_grid.h"

namespace nacre {
namespace {

// PLIP's limits, Å and degrees. Mol* has no water bridges; its donors and acceptors use PLIP's limits.
constexpr double kFarthestWater = 4.1, kNearestWater = 2.5;
constexpr double kMolstarBond = 3.5, kTetrahedralWater = 109.47, kWaterDeviation = 45;
constexpr double kLeastWaterAngle = 71, kMostWaterAngle = 140, kIdealWaterAngle = 110, kLeastDonorAngle = 100;

struct WaterPartner {
    std::uint32_t atom = 0;
    bool donates = false;  ///< to the water
    glm::dvec3 hydrogen{};
    std::uint32_t hydrogenAtom = kNoHydrogen;
    double angle = -1;  ///< at the hydrogen
    bool bond = false;  ///< Mol*: it is a hydrogen bond, not only within the bridge's wider limits
};

Interaction& addBridge(InteractionSearch& search, const WaterPartner& first, const WaterPartner& second,
                       std::uint32_t water, double angle, int sides) {
    const auto end = [&](const WaterPartner& partner) {
        InteractionEnd made{{partner.atom}, search.at(partner.atom)};
        if (partner.hydrogenAtom != kNoHydrogen) made.atoms.push_back(partner.hydrogenAtom);
        return made;
    };
    const DonorSide donor = first.donates ? DonorSide::a : second.donates ? DonorSide::b : DonorSide::none;
    Interaction& bridge = search.add(InteractionKind::waterBridge, end(first), end(second), donor, sides);
    bridge.waters = {water};
    bridge.angles.push_back({"water", angle});
    const double donorAngle = first.donates ? first.angle : second.angle;
    if (donorAngle >= 0) bridge.angles.push_back({"donor", donorAngle});
    bridge.distance = std::max(glm::distance(search.at(first.atom), search.at(water)),
                               glm::distance(search.at(second.atom), search.at(water)));
    return bridge;
}

using Partners = std::map<std::uint32_t, std::vector<WaterPartner>>;  // by water

/// Refuses waters surrounded by so many atoms that their pairs would take forever. @returns the partners
Partners checkedPairs(Partners partners) {
    constexpr std::size_t kMostPairs = 100'000'000;
    std::size_t pairs = 0;
    for (const auto& [water, list] : partners) pairs += list.size() * list.size();
    if (pairs > kMostPairs)
        throw Error("cannot find interactions", "",
                    "its waters have more than " + std::to_string(kMostPairs) + " pairs of neighbours");
    return partners;
}

/// Partners of waters by Mol*'s rules, with wider angles than for hydrogen bonds. An atom that donates and accepts is
/// listed twice.
Partners molstarPartners(InteractionSearch& search, const PlaceGrid& grid) {
    constexpr MolstarLimits kLoose{80, 50, 45, 90, false};
    Partners partners;
    const auto each = [&](std::uint32_t atom, bool donates) {
        if (search.features.waterOxygen[atom]) return;
        grid.near(search.molecule.atoms[atom].position, [&](std::uint32_t index, double squared) {
            const std::uint32_t water = search.features.waters[index];
            if (squared < kNearestWater * kNearestWater || !search.together(atom, water)) return;
            const auto fits = [&](const MolstarLimits& limits) {
                return donates ? molstarGeometry(search, atom, water, limits)
                               : molstarGeometry(search, water, atom, limits);
            };
            const bool bond = squared <= kMolstarBond * kMolstarBond && fits({});
            if (bond || fits(kLoose)) partners[water].push_back({atom, donates, {}, kNoHydrogen, -1, bond});
        });
    };
    for (const Donor& donor : search.features.donors) each(donor.atom, true);
    for (const std::uint32_t acceptor : search.features.acceptors) each(acceptor, false);
    return partners;
}

/// A donor and an acceptor at one water, or two hydrogen bonds to it. Among waters between two atoms, the nearest
/// counts.
void findMolstarBridges(InteractionSearch& search, const PlaceGrid& grid) {
    struct Bridge {
        WaterPartner first, second;
        std::uint32_t water = 0;
        double angle = 0, squares = 0;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Bridge> nearest;
    const auto away = [&](std::uint32_t atom, std::uint32_t water) {
        return glm::distance(search.at(atom), search.at(water));
    };
    for (const auto& [water, list] : checkedPairs(molstarPartners(search, grid)))
        for (const WaterPartner& first : list)
            for (const WaterPartner& second : list) {
                if (first.atom >= second.atom || search.sides(first.atom, second.atom) == 0) continue;
                if (!search.apart(first.atom, second.atom)) continue;
                const double angle =
                    angleBetween(search.at(first.atom) - search.at(water), search.at(second.atom) - search.at(water));
                const bool passed =
                    first.donates != second.donates && angle >= kLeastWaterAngle && angle <= kMostWaterAngle;
                const bool bonds = first.bond && second.bond && std::abs(angle - kTetrahedralWater) <= kWaterDeviation;
                if (!passed && !bonds) continue;
                const double one = away(first.atom, water), other = away(second.atom, water);
                const Bridge bridge{first, second, water, angle, one * one + other * other};
                const auto [known, added] = nearest.emplace(std::pair(first.atom, second.atom), bridge);
                if (!added && bridge.squares < known->second.squares) known->second = bridge;
            }
    for (const auto& [atoms, bridge] : nearest)
        addBridge(search, bridge.first, bridge.second, bridge.water, bridge.angle,
                  search.sides(bridge.first.atom, bridge.second.atom));
}

/// The residue that PLIP takes as the ligand of a bridge.
std::uint32_t findUnit(const InteractionSearch& search, std::uint32_t acceptor, std::uint32_t donor) {
    const std::uint32_t first = search.residue(acceptor), second = search.residue(donor);
    const bool byDonor = search.features.receptor[first] && !search.features.receptor[second];
    return search.features.unit[byDonor ? second : first];
}

struct PlipBridge {
    const WaterPartner* acceptor = nullptr;
    const WaterPartner* donor = nullptr;
    std::uint32_t water = 0;
    double angle = 0;
    double off() const { return std::abs(kIdealWaterAngle - angle); }
};

Partners plipPartners(InteractionSearch& search, const PlaceGrid& grid) {
    Partners partners;
    constexpr double kNearest = kNearestWater * kNearestWater;
    for (const std::uint32_t acceptor : search.features.acceptors)
        grid.near(search.molecule.atoms[acceptor].position, [&](std::uint32_t index, double squared) {
            if (squared >= kNearest && search.together(acceptor, search.features.waters[index]))
                partners[search.features.waters[index]].push_back({acceptor, false, {}, kNoHydrogen, -1});
        });
    for (const Donor& donor : search.features.donors) {
        const std::vector<PlacedHydrogen> hydrogens = placeHydrogens(search, donor);
        grid.near(search.molecule.atoms[donor.atom].position, [&](std::uint32_t index, double squared) {
            const std::uint32_t water = search.features.waters[index];
            if (squared < kNearest || !search.together(donor.atom, water)) return;
            for (const PlacedHydrogen& h : hydrogens) {
                const double angle = angleBetween(search.at(donor.atom) - h.place, search.at(water) - h.place);
                if (angle > kLeastDonorAngle) partners[water].push_back({donor.atom, true, h.place, h.atom, angle});
            }
        });
    }
    return partners;
}

/// Donors that already have a hydrogen bond, with its ligand.
std::set<std::pair<std::uint32_t, std::uint32_t>> busyDonors(const InteractionSearch& search) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> busy;
    for (const Interaction& bond : search.found) {
        if (bond.kind != InteractionKind::hydrogenBond) continue;
        const bool fromA = bond.donor == DonorSide::a;
        const std::uint32_t donor = (fromA ? bond.a : bond.b).atoms[0], other = (fromA ? bond.b : bond.a).atoms[0];
        busy.insert({donor, findUnit(search, other, donor)});
    }
    return busy;
}

/// The bridges of one water and ligand that PLIP keeps: for each acceptor the one with its angle nearest to 110
/// degrees, and two of these. From the third on, the program compares with the second's angle instead of its deviation,
/// so that order decides: the ligand's acceptors, then the receptor's.
std::vector<PlipBridge> keptByPlip(const InteractionSearch& search, std::vector<PlipBridge> bridges) {
    std::stable_sort(bridges.begin(), bridges.end(), [&](const PlipBridge& l, const PlipBridge& r) {
        const auto rank = [&](const PlipBridge& bridge) {
            return std::pair(search.features.receptor[search.residue(bridge.acceptor->atom)], bridge.acceptor->atom);
        };
        return rank(l) < rank(r);
    });
    std::vector<PlipBridge> perAcceptor, kept;
    for (const PlipBridge& bridge : bridges) {
        if (perAcceptor.empty() || perAcceptor.back().acceptor->atom != bridge.acceptor->atom)
            perAcceptor.push_back(bridge);
        else if (perAcceptor.back().off() > bridge.off())
            perAcceptor.back() = bridge;
    }
    double second = 0;
    for (const PlipBridge& bridge : perAcceptor) {
        if (kept.size() < 2) {
            kept.push_back(bridge);
            std::stable_sort(kept.begin(), kept.end(),
                             [](const PlipBridge& l, const PlipBridge& r) { return l.off() < r.off(); });
            second = kept.back().off();
        } else if (second > bridge.off()) {
            kept[1] = bridge;
            second = bridge.angle;
        }
    }
    return kept;
}

void findPlipBridges(InteractionSearch& search, const PlaceGrid& grid) {
    const auto busy = busyDonors(search);
    for (const auto& [water, list] : checkedPairs(plipPartners(search, grid))) {
        std::map<std::uint32_t, std::vector<PlipBridge>> byUnit;
        for (const WaterPartner& acceptor : list) {
            for (const WaterPartner& donor : list) {
                if (acceptor.donates || !donor.donates || search.sides(acceptor.atom, donor.atom) == 0) continue;
                if (!search.apart(acceptor.atom, donor.atom) || !search.allowed(acceptor.atom, donor.atom)) continue;
                const std::uint32_t unit = findUnit(search, acceptor.atom, donor.atom);
                if (busy.contains({donor.atom, unit})) continue;
                const double angle =
                    angleBetween(search.at(acceptor.atom) - search.at(water), donor.hydrogen - search.at(water));
                if (angle > kLeastWaterAngle && angle < kMostWaterAngle)
                    byUnit[unit].push_back({&acceptor, &donor, water, angle});
            }
        }
        for (auto& [unit, bridges] : byUnit)
            for (const PlipBridge& bridge : keptByPlip(search, std::move(bridges)))
                addBridge(search, *bridge.acceptor, *bridge.donor, water, bridge.angle,
                          search.sides(bridge.acceptor->atom, bridge.donor->atom));
    }
}

}  // namespace

void findWaterBridges(InteractionSearch& search) {
    if (!search.wants(InteractionKind::waterBridge)) return;
    std::vector<glm::vec3> places;
    for (const std::uint32_t water : search.features.waters) places.push_back(search.molecule.atoms[water].position);
    const bool plip = search.rules == InteractionRules::plip;
    const PlaceGrid grid(places, kFarthestWater);
    plip ? findPlipBridges(search, grid) : findMolstarBridges(search, grid);
}

}  // namespace nacre
