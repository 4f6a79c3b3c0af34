// Drops interactions that stronger ones of the same groups include, as Mol* and PLIP do.

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "engine/molecule/chemistry/interaction_search.h"

namespace nacre {
namespace {

using AtomPair = std::pair<std::uint32_t, std::uint32_t>;

AtomPair ordered(std::uint32_t l, std::uint32_t r) { return {std::min(l, r), std::max(l, r)}; }

void dropMarked(std::vector<Interaction>& found, const std::vector<std::uint8_t>& dropped) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (dropped[i]) continue;
        if (kept != i) found[kept] = std::move(found[i]);
        ++kept;
    }
    found.resize(kept);
}

/// Pairs of atoms, one from each side, of all interactions of a kind.
std::set<AtomPair> atomPairs(const std::vector<Interaction>& found, InteractionKind kind) {
    std::set<AtomPair> pairs;
    for (const Interaction& interaction : found) {
        if (interaction.kind != kind) continue;
        for (const std::uint32_t i : interaction.a.atoms)
            for (const std::uint32_t j : interaction.b.atoms) pairs.insert(ordered(i, j));
    }
    return pairs;
}

/// Hydrogen bonds between two groups that form a salt bridge; hydrophobic contacts between two stacked rings.
std::vector<std::uint8_t> markImplied(const InteractionSearch& search) {
    std::vector<std::uint8_t> dropped(search.found.size());
    const std::set<AtomPair> bridged = atomPairs(search.found, InteractionKind::saltBridge);
    const std::set<AtomPair> stacked = atomPairs(search.found, InteractionKind::piStacking);
    for (std::size_t i = 0; i < dropped.size(); ++i) {
        const Interaction& interaction = search.found[i];
        if (interaction.kind != InteractionKind::hydrogenBond && interaction.kind != InteractionKind::hydrophobic)
            continue;
        const std::set<AtomPair>& stronger = interaction.kind == InteractionKind::hydrogenBond ? bridged : stacked;
        dropped[i] = stronger.contains(ordered(interaction.a.atoms[0], interaction.b.atoms[0]));
    }
    return dropped;
}

/// Whether PLIP would call side a of a contact the ligand.
bool ligandIsA(const InteractionSearch& search, const Interaction& interaction) {
    const auto receptor = [&](const InteractionEnd& end) {
        return search.features.receptor[search.residue(end.atoms[0])] != 0;
    };
    return !receptor(interaction.a) || receptor(interaction.b);
}

/// Keeps one hydrogen bond per donor and partner, the one with the largest angle. A partner is the receptor or one
/// ligand.
void keepOnePerDonor(const InteractionSearch& search, std::vector<std::uint8_t>& dropped) {
    std::map<AtomPair, std::size_t> best;
    for (std::size_t i = 0; i < search.found.size(); ++i) {
        const Interaction& interaction = search.found[i];
        if (interaction.kind != InteractionKind::hydrogenBond || dropped[i]) continue;
        const bool fromA = interaction.donor == DonorSide::a;
        const std::uint32_t donor = (fromA ? interaction.a : interaction.b).atoms[0];
        const std::uint32_t partner = search.residue((fromA ? interaction.b : interaction.a).atoms[0]);
        const std::uint32_t unit = search.features.receptor[partner] ? 0 : search.features.unit[partner] + 1;
        const auto [known, added] = best.try_emplace({donor, unit}, i);
        if (added) continue;
        if (search.found[known->second].angles[0].degrees < interaction.angles[0].degrees) {
            dropped[known->second] = 1;
            known->second = i;
        } else {
            dropped[i] = 1;
        }
    }
}

/// A ring that stacks with a histidine has no cation-pi contact with that histidine's charge.
void dropHistidineCations(const InteractionSearch& search, std::vector<std::uint8_t>& dropped) {
    std::set<std::pair<std::vector<std::uint32_t>, std::int32_t>> stacked;  // a ring, and the histidine's number
    const auto findResidue = [&](const InteractionEnd& end) -> const Residue& {
        return search.molecule.residues[search.residue(end.atoms[0])];
    };
    const auto histidine = [&](const InteractionEnd& end) { return findResidue(end).name == Name("HIS"); };
    for (const Interaction& interaction : search.found) {
        if (interaction.kind != InteractionKind::piStacking) continue;
        const InteractionEnd &a = interaction.a, &b = interaction.b;
        if (histidine(a)) stacked.emplace(b.atoms, findResidue(a).number);
        if (histidine(b)) stacked.emplace(a.atoms, findResidue(b).number);
    }
    for (std::size_t i = 0; i < search.found.size(); ++i) {
        const Interaction& interaction = search.found[i];
        if (interaction.kind != InteractionKind::cationPi) continue;
        const InteractionEnd& ring = interaction.a.ring ? interaction.a : interaction.b;
        const InteractionEnd& charge = interaction.a.ring ? interaction.b : interaction.a;
        dropped[i] = dropped[i] || (histidine(charge) && stacked.contains({ring.atoms, findResidue(charge).number}));
    }
}

/// The shortest contact of each ligand atom with each residue. PLIP identifies residues by number only, ignoring
/// chains.
std::vector<std::size_t> shortestPerResidue(const InteractionSearch& search, const std::vector<std::uint8_t>& dropped) {
    std::map<AtomPair, std::size_t> best;
    for (std::size_t i = 0; i < search.found.size(); ++i) {
        const Interaction& interaction = search.found[i];
        if (interaction.kind != InteractionKind::hydrophobic || dropped[i]) continue;
        const bool aLigand = ligandIsA(search, interaction);
        const InteractionEnd &ligand = aLigand ? interaction.a : interaction.b,
                             &other = aLigand ? interaction.b : interaction.a;
        const std::int32_t number = search.molecule.residues[search.residue(other.atoms[0])].number;
        const auto [known, added] = best.try_emplace({ligand.atoms[0], static_cast<std::uint32_t>(number)}, i);
        if (!added && search.found[known->second].distance > interaction.distance) known->second = i;
    }
    std::vector<std::size_t> kept;
    for (const auto& [key, index] : best) kept.push_back(index);
    return kept;
}

/// Groups of a ligand's atoms that are bonded to each other.
std::vector<std::size_t> clusters(const InteractionSearch& search, const std::vector<std::uint32_t>& atoms) {
    std::vector<std::size_t> group(atoms.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto bonded = [&](std::uint32_t l, std::uint32_t r) {
        const auto around = search.chemistry.of(l);
        return std::any_of(around.begin(), around.end(), [&](const Neighbour& n) { return n.atom == r; });
    };
    for (std::size_t i = 0; i < atoms.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (bonded(atoms[i], atoms[j])) {
                const std::size_t from = group[i], to = group[j];
                std::replace(group.begin(), group.end(), from, to);
            }
    return group;
}

/// Å: the radii of two carbons and 0.2. Contacts up to this length always count.
constexpr double kClosestCarbons = 3.6;

/// Merging never leaves a residue without such a close contact: its shortest one stays.
void keepOnePerResidue(const InteractionSearch& search, const std::vector<std::size_t>& contacts,
                       std::vector<std::uint8_t>& dropped) {
    struct Best {
        bool kept = false;
        std::size_t shortest = 0;
    };
    std::map<AtomPair, Best> byPair;
    for (const std::size_t i : contacts) {
        const Interaction& interaction = search.found[i];
        const AtomPair pair = ordered(search.residue(interaction.a.atoms[0]), search.residue(interaction.b.atoms[0]));
        Best& best = byPair.try_emplace(pair, Best{false, i}).first->second;
        best.kept = best.kept || !dropped[i];
        if (interaction.distance < search.found[best.shortest].distance) best.shortest = i;
    }
    for (const auto& [pair, best] : byPair)
        if (!best.kept && search.found[best.shortest].distance < kClosestCarbons) dropped[best.shortest] = 0;
}

/// If one atom of the receptor touches several atoms of a ligand, keeps the shortest contact of each group of bonded
/// atoms. Atoms bonded to none of the others are skipped, as in PLIP's program.
void reducePlipHydrophobic(const InteractionSearch& search, std::vector<std::uint8_t>& dropped) {
    std::map<std::uint32_t, std::vector<std::size_t>> byReceptor;
    const std::vector<std::size_t> shortest = shortestPerResidue(search, dropped);
    for (std::size_t i = 0; i < search.found.size(); ++i)
        if (search.found[i].kind == InteractionKind::hydrophobic) dropped[i] = 1;
    const auto sideAtom = [&](std::size_t i, bool ligand) {
        const Interaction& interaction = search.found[i];
        return (ligandIsA(search, interaction) == ligand ? interaction.a : interaction.b).atoms[0];
    };
    for (const std::size_t i : shortest) byReceptor[sideAtom(i, false)].push_back(i);
    for (const auto& [receptor, contacts] : byReceptor) {
        std::vector<std::uint32_t> atoms;
        for (const std::size_t i : contacts) atoms.push_back(sideAtom(i, true));
        const std::vector<std::size_t> group = clusters(search, atoms);
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            bool keep = contacts.size() == 1 || std::count(group.begin(), group.end(), group[i]) > 1;
            for (std::size_t j = 0; keep && j < contacts.size(); ++j) {
                if (i == j || group[i] != group[j]) continue;
                const double mine = search.found[contacts[i]].distance, other = search.found[contacts[j]].distance;
                keep = mine < other || (mine == other && i < j);
            }
            if (keep) dropped[contacts[i]] = 0;
        }
    }
    keepOnePerResidue(search, shortest, dropped);
}

/// A metal that binds only water is no complex, and some partners in a complex may be superfluous.
void dropMetals(const InteractionSearch& search, std::vector<std::uint8_t>& dropped) {
    std::map<std::uint32_t, std::vector<std::size_t>> byMetal;
    const std::set<std::uint32_t> metals(search.features.metals.begin(), search.features.metals.end());
    for (std::size_t i = 0; i < search.found.size(); ++i) {
        const Interaction& interaction = search.found[i];
        if (interaction.kind != InteractionKind::metal) continue;
        const std::uint32_t a = interaction.a.atoms[0];
        byMetal[metals.contains(a) ? a : interaction.b.atoms[0]].push_back(i);
    }
    for (const auto& [metal, contacts] : byMetal) {
        bool onlyWater = true;
        std::vector<glm::dvec3> places;
        for (const std::size_t i : contacts) {
            const Interaction& interaction = search.found[i];
            const std::uint32_t other = (interaction.a.atoms[0] == metal ? interaction.b : interaction.a).atoms[0];
            onlyWater = onlyWater && search.features.waterOxygen[other];
            places.push_back(search.at(other));
        }
        const std::vector<std::uint8_t> superfluous = superfluousPartners(search.at(metal), places);
        for (std::size_t i = 0; i < contacts.size(); ++i) dropped[contacts[i]] = onlyWater || superfluous[i];
    }
}

/// Mol*: keeps the shortest hydrophobic contact between an atom and a residue, from either side.
void keepShortestPerAtom(const InteractionSearch& search, std::vector<std::uint8_t>& dropped) {
    std::map<AtomPair, std::size_t> best;  // by an atom and the residue that it touches
    const auto listSides = [&](const Interaction& contact) {
        const std::uint32_t a = contact.a.atoms[0], b = contact.b.atoms[0];
        return std::array<AtomPair, 2>{AtomPair(a, search.residue(b)), AtomPair(b, search.residue(a))};
    };
    for (std::size_t i = 0; i < search.found.size(); ++i) {
        if (search.found[i].kind != InteractionKind::hydrophobic) continue;
        for (const AtomPair& side : listSides(search.found[i])) {
            const auto [known, added] = best.try_emplace(side, i);
            if (!added && search.found[i].distance < search.found[known->second].distance) known->second = i;
        }
    }
    for (std::size_t i = 0; i < search.found.size(); ++i) {
        if (search.found[i].kind != InteractionKind::hydrophobic) continue;
        for (const AtomPair& side : listSides(search.found[i])) dropped[i] |= best.at(side) != i;
    }
}

/// Whether a stronger interaction joins an atom of one end with an atom of the other.
bool joined(const Interaction& interaction, const std::set<AtomPair>& stronger) {
    for (const std::uint32_t i : interaction.a.atoms)
        for (const std::uint32_t j : interaction.b.atoms)
            if (stronger.contains(ordered(i, j))) return true;
    return false;
}

}  // namespace

void keepOnePerPair(std::vector<Interaction>& found) {
    using Key =
        std::tuple<InteractionKind, std::vector<std::uint32_t>, std::vector<std::uint32_t>, std::vector<std::uint32_t>>;
    const auto sortedAtoms = [](const Interaction& interaction, const InteractionEnd& end) {
        std::vector<std::uint32_t> atoms = end.atoms;
        const bool hydrogens =
            interaction.kind == InteractionKind::hydrogenBond || interaction.kind == InteractionKind::waterBridge;
        if (hydrogens) atoms.resize(1);  // the hydrogen follows its atom
        std::sort(atoms.begin(), atoms.end());
        return atoms;
    };
    const auto lastAngle = [](const Interaction& interaction) {
        return interaction.angles.empty() ? 0 : interaction.angles.back().degrees;
    };
    std::map<Key, std::size_t> best;
    std::vector<std::uint8_t> dropped(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        auto first = sortedAtoms(found[i], found[i].a), second = sortedAtoms(found[i], found[i].b);
        if (second < first) std::swap(first, second);
        const auto [at, added] = best.try_emplace(Key(found[i].kind, first, second, found[i].waters), i);
        if (added) continue;
        const bool better = lastAngle(found[i]) > lastAngle(found[at->second]);
        dropped[better ? at->second : i] = 1;
        if (better) at->second = i;
    }
    dropMarked(found, dropped);
}

void refineMolstar(const InteractionSearch& search) {
    std::vector<std::uint8_t> dropped = markImplied(search);
    if (search.rules != InteractionRules::molstar)  // hydrogen bonds of other rules are independent
        for (std::size_t i = 0; i < dropped.size(); ++i)
            if (search.found[i].kind == InteractionKind::hydrogenBond) dropped[i] = 0;
    const std::set<AtomPair> stacked = atomPairs(search.found, InteractionKind::piStacking);
    const std::set<AtomPair> coordinated = atomPairs(search.found, InteractionKind::metal);
    for (std::size_t i = 0; i < dropped.size(); ++i) {
        const Interaction& interaction = search.found[i];
        if (interaction.kind == InteractionKind::cationPi) dropped[i] = joined(interaction, stacked);
        if (interaction.kind == InteractionKind::saltBridge) dropped[i] = joined(interaction, coordinated);
    }
    keepShortestPerAtom(search, dropped);
    dropMarked(search.found, dropped);
}

void refinePlip(const InteractionSearch& search) {
    std::vector<std::uint8_t> dropped = markImplied(search);
    keepOnePerDonor(search, dropped);
    dropHistidineCations(search, dropped);
    reducePlipHydrophobic(search, dropped);
    dropMetals(search, dropped);
    dropMarked(search.found, dropped);
}

}  // namespace nacre
