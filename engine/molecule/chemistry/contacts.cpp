// Salt bridges, rings, halogen bonds, hydrophobic contacts and metals.

#include <algorithm>

#include "engine/molecule/chemistry/interaction_search.h"
#include "engine/molecule/chemistry/place_grid.h"
#include "engine/molecule/chemistry/steps.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

constexpr double kNearestContact = 0.5;                            // Å: nearer atoms are copies
constexpr double kMolstarSaltBridge = 5.0, kPlipSaltBridge = 5.5;  // Å between atoms; between middles
constexpr double kStacking = 5.5, kStackingAngle = 30, kOffset = 2.0;
constexpr double kCationPi = 6.0, kAmineAngle = 30;
constexpr double kHalogen = 4.0, kHalogenDeviation = 30, kHalogenAcceptor = 120;
constexpr double kMolstarHalogenDonor = 180, kPlipHalogenDonor = 165;
constexpr double kHydrophobicReach = 4.0, kMetalReach = 3.0;
constexpr double kLargestGroup = 4;  // Å from the middle of a charged group to its farthest atom

bool isPlip(const InteractionSearch& search) { return search.rules == InteractionRules::plip; }

InteractionEnd groupEnd(const InteractionSearch& search, const std::vector<std::uint32_t>& atoms,
                        const std::vector<std::uint32_t>& centre) {
    return {atoms, search.middle(centre)};
}

double nearestAtoms(const InteractionSearch& search, const ChargedGroup& l, const ChargedGroup& r) {
    double least = 1e9;
    for (const std::uint32_t i : l.atoms)
        for (const std::uint32_t j : r.atoms) least = std::min(least, glm::distance(search.at(i), search.at(j)));
    return least;
}

/// Distance from a ring's middle, within its plane, of a point above it.
double offsetInPlane(const glm::dvec3& centre, const glm::dvec3& normal, const glm::dvec3& point) {
    const glm::dvec3 way = point - centre;
    return glm::length(way - glm::dot(way, normal) * normal);
}

struct RingPlace {
    const std::vector<std::uint32_t>* atoms;
    glm::dvec3 centre, normal;
};

std::vector<RingPlace> ringPlaces(const InteractionSearch& search) {
    std::vector<RingPlace> places;
    for (const std::uint32_t r : search.features.rings) {
        const std::vector<std::uint32_t>& atoms = search.chemistry.rings[r].atoms;
        places.push_back({&atoms, search.middle(atoms), search.normal(atoms)});
    }
    return places;
}

double anglesOfPlanes(const glm::dvec3& u, const glm::dvec3& v) {
    const double angle = angleBetween(u, v);
    return std::min(angle, 180 - angle);
}

void findStacking(InteractionSearch& search, const std::vector<RingPlace>& rings, const PlaceGrid& grid) {
    for (std::uint32_t i = 0; i < rings.size(); ++i) {
        grid.near(rings[i].centre, [&](std::uint32_t j, double squared) {
            if (j <= i || squared >= kStacking * kStacking || squared <= kNearestContact * kNearestContact) return;
            const RingPlace &l = rings[i], &r = rings[j];
            const int sides = search.sides(*l.atoms, *r.atoms);
            if (sides == 0 || !search.apart(l.atoms->front(), r.atoms->front()) ||
                !search.allowed(l.atoms->front(), r.atoms->front()))
                return;
            const double angle = anglesOfPlanes(l.normal, r.normal);
            const double offset =
                std::min(offsetInPlane(l.centre, l.normal, r.centre), offsetInPlane(r.centre, r.normal, l.centre));
            if ((angle >= kStackingAngle && angle <= 90 - kStackingAngle) || offset >= kOffset) return;
            Interaction& found = search.add(InteractionKind::piStacking, {*l.atoms, l.centre, true},
                                            {*r.atoms, r.centre, true}, DonorSide::none, sides);
            found.angles.push_back({"planes", angle});
            found.offset = offset;
        });
    }
}

/// PLIP: a tertiary amine must point its lone pair at the ring, not its substituents.
bool aminePoints(const InteractionSearch& search, const ChargedGroup& group, const glm::dvec3& normal) {
    const auto around = heavyNeighbours(search.molecule, search.chemistry, group.atoms.front());
    const glm::dvec3 across =
        glm::cross(search.at(around[1]) - search.at(around[0]), search.at(around[0]) - search.at(around[2]));
    return anglesOfPlanes(normal, across) <= kAmineAngle;
}

void findCationPi(InteractionSearch& search, const std::vector<RingPlace>& rings, const PlaceGrid& grid) {
    for (const ChargedGroup& group : search.features.charged) {
        if (!group.positive) continue;
        const glm::dvec3 centre = search.middle(group.centre);
        grid.near(centre, [&](std::uint32_t r, double squared) {
            const RingPlace& ring = rings[r];
            if (squared >= kCationPi * kCationPi || squared <= kNearestContact * kNearestContact) return;
            const int sides = search.sides(*ring.atoms, group.atoms);
            if (sides == 0 || !search.apart(ring.atoms->front(), group.atoms.front()) ||
                !search.allowed(ring.atoms->front(), group.atoms.front()))
                return;
            const double offset = offsetInPlane(ring.centre, ring.normal, centre);
            if (offset >= kOffset) return;
            if (isPlip(search) && group.tertiaryAmine && !aminePoints(search, group, ring.normal)) return;
            Interaction& found = search.add(InteractionKind::cationPi, {*ring.atoms, ring.centre, true},
                                            {group.atoms, centre}, DonorSide::none, sides);
            found.offset = offset;
        });
    }
}

bool plipHalogenAngles(const HalogenEnd& acceptor, double atDonor, double atAcceptor) {
    return acceptor.bases == 1 && std::abs(atDonor - kPlipHalogenDonor) < kHalogenDeviation &&
           std::abs(atAcceptor - kHalogenAcceptor) < kHalogenDeviation;
}

/// An acceptor may have several neighbours, and large angles at it are not limited.
bool molstarHalogenAngles(const InteractionSearch& search, const glm::dvec3& halogen, const HalogenEnd& acceptor,
                          double atDonor) {
    if (atDonor < kMolstarHalogenDonor - kHalogenDeviation) return false;
    const glm::dvec3 y = search.at(acceptor.atom);
    for (const std::uint32_t n : heavyNeighbours(search.molecule, search.chemistry, acceptor.atom))
        if (angleBetween(halogen - y, search.at(n) - y) < kHalogenAcceptor - kHalogenDeviation) return false;
    return true;
}

void addHalogenBond(InteractionSearch& search, const HalogenEnd& donor, const HalogenEnd& acceptor) {
    const glm::dvec3 x = search.at(donor.atom), y = search.at(acceptor.atom);
    const double atDonor = angleBetween(y - x, search.at(donor.base) - x);
    const double atAcceptor = angleBetween(x - y, search.at(acceptor.base) - y);
    if (isPlip(search) ? !plipHalogenAngles(acceptor, atDonor, atAcceptor)
                       : !molstarHalogenAngles(search, x, acceptor, atDonor))
        return;
    const int sides = search.sides(donor.atom, acceptor.atom);
    if (sides == 0 || !search.apart(donor.atom, acceptor.atom) || !search.allowed(donor.atom, acceptor.atom)) return;
    Interaction& found =
        search.add(InteractionKind::halogenBond, {{donor.atom}, x}, {{acceptor.atom}, y}, DonorSide::a, sides);
    found.angles = {{"donor", atDonor}, {"acceptor", atAcceptor}};
}

/// Which atoms may coordinate a metal. PLIP: water, receptors and the metal's own ligand. Mol*: nitrogen and other
/// metals coordinate only transition metals.
bool mayHold(const InteractionSearch& search, std::uint32_t metal, std::uint32_t binder) {
    if (binder == metal) return false;
    if (isPlip(search)) {
        const std::uint32_t own = search.residue(metal), other = search.residue(binder);
        return search.features.waterOxygen[binder] || search.allowed(metal, binder) ||
               search.features.unit[own] == search.features.unit[other];
    }
    const Element held = search.molecule.atoms[metal].element, e = search.molecule.atoms[binder].element;
    if (isMetal(e)) return binder > metal && isTransitionMetal(held);
    return e != kNitrogen || isTransitionMetal(held);
}

}  // namespace

void findSaltBridges(InteractionSearch& search) {
    const bool plip = isPlip(search);
    const double most = plip ? kPlipSaltBridge : kMolstarSaltBridge;
    std::vector<const ChargedGroup*> negative;
    std::vector<glm::vec3> places;
    for (const ChargedGroup& group : search.features.charged) {
        if (group.positive) continue;
        negative.push_back(&group);
        places.push_back(search.middle(group.centre));
    }
    const PlaceGrid grid(places, most + (plip ? 0 : 2 * kLargestGroup));
    for (const ChargedGroup& group : search.features.charged) {
        if (!group.positive) continue;
        const glm::dvec3 centre = search.middle(group.centre);
        grid.near(centre, [&](std::uint32_t index, double squared) {
            const ChargedGroup& other = *negative[index];
            const double distance = plip ? std::sqrt(squared) : nearestAtoms(search, group, other);
            if (distance >= most || distance <= kNearestContact) return;
            const int sides = search.sides(group.atoms, other.atoms);
            if (sides == 0 || !search.apart(group.atoms.front(), other.atoms.front()) ||
                !search.allowed(group.atoms.front(), other.atoms.front()))
                return;
            search.add(InteractionKind::saltBridge, groupEnd(search, group.atoms, group.centre),
                       groupEnd(search, other.atoms, other.centre), DonorSide::none, sides);
        });
    }
}

void findRingContacts(InteractionSearch& search) {
    const std::vector<RingPlace> rings = ringPlaces(search);
    std::vector<glm::vec3> places;
    for (const RingPlace& ring : rings) places.push_back(ring.centre);
    const PlaceGrid grid(places, kCationPi);
    findStacking(search, rings, grid);
    findCationPi(search, rings, grid);
}

void findHalogenBonds(InteractionSearch& search) {
    std::vector<glm::vec3> places;
    for (const HalogenEnd& halogen : search.features.halogens)
        places.push_back(search.molecule.atoms[halogen.atom].position);
    if (places.empty()) return;
    const PlaceGrid grid(places, kHalogen);
    for (const HalogenEnd& acceptor : search.features.halogenAcceptors)
        grid.near(search.molecule.atoms[acceptor.atom].position, [&](std::uint32_t index, double squared) {
            if (squared < kHalogen * kHalogen && squared > kNearestContact * kNearestContact)
                addHalogenBond(search, search.features.halogens[index], acceptor);
        });
}

void findHydrophobic(InteractionSearch& search) {
    if (!search.wants(InteractionKind::hydrophobic)) return;
    std::vector<std::uint32_t> atoms = search.features.hydrophobic;
    if (!isPlip(search))
        for (const HalogenEnd& halogen : search.features.halogens)
            if (search.molecule.atoms[halogen.atom].element == kFluorine) atoms.push_back(halogen.atom);
    std::vector<glm::vec3> places;
    for (const std::uint32_t atom : atoms) places.push_back(search.molecule.atoms[atom].position);
    const PlaceGrid grid(places, kHydrophobicReach);
    for (std::uint32_t i = 0; i < atoms.size(); ++i)
        grid.near(places[i], [&](std::uint32_t j, double squared) {
            if (j <= i || squared >= kHydrophobicReach * kHydrophobicReach ||
                squared <= kNearestContact * kNearestContact)
                return;
            const int sides = search.sides(atoms[i], atoms[j]);
            if (sides == 0 || !search.apart(atoms[i], atoms[j]) || !search.allowed(atoms[i], atoms[j])) return;
            const auto element = [&](std::uint32_t k) { return search.molecule.atoms[atoms[k]].element; };
            if (element(i) == kFluorine && element(j) == kFluorine) return;
            search.add(InteractionKind::hydrophobic, {{atoms[i]}, places[i]}, {{atoms[j]}, places[j]}, DonorSide::none,
                       sides);
        });
}

void findMetals(InteractionSearch& search) {
    std::vector<glm::vec3> places;
    for (const std::uint32_t atom : search.features.metalBinders)
        places.push_back(search.molecule.atoms[atom].position);
    const PlaceGrid grid(places, kMetalReach);
    for (const std::uint32_t metal : search.features.metals)
        grid.near(search.molecule.atoms[metal].position, [&](std::uint32_t index, double squared) {
            const std::uint32_t binder = search.features.metalBinders[index];
            if (squared >= kMetalReach * kMetalReach || !mayHold(search, metal, binder)) return;
            int sides = search.sides(metal, binder);
            // A metal that is selected together with its ligand still counts as coordinated by it.
            if (sides == 0 && search.mayMeet(metal, binder) && search.query.a[metal] && search.query.a[binder])
                sides = 1;
            if (sides == 0 || (!isPlip(search) && !search.apart(metal, binder))) return;
            search.add(InteractionKind::metal, {{metal}, search.at(metal)}, {{binder}, search.at(binder)},
                       DonorSide::none, sides);
        });
}

}  // namespace nacre
