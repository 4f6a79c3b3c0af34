#include "engine/molecule/chemistry/interactions.h"

#include <algorithm>
#include <glm/vec4.hpp>
#include <tuple>

#include "engine/error.h"
#include "engine/molecule/chemistry/features.h"
#include "engine/molecule/chemistry/interaction_search.h"
#include "engine/molecule/drawn_atoms.h"

namespace nacre {
namespace {

// A molecule with an image of itself: every list twice, with the image's part second.

/// Appends a copy of a list's values to the list. @param shift  changes a copied value
template <typename T, typename Shift>
void repeat(std::vector<T>& list, const Shift& shift) {
    const std::size_t count = list.size();
    list.reserve(2 * count);
    for (std::size_t i = 0; i < count; ++i) {
        list.push_back(list[i]);
        shift(list.back());
    }
}

template <typename T>
void repeat(std::vector<T>& list) {
    repeat(list, [](T&) {});
}

Molecule withImage(const Molecule& molecule, const glm::dmat4x3& image) {
    const auto atoms = static_cast<std::uint32_t>(molecule.atoms.size());
    const auto residues = static_cast<std::uint32_t>(molecule.residues.size());
    Molecule both;
    both.atoms = molecule.atoms;
    both.residues = molecule.residues;
    both.chains = molecule.chains;
    both.modelsAreInputs = molecule.modelsAreInputs;
    both.file.title = molecule.file.title;
    repeat(both.atoms, [&](Atom& atom) {
        atom.position = glm::vec3(image * glm::dvec4(atom.position, 1));
        atom.residue += residues;
    });
    repeat(both.residues, [&](Residue& residue) { residue.firstAtom += atoms; });
    return both;
}

Chemistry withImage(const Chemistry& chemistry) {
    const auto atoms = static_cast<std::uint32_t>(chemistry.present.size());
    const auto bonds = static_cast<std::uint32_t>(chemistry.order.size());
    const auto neighbours = static_cast<std::uint32_t>(chemistry.neighbours.size());
    Chemistry both = chemistry;
    for (std::vector<std::uint8_t>* list : {&both.present, &both.order, &both.aromatic, &both.delocalised, &both.hybrid,
                                            &both.aromaticAtom, &both.hydrogens})
        repeat(*list);
    repeat(both.charge);
    both.first.pop_back();
    repeat(both.first, [&](std::uint32_t& first) { first += neighbours; });
    both.first.push_back(2 * neighbours);
    repeat(both.neighbours, [&](Neighbour& n) { n = {n.atom + atoms, n.bond + bonds}; });
    repeat(both.rings, [&](Ring& ring) {
        for (std::uint32_t& atom : ring.atoms) atom += atoms;
    });
    return both;
}

Features withImage(const Features& features, const Chemistry& chemistry) {
    const auto atoms = static_cast<std::uint32_t>(chemistry.present.size());
    const auto residues = static_cast<std::uint32_t>(features.receptor.size());
    const auto rings = static_cast<std::uint32_t>(chemistry.rings.size());
    Features both = features;
    const auto shifted = [&](std::uint32_t& atom) { atom += atoms; };
    const auto ends = [&](HalogenEnd& end) {
        end.atom += atoms;
        end.base += atoms;
    };
    for (std::vector<std::uint32_t>* list :
         {&both.acceptors, &both.hydrophobic, &both.metals, &both.metalBinders, &both.waters})
        repeat(*list, shifted);
    repeat(both.donors, [&](Donor& donor) { donor.atom += atoms; });
    repeat(both.halogens, ends);
    repeat(both.halogenAcceptors, ends);
    repeat(both.charged, [&](ChargedGroup& group) {
        for (std::vector<std::uint32_t>* list : {&group.atoms, &group.centre})
            for (std::uint32_t& atom : *list) atom += atoms;
    });
    repeat(both.rings, [&](std::uint32_t& ring) { ring += rings; });
    repeat(both.unit, [&](std::uint32_t& unit) { unit += residues; });
    for (std::vector<std::uint8_t>* list : {&both.waterOxygen, &both.receptor}) repeat(*list);
    return both;
}

constexpr std::array<std::string_view, kInteractionKinds> kKindNames = {
    "hydrogen-bond", "salt-bridge", "pi-stacking", "cation-pi", "halogen-bond", "hydrophobic", "metal", "water-bridge"};
constexpr std::array<std::string_view, 4> kRulesNames = {"molstar", "plip", "baker-hubbard", "wernet-nilsson"};

template <typename Value, std::size_t Count>
std::optional<Value> valueOfName(const std::array<std::string_view, Count>& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Value>(found - names.begin());
}

/// PLIP reads atoms without alternate location and those of location A. All other rules use the drawn atoms.
std::vector<std::uint32_t> conformer(const Molecule& molecule, InteractionRules rules) {
    if (rules != InteractionRules::plip) return drawnAtoms(molecule, {.water = true, .hydrogens = true});
    std::vector<std::uint32_t> atoms;
    for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i)
        if (molecule.atoms[i].alternate == '\0' || molecule.atoms[i].alternate == 'A') atoms.push_back(i);
    return atoms;
}

bool anyIn(const std::vector<std::uint32_t>& atoms, const std::vector<bool>& set) {
    return std::any_of(atoms.begin(), atoms.end(), [&](std::uint32_t atom) { return set[atom]; });
}

}  // namespace

std::string_view interactionKindName(InteractionKind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }
std::optional<InteractionKind> interactionKindFromName(std::string_view name) {
    return valueOfName<InteractionKind>(kKindNames, name);
}
std::string_view interactionRulesName(InteractionRules rules) { return kRulesNames[static_cast<std::size_t>(rules)]; }
std::optional<InteractionRules> interactionRulesFromName(std::string_view name) {
    return valueOfName<InteractionRules>(kRulesNames, name);
}

int InteractionSearch::sides(std::uint32_t first, std::uint32_t second) const {
    if (!mayMeet(first, second)) return 0;
    if (query.a[first] && b[second]) return 1;
    return query.a[second] && b[first] ? 2 : 0;
}

int InteractionSearch::sides(const std::vector<std::uint32_t>& first, const std::vector<std::uint32_t>& second) const {
    if (!mayMeet(first.front(), second.front())) return 0;
    if (anyIn(first, query.a) && anyIn(second, b)) return 1;
    return anyIn(second, query.a) && anyIn(first, b) ? 2 : 0;
}

Interaction& InteractionSearch::add(InteractionKind kind, InteractionEnd first, InteractionEnd second, DonorSide donor,
                                    int sides) {
    if (found.size() == kMostInteractions)
        throw Error("cannot find interactions", molecule.file.title.empty() ? "molecule" : molecule.file.title,
                    "there are more than " + std::to_string(kMostInteractions));
    Interaction& interaction = found.emplace_back();
    interaction.kind = kind;
    interaction.distance = glm::distance(glm::dvec3(first.place), glm::dvec3(second.place));
    if (sides == 2) {
        std::swap(first, second);
        if (donor != DonorSide::none) donor = donor == DonorSide::a ? DonorSide::b : DonorSide::a;
    }
    interaction.a = std::move(first);
    interaction.b = std::move(second);
    interaction.donor = donor;
    return interaction;
}

bool InteractionSearch::apart(std::uint32_t first, std::uint32_t second) const {
    if (residue(first) == residue(second)) return false;
    const auto around = chemistry.of(first);
    return std::none_of(around.begin(), around.end(), [&](const Neighbour& n) { return n.atom == second; });
}

bool InteractionSearch::allowed(std::uint32_t first, std::uint32_t second) const {
    if (!plipReceptors) return true;
    return features.receptor[residue(first)] || features.receptor[residue(second)];
}

glm::dvec3 InteractionSearch::middle(const std::vector<std::uint32_t>& atoms) const {
    glm::dvec3 sum(0);
    for (const std::uint32_t atom : atoms) sum += at(atom);
    return sum / static_cast<double>(atoms.size());
}

/// Normal of the best plane through a ring: the mean of the cross products around its middle.
glm::dvec3 InteractionSearch::normal(const std::vector<std::uint32_t>& ring) const {
    const glm::dvec3 centre = middle(ring);
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < ring.size(); ++i)
        sum += glm::cross(at(ring[i]) - centre, at(ring[(i + 1) % ring.size()]) - centre);
    const double length = std::sqrt(glm::dot(sum, sum));
    return length < 1e-9 ? glm::dvec3(0, 0, 1) : sum / length;
}

namespace {

constexpr float kWidestBridge = 8.2f;  // Å: of a water bridge, the longest interaction

std::vector<bool> findOthers(const InteractionQuery& query) {
    if (!query.b.empty()) return query.b;
    std::vector<bool> others = query.a;
    if (std::find(others.begin(), others.end(), false) != others.end()) others.flip();
    return others;
}

/// Maps indices of the image's atoms back to those of the molecule.
void splitImage(Interaction& interaction, std::uint32_t count) {
    const auto back = [&](std::vector<std::uint32_t>& atoms) {
        const bool image = !atoms.empty() && atoms.front() >= count;
        for (std::uint32_t& atom : atoms) atom %= count;
        return image;
    };
    interaction.a.image = back(interaction.a.atoms);
    interaction.b.image = back(interaction.b.atoms);
    interaction.waterImage = back(interaction.waters);
}

void run(InteractionSearch& search) {
    const Molecule& molecule = search.molecule;
    const bool plip = search.rules == InteractionRules::plip;
    search.modelsApart = !molecule.modelsAreInputs && !molecule.chains.empty() &&
                         molecule.chains.front().model != molecule.chains.back().model;
    search.plipReceptors = plip && search.query.b.empty();
    const bool byHydrogens =
        search.rules == InteractionRules::bakerHubbard || search.rules == InteractionRules::wernetNilsson;
    byHydrogens ? findHydrogenBondsByHydrogens(search) : findHydrogenBonds(search);
    findSaltBridges(search);
    findRingContacts(search);
    findHalogenBonds(search);
    findHydrophobic(search);
    findMetals(search);
    if (!plip) dropBlocked(search);
    plip ? refinePlip(search) : refineMolstar(search);
    findWaterBridges(search);
    std::vector<Interaction>& found = search.found;
    if (!byHydrogens) keepOnePerPair(found);  // those rules name each hydrogen
    std::erase_if(found, [&](const Interaction& interaction) { return !search.wants(interaction.kind); });
    const auto key = [](const Interaction& i) { return std::tie(i.kind, i.a.atoms, i.b.atoms, i.waters); };
    std::stable_sort(found.begin(), found.end(),
                     [&](const Interaction& l, const Interaction& r) { return key(l) < key(r); });
}

}  // namespace

struct InteractionFinder::Kept {
    InteractionRules rules;
    Chemistry chemistry;
    Features features;
};

InteractionFinder::InteractionFinder(const Molecule& molecule, InteractionRules rules)
    : kept_(std::make_unique<Kept>()) {
    kept_->rules = rules;
    kept_->chemistry = perceiveChemistry(molecule, conformer(molecule, rules));
    kept_->features = rules == InteractionRules::plip ? plipFeatures(molecule, kept_->chemistry)
                                                      : molstarFeatures(molecule, kept_->chemistry);
}
InteractionFinder::~InteractionFinder() = default;
InteractionFinder::InteractionFinder(InteractionFinder&&) noexcept = default;
InteractionFinder& InteractionFinder::operator=(InteractionFinder&&) noexcept = default;

std::vector<Interaction> InteractionFinder::find(const Molecule& molecule, const InteractionQuery& query) const {
    const bool all = std::find(query.a.begin(), query.a.end(), false) == query.a.end();
    const std::vector<bool> others = findOthers(query);
    Features around;  // groups extend some Å beyond their first atoms
    if (!all)
        around = featuresAround(kept_->features, molecule, kept_->chemistry,
                                boundingBox(molecule, query.a).grown(kWidestBridge + 5));
    std::vector<Interaction> found;
    InteractionSearch search{
        molecule, kept_->chemistry, all ? kept_->features : around, kept_->rules, query, others, false, false, found};
    run(search);
    return found;
}

std::vector<Interaction> InteractionFinder::findBetween(const Molecule& molecule, const glm::dmat4x3& image,
                                                        const InteractionQuery& query) const {
    const std::vector<bool> everything(molecule.atoms.size(), true);
    const AtomBox near = boundingBox(molecule, everything).grown(kWidestBridge);
    const auto enters = [&](const Atom& atom) { return near.holds(glm::vec3(image * glm::dvec4(atom.position, 1))); };
    if (std::none_of(molecule.atoms.begin(), molecule.atoms.end(), enters)) return {};
    const Molecule both = withImage(molecule, image);
    const Chemistry chemistry = withImage(kept_->chemistry);
    const auto count = static_cast<std::uint32_t>(molecule.atoms.size());
    std::vector<bool> second(everything.size(), false);
    second.insert(second.end(), everything.begin(), everything.end());
    AtomBox shared = near;
    shared.cut(boundingBox(both, second).grown(kWidestBridge));
    const Features features =
        featuresAround(withImage(kept_->features, kept_->chemistry), both, chemistry, shared.grown(5));
    const auto twice = [](std::vector<bool> values) {
        values.insert(values.end(), values.begin(), values.end());
        return values;
    };
    const std::vector<bool> others = findOthers(query);
    InteractionQuery doubled{twice(query.a), query.b.empty() ? query.b : twice(query.b), query.kinds};
    std::vector<Interaction> found;
    const std::vector<bool> othersTwice = twice(others);
    InteractionSearch search{both, chemistry, features, kept_->rules, doubled, othersTwice, false, false, found, count};
    run(search);
    for (Interaction& interaction : found) splitImage(interaction, count);
    return found;
}

}  // namespace nacre
