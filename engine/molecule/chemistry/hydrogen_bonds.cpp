// Hydrogen bonds by the rules of Mol*, PLIP, Baker and Hubbard, Wernet and Nilsson.

#include <algorithm>

#include "engine/molecule/chemistry/hydrogens.h"
#include "engine/molecule/chemistry/interaction_search.h"
#include "engine/molecule/chemistry/place_grid.h"
#include "engine/molecule/chemistry/steps.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

// Mol*: donor to acceptor, Å.
constexpr double kMolstarLength = 3.5, kMolstarSulphurLength = 4.1;
// PLIP: donor to acceptor, Å, exclusive; degrees at the hydrogen.
constexpr double kPlipLength = 4.1, kPlipAngle = 100;
constexpr double kShortest = 0.5;  // Å: nearer atoms are copies
// Baker and Hubbard (1984): hydrogen to acceptor, Å; degrees at the hydrogen.
constexpr double kBakerLength = 2.5, kBakerAngle = 120;
// Wernet et al. (2004): donor to acceptor less than 3.3 Å - 0.00044 Å delta², delta the angle H-D-A in degrees.
constexpr double kWernetLength = 3.3, kWernetFactor = 0.00044;

std::vector<glm::vec3> collectPlaces(const InteractionSearch& search, const std::vector<std::uint32_t>& atoms) {
    std::vector<glm::vec3> places;
    places.reserve(atoms.size());
    for (const std::uint32_t atom : atoms) places.push_back(search.molecule.atoms[atom].position);
    return places;
}

double idealAngle(std::uint8_t hybrid) { return hybrid == 1 ? 180 : hybrid == 2 ? 120 : 109.47; }

/// Angle between a direction and the plane of an atom and two others: two of its neighbours, or its one neighbour and a
/// neighbour of that.
double angleOutOfPlane(const InteractionSearch& search, std::uint32_t atom, const glm::dvec3& way) {
    auto around = heavyNeighbours(search.molecule, search.chemistry, atom);
    if (around.size() == 1) {
        for (const std::uint32_t next : heavyNeighbours(search.molecule, search.chemistry, around[0]))
            if (next != atom) {
                around.push_back(next);
                break;
            }
    }
    if (around.size() < 2) return 0;
    const glm::dvec3 across =
        glm::cross(search.at(around[0]) - search.at(atom), search.at(around[1]) - search.at(atom));
    return std::abs(90 - angleBetween(across, way));
}

/// Mol*: an oxygen next to a planar carbon is planar, whatever its other neighbour.
std::uint8_t findAcceptorShape(const InteractionSearch& search, std::uint32_t acceptor) {
    const std::uint8_t shape = search.chemistry.hybrid[acceptor];
    if (shape != 3 || search.molecule.atoms[acceptor].element != kOxygen) return shape;
    for (const Neighbour& n : search.chemistry.of(acceptor))
        if (search.molecule.atoms[n.atom].element == kCarbon && search.chemistry.hybrid[n.atom] == 2) return 2;
    return shape;
}

bool mayBind(const InteractionSearch& search, std::uint32_t donor, std::uint32_t acceptor) {
    // Hydrogen bonds between waters are left out; water counts where the partner is no water.
    if (search.features.waterOxygen[donor] && search.features.waterOxygen[acceptor]) return false;
    return search.apart(donor, acceptor) && search.allowed(donor, acceptor);
}

void addBond(InteractionSearch& search, std::uint32_t donor, std::uint32_t hydrogen, std::uint32_t acceptor,
             double angle, int sides) {
    InteractionEnd first{{donor}, search.at(donor)}, second{{acceptor}, search.at(acceptor)};
    if (hydrogen != kNoHydrogen) first.atoms.push_back(hydrogen);
    Interaction& bond =
        search.add(InteractionKind::hydrogenBond, std::move(first), std::move(second), DonorSide::a, sides);
    if (angle >= 0) bond.angles.push_back({"donor", angle});
}

void findMolstarBonds(InteractionSearch& search, const PlaceGrid& grid) {
    for (const Donor& donor : search.features.donors) {
        const bool sulphur = search.molecule.atoms[donor.atom].element == kSulphur;
        grid.near(search.molecule.atoms[donor.atom].position, [&](std::uint32_t index, double squared) {
            const std::uint32_t acceptor = search.features.acceptors[index];
            const bool longer = sulphur || search.molecule.atoms[acceptor].element == kSulphur;
            const double most = longer ? kMolstarSulphurLength : kMolstarLength;
            if (squared > most * most || squared < kShortest * kShortest || donor.atom == acceptor) return;
            const int sides = search.sides(donor.atom, acceptor);
            if (sides == 0 || !mayBind(search, donor.atom, acceptor)) return;
            if (!molstarGeometry(search, donor.atom, acceptor)) return;
            std::uint32_t nearest = kNoHydrogen;
            double least = 1e9;
            for (const PlacedHydrogen& h : placeHydrogens(search, donor)) {
                const double away = glm::distance(h.place, search.at(acceptor));
                if (away >= least) continue;
                least = away;
                nearest = h.atom;
            }
            const double angle = nearest == kNoHydrogen ? -1
                                                        : angleBetween(search.at(donor.atom) - search.at(nearest),
                                                                       search.at(acceptor) - search.at(nearest));
            addBond(search, donor.atom, nearest, acceptor, angle, sides);
        });
    }
}

void findPlipBonds(InteractionSearch& search, const PlaceGrid& grid) {
    for (const Donor& donor : search.features.donors) {
        if (search.features.waterOxygen[donor.atom]) continue;
        const std::vector<PlacedHydrogen> hydrogens = placeHydrogens(search, donor);
        grid.near(search.molecule.atoms[donor.atom].position, [&](std::uint32_t index, double squared) {
            const std::uint32_t acceptor = search.features.acceptors[index];
            if (squared >= kPlipLength * kPlipLength || squared <= kShortest * kShortest) return;
            if (search.features.waterOxygen[acceptor]) return;
            const int sides = search.sides(donor.atom, acceptor);
            if (sides == 0 || !mayBind(search, donor.atom, acceptor)) return;
            for (const PlacedHydrogen& h : hydrogens) {
                const double angle = angleBetween(search.at(donor.atom) - h.place, search.at(acceptor) - h.place);
                if (angle > kPlipAngle) addBond(search, donor.atom, h.atom, acceptor, angle, sides);
            }
        });
    }
}

}  // namespace

std::vector<PlacedHydrogen> placeHydrogens(const InteractionSearch& search, const Donor& donor) {
    std::vector<PlacedHydrogen> hydrogens;
    for (const Neighbour& n : search.chemistry.of(donor.atom))
        if (isHydrogen(search.molecule.atoms[n.atom].element)) hydrogens.push_back({search.at(n.atom), n.atom});
    if (donor.hydrogens > 0) {
        // Open Babel prepares PLIP's files: its bond lengths, and its rule for rotatable hydrogens.
        constexpr HydrogenPlacing kPlacing{1.09f, 1.02f, 0.97f, 1.36f, 0.985f, 0.937f, true};
        for (const glm::vec3& place :
             hydrogenPositions(search.molecule, search.chemistry, donor.atom, donor.hydrogens, kPlacing))
            hydrogens.push_back({place, kNoHydrogen});
    }
    return hydrogens;
}

bool molstarGeometry(const InteractionSearch& search, std::uint32_t donor, std::uint32_t acceptor,
                     const MolstarLimits& limits) {
    const glm::dvec3 way = search.at(acceptor) - search.at(donor);
    const std::uint8_t donorShape = search.chemistry.hybrid[donor], acceptorShape = findAcceptorShape(search, acceptor);
    double hydrogen = 181;
    glm::dvec3 from = search.at(donor);  // or its hydrogen that is nearest to the acceptor
    for (const Neighbour& n : search.chemistry.of(donor)) {
        const double angle = angleBetween(search.at(n.atom) - search.at(donor), way);
        if (isHydrogen(search.molecule.atoms[n.atom].element)) {
            hydrogen = std::min(hydrogen, angle);
            if (limits.hydrogens &&
                glm::distance(search.at(n.atom), search.at(acceptor)) < glm::distance(from, search.at(acceptor)))
                from = search.at(n.atom);
        } else if (std::abs(idealAngle(donorShape) - angle) > limits.donor) {
            return false;
        }
    }
    if (limits.hydrogens && hydrogen < 180.5 && hydrogen > limits.donor) return false;
    if (donorShape == 2 && angleOutOfPlane(search, donor, way) > limits.donorPlane) return false;
    for (const Neighbour& n : search.chemistry.of(acceptor)) {
        if (!limits.hydrogens && isHydrogen(search.molecule.atoms[n.atom].element)) continue;
        const double angle = angleBetween(search.at(n.atom) - search.at(acceptor), from - search.at(acceptor));
        if (idealAngle(acceptorShape) - angle > limits.acceptor) return false;
    }
    return acceptorShape != 2 || angleOutOfPlane(search, acceptor, -way) <= limits.acceptorPlane;
}

void findHydrogenBonds(InteractionSearch& search) {
    const std::vector<glm::vec3> places = collectPlaces(search, search.features.acceptors);
    const PlaceGrid grid(places, kMolstarSulphurLength);
    search.rules == InteractionRules::plip ? findPlipBonds(search, grid) : findMolstarBonds(search, grid);
}

/// As in MDTraj: donors are N and O with hydrogens in the file, acceptors all N and O; water is left out.
void findHydrogenBondsByHydrogens(InteractionSearch& search) {
    std::vector<std::uint32_t> acceptors;
    const auto eligible = [&](std::uint32_t atom) {
        const Element e = search.molecule.atoms[atom].element;
        return search.chemistry.present[atom] && (e == kNitrogen || e == kOxygen) && !search.features.waterOxygen[atom];
    };
    const auto count = static_cast<std::uint32_t>(search.molecule.atoms.size());
    for (std::uint32_t i = 0; i < count; ++i)
        if (eligible(i)) acceptors.push_back(i);
    const std::vector<glm::vec3> places = collectPlaces(search, acceptors);
    const bool baker = search.rules == InteractionRules::bakerHubbard;
    const PlaceGrid grid(places, baker ? kBakerLength : kWernetLength);
    for (const std::uint32_t donor : acceptors) {
        for (const Neighbour& n : search.chemistry.of(donor)) {
            if (!isHydrogen(search.molecule.atoms[n.atom].element)) continue;
            const std::uint32_t from = baker ? n.atom : donor;
            grid.near(search.molecule.atoms[from].position, [&](std::uint32_t index, double squared) {
                const std::uint32_t acceptor = acceptors[index];
                if (acceptor == donor) return;
                const double angle =
                    angleBetween(search.at(donor) - search.at(n.atom), search.at(acceptor) - search.at(n.atom));
                const double delta =
                    angleBetween(search.at(n.atom) - search.at(donor), search.at(acceptor) - search.at(donor));
                const bool bound = baker ? squared < kBakerLength * kBakerLength && angle > kBakerAngle
                                         : std::sqrt(squared) < kWernetLength - kWernetFactor * delta * delta;
                if (!bound) return;
                const int sides = search.sides(donor, acceptor);
                if (sides != 0) addBond(search, donor, n.atom, acceptor, angle, sides);
            });
        }
    }
}

}  // namespace nacre
