// Drops interactions that an atom blocks.

#include <algorithm>
#include <glm/common.hpp>

#include "engine/molecule/chemistry/interaction_search.h"
#include "engine/molecule/chemistry/place_grid.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

constexpr double kSight = 3.0;     // Å from the middle of an interaction: search range
constexpr double kAtTheEnd = 1.0;  // Å from an end: inside a group

glm::dvec3 findMiddle(const Interaction& interaction) {
    return (glm::dvec3(interaction.a.place) + glm::dvec3(interaction.b.place)) / 2.0;
}

/// Atoms that may block any of the interactions.
std::vector<std::uint32_t> atomsAround(const InteractionSearch& search) {
    glm::vec3 low(1e30f), high(-1e30f);
    for (const Interaction& interaction : search.found) {
        const glm::vec3 middle(findMiddle(interaction));
        low = glm::min(low, middle - glm::vec3(kSight));
        high = glm::max(high, middle + glm::vec3(kSight));
    }
    std::vector<std::uint32_t> atoms;
    for (std::uint32_t i = 0; i < search.molecule.atoms.size(); ++i) {
        const Atom& atom = search.molecule.atoms[i];
        const glm::vec3& p = atom.position;
        if (!search.chemistry.present[i] || isHydrogen(atom.element)) continue;
        if (glm::max(p, low) == p && glm::min(p, high) == p) atoms.push_back(i);
    }
    return atoms;
}

/// Whether an atom belongs to the end, or is one of the four around a quaternary amine's nitrogen.
bool belongsTo(const InteractionSearch& search, const InteractionEnd& end, std::uint32_t atom) {
    if (std::find(end.atoms.begin(), end.atoms.end(), atom) != end.atoms.end()) return true;
    if (end.atoms.size() != 1) return false;
    const auto around = search.chemistry.of(end.atoms.front());
    return heavyNeighbours(search.molecule, search.chemistry, end.atoms.front()).size() == 4 &&
           std::any_of(around.begin(), around.end(), [&](const Neighbour& n) { return n.atom == atom; });
}

}  // namespace

void dropBlocked(InteractionSearch& search) {
    if (search.found.empty()) return;
    const std::vector<std::uint32_t> atoms = atomsAround(search);
    std::vector<glm::vec3> places;
    for (const std::uint32_t atom : atoms) places.push_back(search.molecule.atoms[atom].position);
    const PlaceGrid grid(places, kSight);
    const bool ownBonds = search.rules != InteractionRules::molstar;  // other rules define hydrogen bonds by themselves
    std::erase_if(search.found, [&](const Interaction& interaction) {
        if (ownBonds && interaction.kind == InteractionKind::hydrogenBond) return false;
        bool blocked = false;
        grid.near(glm::vec3(findMiddle(interaction)), [&](std::uint32_t i, double squared) {
            const std::uint32_t atom = atoms[i];
            const double radius = vanDerWaalsRadius(search.molecule.atoms[atom].element);
            if (blocked || squared >= radius * radius || !search.together(atom, interaction.a.atoms.front())) return;
            if (belongsTo(search, interaction.a, atom) || belongsTo(search, interaction.b, atom)) return;
            blocked = glm::distance(places[i], interaction.a.place) >= kAtTheEnd &&
                      glm::distance(places[i], interaction.b.place) >= kAtTheEnd;
        });
        return blocked;
    });
}

}  // namespace nacre
