#include "engine/mesh/cartoon_bases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "engine/mesh/cartoon_trace.h"
#include "engine/mesh/solids.h"
#include "engine/mesh/unit_vectors.h"

namespace nacre {
namespace {

constexpr double kRungRadius = 0.25;         // Å
constexpr double kPlateHalfThickness = 0.2;  // Å
constexpr double kPlateMargin = 0.15;        // Å, by which a plate is larger than its ring of atoms
constexpr double kDisulfideRadius = 0.2;     // Å
constexpr double kLongestRingBond = 2.5;     // Å
constexpr double kLeastRingBond = 0.5;       // Å
constexpr double kFarthestBase = 15;         // Å, of a base from its ribbon
constexpr Element kSulfur = 16;

enum BaseAtom {
    kBaseN1,
    kBaseC2,
    kBaseN3,
    kBaseC4,
    kBaseN9,
    kBaseC8,
    kBaseN7,
    kBaseC5,
    kBaseC6,
    kSugarC1,
    kSugarC2,
    kSugarC3,
    kSugarC4,
    kSugarO4,
    kBaseAtoms
};
constexpr std::array<std::string_view, kBaseAtoms> kBaseNames{"N1", "C2", "N3",  "C4",  "N9",  "C8",  "N7",
                                                              "C5", "C6", "C1'", "C2'", "C3'", "C4'", "O4'"};

/// A plate: atoms around one ring or two fused ones, and these rings by place in the outline.
struct RingPlate {
    std::vector<BaseAtom> outline;
    std::vector<std::vector<std::uint32_t>> rings;
    BaseAtom owner;
};
const RingPlate kPurine{{kBaseN1, kBaseC2, kBaseN3, kBaseC4, kBaseN9, kBaseC8, kBaseN7, kBaseC5, kBaseC6},
                        {{3, 7, 8, 0, 1, 2}, {3, 4, 5, 6, 7}},
                        kBaseC4};
const RingPlate kPyrimidine{{kBaseN1, kBaseC2, kBaseN3, kBaseC4, kBaseC5, kBaseC6}, {{0, 1, 2, 3, 4, 5}}, kBaseC4};
const RingPlate kSugar{{kSugarC1, kSugarC2, kSugarC3, kSugarC4, kSugarO4}, {{0, 1, 2, 3, 4}}, kSugarC1};

/// Atoms of a residue position in the drawn conformer, by name.
struct Base {
    std::array<std::uint32_t, kBaseAtoms> atoms{};
    bool has(BaseAtom name) const { return atoms[name] != kNoAtom; }
};

/// Index in `places` of the residue position of each atom record; places.size() if it has none.
class PlaceOfAtom {
public:
    PlaceOfAtom(const ResidueFacts& facts, std::span<const RibbonPlace> places)
        : molecule_(facts.molecule()), positions_(facts.positions()), places_(places) {}

    std::size_t operator()(std::uint32_t atom) const {
        const std::uint32_t residue = positions_[molecule_.atoms[atom].residue];
        const auto found = std::lower_bound(places_.begin(), places_.end(), residue,
                                            [](const RibbonPlace& p, std::uint32_t r) { return p.residue < r; });
        const bool there = found != places_.end() && found->residue == residue;
        return there ? static_cast<std::size_t>(found - places_.begin()) : places_.size();
    }

private:
    const Molecule& molecule_;
    const std::vector<std::uint32_t>& positions_;
    std::span<const RibbonPlace> places_;
};

bool finitePlace(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

std::vector<Base> findBases(const ResidueFacts& facts, std::span<const RibbonPlace> places) {
    const Molecule& molecule = facts.molecule();
    std::vector<Base> bases(places.size());
    for (Base& base : bases) base.atoms.fill(kNoAtom);
    const PlaceOfAtom findPlace(facts, places);
    for (const std::uint32_t index : facts.conformer()) {
        const Atom& atom = molecule.atoms[index];
        Name name = atom.name;
        std::replace(name.bytes.begin(), name.bytes.end(), '*', '\'');
        const auto found = std::find(kBaseNames.begin(), kBaseNames.end(), name.view());
        if (found == kBaseNames.end() || !finitePlace(atom.position)) continue;
        const std::size_t place = findPlace(index);
        if (place == places.size()) continue;
        std::uint32_t& slot = bases[place].atoms[static_cast<std::size_t>(found - kBaseNames.begin())];
        if (slot == kNoAtom) slot = index;
    }
    return bases;
}

class BaseDrawer {
public:
    BaseDrawer(Mesh& mesh, const Molecule& molecule, const CartoonOptions& options, const glm::dvec3& origin)
        : mesh_(mesh), molecule_(molecule), options_(options), origin_(origin) {}

    void draw(const Base& base, const RibbonPlace& ribbon) {
        const bool purine = base.has(kBaseN9);
        // Pseudouridine is attached by its C5.
        const BaseAtom root = purine ? kBaseN9 : nearestToSugar(base);
        const BaseAtom end = purine ? kBaseN1 : kBaseN3;
        const glm::dvec3 from = ribbon.place - origin_;
        const bool plates = options_.bases == BaseForm::plates || options_.bases == BaseForm::rings;
        if (plates && base.has(kSugarC1) && plate(base, purine ? kPurine : kPyrimidine)) {
            const bool sugar = options_.bases == BaseForm::rings && plate(base, kSugar);
            rod(from, sugar ? nearestOfSugar(base, from) : kSugarC1, base);
            addRod(mesh_, place(base, kSugarC1), place(base, root), kRungRadius * options_.scale, base.atoms[kSugarC1],
                   base.atoms[kSugarC1], options_.sides);
            return;
        }
        for (const BaseAtom name : {end, root, kSugarC1})
            if (base.has(name)) return rod(from, name, base);
    }

private:
    glm::dvec3 place(const Base& base, BaseAtom name) const {
        return glm::dvec3(molecule_.atoms[base.atoms[name]].position) - origin_;
    }

    BaseAtom nearestToSugar(const Base& base) const {
        if (!base.has(kSugarC1) || !base.has(kBaseC5) || !base.has(kBaseN1)) return kBaseN1;
        const glm::dvec3 sugar = place(base, kSugarC1);
        return glm::distance(place(base, kBaseC5), sugar) < glm::distance(place(base, kBaseN1), sugar) ? kBaseC5
                                                                                                       : kBaseN1;
    }

    /// The backbone carbon of a sugar's ring that is nearer to the ribbon.
    BaseAtom nearestOfSugar(const Base& base, const glm::dvec3& ribbon) const {
        return glm::distance(place(base, kSugarC3), ribbon) < glm::distance(place(base, kSugarC4), ribbon) ? kSugarC3
                                                                                                           : kSugarC4;
    }

    void rod(const glm::dvec3& from, BaseAtom to, const Base& base) {
        if (glm::distance(from, place(base, to)) > kFarthestBase) return;
        addRod(mesh_, from, place(base, to), kRungRadius * options_.scale, base.atoms[to], base.atoms[to],
               options_.sides);
    }

    /// False if an atom is missing or the outline is no ring. Puckered rings are drawn in their mean plane.
    bool plate(const Base& base, const RingPlate& ring) {
        std::vector<glm::dvec3> outline;
        for (const BaseAtom name : ring.outline) {
            if (!base.has(name)) return false;
            outline.push_back(place(base, name));
        }
        glm::dvec3 area{}, middle{};
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const glm::dvec3 &a = outline[i], &b = outline[(i + 1) % outline.size()];
            const double bond = glm::distance(a, b);
            if (bond < kLeastRingBond || bond > kLongestRingBond) return false;
            area += glm::cross(a - outline[0], b - outline[0]) / 2.0;
            middle += a / static_cast<double>(outline.size());
        }
        const glm::dvec3 normal = unitOr(area, {});
        if (glm::length(area) < 2) return false;  // a benzene ring has 5.1 Å^2
        for (glm::dvec3& p : outline) p = middle + across(p - middle, normal) * (1 + kPlateMargin / 1.4);
        addPlate(mesh_, outline, normal, kPlateHalfThickness * options_.scale, ring.rings, base.atoms[ring.owner]);
        return true;
    }

    Mesh& mesh_;
    const Molecule& molecule_;
    const CartoonOptions& options_;
    glm::dvec3 origin_;
};

}  // namespace

void addBases(Mesh& mesh, const ResidueFacts& facts, std::span<const RibbonPlace> places, const CartoonOptions& options,
              const glm::dvec3& origin) {
    if (options.bases == BaseForm::none || places.empty()) return;
    const std::vector<Base> bases = findBases(facts, places);
    BaseDrawer drawer(mesh, facts.molecule(), options, origin);
    for (std::size_t i = 0; i < places.size(); ++i) drawer.draw(bases[i], places[i]);
}

void addDisulfides(Mesh& mesh, const ResidueFacts& facts, std::span<const RibbonPlace> places,
                   const CartoonOptions& options, const glm::dvec3& origin) {
    const Molecule& molecule = facts.molecule();
    if (places.empty()) return;
    const PlaceOfAtom findPlace(facts, places);
    std::vector<std::uint32_t> betas;  // CB of each place, looked up at the first bridge
    for (const Bond& bond : molecule.bonds) {
        const Atom &a = molecule.atoms[bond.a], &b = molecule.atoms[bond.b];
        if (a.element != kSulfur || b.element != kSulfur || !finitePlace(a.position) || !finitePlace(b.position))
            continue;
        const std::size_t placeA = findPlace(bond.a), placeB = findPlace(bond.b);
        if (placeA == places.size() || placeB == places.size() || placeA == placeB) continue;
        if (betas.empty()) {
            betas.assign(places.size(), kNoAtom);
            for (const std::uint32_t index : facts.conformer())
                if (molecule.atoms[index].name == Name("CB") && finitePlace(molecule.atoms[index].position))
                    if (const std::size_t place = findPlace(index); place != places.size()) betas[place] = index;
        }
        const auto at = [&](std::uint32_t atom) { return glm::dvec3(molecule.atoms[atom].position) - origin; };
        const double radius = kDisulfideRadius * options.scale;
        addRod(mesh, at(bond.a), at(bond.b), radius, bond.a, bond.b, options.sides);
        for (const auto& [sulfur, place] : {std::pair{bond.a, placeA}, std::pair{bond.b, placeB}}) {
            const glm::dvec3 ribbon = places[place].place - origin;
            const std::uint32_t beta = betas[place];
            if (beta == kNoAtom) {
                addRod(mesh, at(sulfur), ribbon, radius, sulfur, sulfur, options.sides);
                continue;
            }
            addRod(mesh, at(sulfur), at(beta), radius, sulfur, beta, options.sides);
            addRod(mesh, at(beta), ribbon, radius, beta, beta, options.sides);
        }
    }
}

}  // namespace nacre
