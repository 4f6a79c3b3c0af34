#include "engine/scene/build/bond_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <utility>

#include "engine/molecule/element.h"
#include "engine/scene/build/atom_ellipsoids.h"
#include "engine/scene/build/bond_cylinders.h"

namespace nacre {
namespace {

constexpr std::uint8_t kTraceBond = 200;  // Bond::order of a piece of a backbone, which is no bond
constexpr double kShortestBond = 1e-3;    // Å; below it the ends coincide and there is no direction to draw
constexpr std::uint32_t kNotDrawn = std::numeric_limits<std::uint32_t>::max();

/// Position of each atom in the list of drawn ones, or kNotDrawn.
std::vector<std::uint32_t> drawnSlots(const Molecule& molecule, std::span<const std::uint32_t> drawn) {
    std::vector<std::uint32_t> slots(molecule.atoms.size(), kNotDrawn);
    for (std::size_t i = 0; i < drawn.size(); ++i) slots[drawn[i]] = static_cast<std::uint32_t>(i);
    return slots;
}

glm::dvec3 between(const Molecule& molecule, std::uint32_t a, std::uint32_t b) {
    return glm::dvec3(molecule.atoms[b].position) - glm::dvec3(molecule.atoms[a].position);
}

/// Surroundings of each atom: its first four bonded neighbours (a flat atom has at most three), and those by aromatic
/// or delocalised bonds.
struct Surroundings {
    struct Neighbours {
        std::array<std::uint32_t, 4> atoms;
        std::uint32_t count = 0;

        void add(std::uint32_t other) {
            if (count < atoms.size()) atoms[count++] = other;
        }
        std::span<const std::uint32_t> all() const { return {atoms.data(), count}; }
    };
    std::vector<Neighbours> bonded, shared;

    Surroundings(const Molecule& molecule, std::span<const Bond> bonds)
        : bonded(molecule.atoms.size()), shared(molecule.atoms.size()) {
        for (const Bond& bond : bonds)
            for (const auto& [atom, other] : {std::pair(bond.a, bond.b), std::pair(bond.b, bond.a)}) {
                bonded[atom].add(other);
                if (bond.order >= 4) shared[atom].add(other);
            }
    }
};

glm::dvec3 findMiddle(const Molecule& molecule, std::span<const std::uint32_t> atoms) {
    glm::dvec3 sum(0);
    for (const std::uint32_t atom : atoms) sum += glm::dvec3(molecule.atoms[atom].position);
    return sum / static_cast<double>(atoms.size());
}

Style stouter(Style a, Style b) {
    for (const Style style : {Style::licorice, Style::ballAndStick, Style::ellipsoids})
        if (a == style || b == style) return style;
    return a;
}

BondStrands makeStrands(std::uint8_t order, bool inRing, Style style, const Sizes& sizes) {
    constexpr Sizes kUsual;
    constexpr double kThin = 0.4;  // relative to bonds in ball-and-stick
    if (style == Style::ellipsoids) return scaled(bondStrands(1, false), kThin * sizes.bond / kUsual.bond);
    return style == Style::ballAndStick ? scaled(bondStrands(order, inRing), sizes.bond / kUsual.bond)
                                        : scaled(licoriceStrands(order, inRing), sizes.stick / kUsual.stick);
}

bool hasSticks(Style style) {
    return style == Style::licorice || style == Style::ballAndStick || style == Style::ellipsoids;
}

/// Whether a bond is coordination: it joins a metal and a non-metal, whatever order a file gives it.
bool isCoordination(const Molecule& molecule, const Bond& bond) {
    return isMetal(molecule.atoms[bond.a].element) != isMetal(molecule.atoms[bond.b].element);
}

/// Å from an atom along a bond to the bond's end in a cut ellipsoid.
using FindBondEnd = std::function<double(std::uint32_t atom, const glm::dvec3& way)>;

/// A bond's dashes, each in the colour of the nearer atom.
void appendCoordination(const Sphere& a, const Sphere& b, const SphereLook& lookA, const SphereLook& lookB,
                        Representation& result) {
    const glm::dvec3 way = glm::dvec3(b.center) - glm::dvec3(a.center);
    const double length = glm::length(way);
    const Dashes dashes = bondDashes(length, static_cast<double>(a.radius), static_cast<double>(b.radius));
    for (int i = 0; i < dashes.count; ++i) {
        const double from = dashes.first + 2 * i * dashes.length;
        const auto at = [&](double distance) { return glm::vec3(glm::dvec3(a.center) + way * (distance / length)); };
        result.cylinders.push_back({at(from), kDashRadius, at(from + dashes.length), 0.0f});
        const SphereLook& first = 2 * i + 1 <= dashes.count ? lookA : lookB;
        const SphereLook& second = 2 * i + 1 < dashes.count ? lookA : lookB;
        result.cylinderLooks.push_back({first.color, second.color, first.atom, second.atom});
    }
}

class BondDrawing {
public:
    BondDrawing(const Molecule& molecule, const DrawnOrders& orders, std::span<const Bond> bonds,
                std::span<const std::uint32_t> slots, AromaticForm aromatic, const Sizes& sizes, FindBondEnd findEnd,
                Representation& result)
        : molecule_(molecule),
          orders_(orders),
          around_(molecule, bonds),
          slots_(slots),
          aromatic_(aromatic),
          sizes_(sizes),
          findEnd_(std::move(findEnd)),
          result_(result) {}

    void add(const Bond& bond, Style style) {
        const glm::dvec3 way = between(molecule_, bond.a, bond.b);
        const double length = glm::length(way);
        const glm::dvec3 axis = way / length, start = at(bond.a);
        const bool inRing = !orders_.findRing(bond.a, bond.b).empty();
        const BondStrands strands = makeStrands(bond.order, inRing, style, sizes_);
        const bool sideless = strands.count == 1 && strands.inner.radius <= 0;
        const glm::dvec3 side = sideless ? glm::dvec3(0) : strandSide(bond, axis);
        const SphereLook &lookA = look(bond.a), &lookB = look(bond.b);
        const double endA = findEnd_(bond.a, axis), endB = findEnd_(bond.b, -axis);
        const bool apart = endA + endB < 0.9 * length;
        const glm::dvec3 trimA = axis * (apart ? endA : 0), trimB = axis * (apart ? endB : 0);
        for (int i = 0; i < strands.count; ++i) {
            const auto& strand = strands.strands[static_cast<std::size_t>(i)];
            const glm::dvec3 from = start + side * static_cast<double>(strand.offset);
            result_.cylinders.push_back({glm::vec3(from + trimA), strand.radius, glm::vec3(from + way - trimB), 0.0f});
            result_.cylinderLooks.push_back({lookA.color, lookB.color, lookA.atom, lookB.atom});
        }
        if (strands.inner.radius > 0 && !(bond.order == 4 && aromatic_ == AromaticForm::ring && inRing))
            addInner(bond, strands.inner, axis, side);
    }

    /// A bond of a metal.
    void addCoordination(const Bond& bond) {
        Sphere a = result_.spheres[slots_[bond.a]], b = result_.spheres[slots_[bond.b]];
        const glm::dvec3 axis = glm::normalize(between(molecule_, bond.a, bond.b));
        a.radius = static_cast<float>(std::max(ballRadius(bond.a), findEnd_(bond.a, axis)));
        b.radius = static_cast<float>(std::max(ballRadius(bond.b), findEnd_(bond.b, -axis)));
        appendCoordination(a, b, look(bond.a), look(bond.b), result_);
    }

    /// A piece of a backbone.
    void addTrace(const Bond& bond) {
        const SphereLook &lookA = look(bond.a), &lookB = look(bond.b);
        result_.cylinders.push_back(
            {glm::vec3(at(bond.a)), static_cast<float>(sizes_.tube), glm::vec3(at(bond.b)), 0.0f});
        result_.cylinderLooks.push_back({lookA.color, lookB.color, lookA.atom, lookB.atom});
    }

    /// A circle within a ring, each piece in the look of the nearest atom.
    void addCircle(std::span<const std::uint32_t> ring, float radius) {
        constexpr int kPieces = 24;
        constexpr double kShare = 0.57;  // of the ring's own radius
        const glm::dvec3 middle = findMiddle(molecule_, ring);
        glm::dvec3 normal(0);
        double reach = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec3 arm = glm::dvec3(molecule_.atoms[ring[i]].position) - middle;
            normal += glm::cross(arm, glm::dvec3(molecule_.atoms[ring[(i + 1) % ring.size()]].position) - middle);
            reach += glm::length(arm) / static_cast<double>(ring.size());
        }
        if (glm::length(normal) < 1e-6) return;
        const glm::dvec3 u = bondSide(glm::normalize(normal), between(molecule_, ring[1], ring[0]));
        const glm::dvec3 v = glm::cross(glm::normalize(normal), u);
        const auto point = [&](int i) {
            const double angle = 2 * 3.14159265358979 * i / kPieces;
            return middle - result_.center + kShare * reach * (u * std::cos(angle) + v * std::sin(angle));
        };
        for (int i = 0; i < kPieces; ++i) {
            const glm::dvec3 a = point(i), b = point(i + 1), half = (a + b) / 2.0;
            const std::uint32_t atom = *std::ranges::min_element(ring, [&](std::uint32_t l, std::uint32_t r) {
                return glm::distance(at(l), half) < glm::distance(at(r), half);
            });
            const SphereLook& seen = look(atom);
            result_.spheres.push_back({glm::vec3(a), radius});
            result_.sphereLooks.push_back(seen);
            result_.cylinders.push_back({glm::vec3(a), radius, glm::vec3(b), 0.0f});
            result_.cylinderLooks.push_back({seen.color, seen.color, seen.atom, seen.atom});
        }
    }

private:
    glm::dvec3 at(std::uint32_t atom) const { return glm::dvec3(molecule_.atoms[atom].position) - result_.center; }
    SphereLook look(std::uint32_t atom) const { return result_.sphereLooks[slots_[atom]]; }
    /// Of a ball that an atom fills, Å.
    double ballRadius(std::uint32_t atom) const { return static_cast<double>(result_.ballRadius(slots_[atom])); }

    /// Side of a bond for its inner line or second strand: into its ring; for a delocalised bond towards the atom that
    /// shares its electrons; else towards the neighbour farthest off the axis. One neighbour decides, since those of a
    /// flat atom cancel in a sum.
    glm::dvec3 strandSide(const Bond& bond, const glm::dvec3& axis) const {
        const auto across = [&](const glm::dvec3& way) { return way - axis * glm::dot(axis, way); };
        if (const auto ring = orders_.findRing(bond.a, bond.b); !ring.empty()) {
            const glm::dvec3 inside = across(findMiddle(molecule_, ring) - result_.center - at(bond.a));
            if (glm::length(inside) > 1e-2) return bondSide(axis, inside);
        }
        glm::dvec3 sum(0), best(0);
        for (const auto& [end, other] : {std::pair(bond.a, bond.b), std::pair(bond.b, bond.a)}) {
            if (bond.order >= 4)
                for (const std::uint32_t next : around_.shared[end].all())
                    if (next != other) sum += across(between(molecule_, end, next));
            for (const std::uint32_t next : around_.bonded[end].all()) {
                const glm::dvec3 way = across(between(molecule_, end, next));
                if (glm::length(way) > glm::length(best)) best = way;
            }
        }
        return bondSide(axis, glm::length(sum) > 1e-2 ? sum : best);
    }

    /// The line beside a bond. It is shorter: like the side of a smaller ring, and from ball to ball. Three dashes, for
    /// any length, or one.
    void addInner(const Bond& bond, const BondStrands::Strand& strand, const glm::dvec3& axis, const glm::dvec3& side) {
        const double offset = static_cast<double>(strand.offset), radius = static_cast<double>(strand.radius);
        const glm::dvec3 a = at(bond.a), b = at(bond.b);
        const double length = glm::distance(a, b);
        constexpr double kFlatAngle = 0.577;  // tan 30°: overlap of two lines at 120°
        double trim = kFlatAngle * offset;
        if (const auto ring = orders_.findRing(bond.a, bond.b); !ring.empty()) {
            const double inside = glm::dot(findMiddle(molecule_, ring) - result_.center - a, side);
            if (inside > offset) trim = length / 2 * offset / inside;
        }
        const auto covered = [&](std::uint32_t atom) {
            if (result_.cutsOctants && result_.ellipsoid(slots_[atom])) return 0.0;  // the cut shows its centre
            const double ball = ballRadius(atom);
            return ball > offset ? std::sqrt(ball * ball - offset * offset) : 0.0;
        };
        const double fromA = std::max(trim, covered(bond.a)), fromB = std::max(trim, covered(bond.b));
        if (fromA + fromB > 0.9 * length) return;
        DashedLine line{a + side * offset + axis * fromA, b + side * offset - axis * fromB, radius};
        line.look = {look(bond.a).color, look(bond.a).atom};
        line.lookB = LineLook{look(bond.b).color, look(bond.b).atom};
        if (bond.order == 2) return appendCapsule(line, result_);
        const double third = glm::distance(line.a, line.b) / 3;
        line.pattern = {{0.64 * third, 0.36 * third, 0, 0}};
        appendDashes(line, result_);
    }

    const Molecule& molecule_;
    const DrawnOrders& orders_;
    Surroundings around_;
    std::span<const std::uint32_t> slots_;
    AromaticForm aromatic_;
    Sizes sizes_;
    FindBondEnd findEnd_;
    Representation& result_;
};

/// Coordination drawn as the dashes of an interaction.
std::set<std::pair<std::uint32_t, std::uint32_t>> drawnMetals(std::span<const PlacedContact> contacts) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const auto& [contact, list, copy, image] : contacts)
        if (contact.kind == InteractionKind::metal && !image)
            pairs.insert(std::minmax(contact.a.atoms.front(), contact.b.atoms.front()));
    return pairs;
}

/// Bonds that are drawn, with their orders: both atoms are seen and do not coincide, and either has a style with bonds.
std::vector<Bond> drawnBonds(const Molecule& molecule, const Appearance& appearance, const DrawnOrders& orders,
                             std::span<const PlacedContact> contacts, std::span<const std::uint32_t> slots) {
    const auto metals = drawnMetals(contacts);
    std::vector<Bond> bonds;
    for (std::size_t i = 0; i < molecule.bonds.size(); ++i) {
        Bond bond = molecule.bonds[i];
        if (slots[bond.a] == kNotDrawn || slots[bond.b] == kNotDrawn || metals.contains({bond.a, bond.b})) continue;
        if (!(glm::length(between(molecule, bond.a, bond.b)) > kShortestBond)) continue;
        const Style style = stouter(appearance.styles[slots[bond.a]], appearance.styles[slots[bond.b]]);
        bond.order = orders.drawnOrder(i, style);
        bonds.push_back(bond);
    }
    return bonds;
}

/// Adds the tubes between neighbours in a backbone.
void addTraces(const ResidueFacts& facts, const Appearance& appearance, std::span<const std::uint32_t> slots,
               std::vector<Bond>& bonds) {
    const auto drawn = [&](std::uint32_t atom) {
        return slots[atom] != kNotDrawn && appearance.styles[slots[atom]] == Style::backbone;
    };
    for (const GuideTrace& trace : guideTraces(facts))
        for (std::size_t i = 1; i < trace.atoms.size(); ++i)
            if (drawn(trace.atoms[i - 1]) && drawn(trace.atoms[i]))
                bonds.push_back({trace.atoms[i - 1], trace.atoms[i], kTraceBond, BondSource::distance});
}

}  // namespace

void addBonds(const ResidueFacts& facts, const Appearance& appearance, const DrawnOrders& orders,
              std::span<const PlacedContact> contacts, AssemblyScene* assembly, Representation& result) {
    const Molecule& molecule = facts.molecule();
    const std::vector<Style>& styles = appearance.styles;
    const auto has = [&](Style style) { return std::find(styles.begin(), styles.end(), style) != styles.end(); };
    if (std::ranges::none_of(styles, hasSticks) && !has(Style::backbone)) return;
    const std::vector<std::uint32_t> slots = drawnSlots(molecule, appearance.atoms);
    const auto chooseStyle = [&](std::uint32_t a, std::uint32_t b) {
        return stouter(styles[slots[a]], styles[slots[b]]);
    };
    std::vector<Bond> bonds = drawnBonds(molecule, appearance, orders, contacts, slots);
    const AtomEllipsoids ellipsoids(molecule, appearance.sizes.probability);
    const auto findEnd = [&](std::uint32_t atom, const glm::dvec3& way) {
        const bool cut = appearance.cutsOctants && styles[slots[atom]] == Style::ellipsoids;
        return cut ? ellipsoids.bondEnd(atom, way) : 0.0;
    };
    BondDrawing drawing(molecule, orders, bonds, slots, orders.form(), appearance.sizes, findEnd, result);
    std::erase_if(bonds, [&](const Bond& bond) { return !hasSticks(chooseStyle(bond.a, bond.b)); });
    if (has(Style::backbone)) addTraces(facts, appearance, slots, bonds);
    if (assembly) assembly->sortByCopies(bonds);
    for (const Bond& bond : bonds) {
        ++result.drawnBonds;
        if (bond.order == kTraceBond)
            drawing.addTrace(bond);
        else if (isCoordination(molecule, bond))
            drawing.addCoordination(bond);
        else
            drawing.add(bond, chooseStyle(bond.a, bond.b));
    }
    if (orders.form() != AromaticForm::ring) return;
    for (const DrawnOrders::DrawnRing& ring : orders.rings()) {
        const auto seen = [&](std::uint32_t atom) {
            return slots[atom] != kNotDrawn && hasSticks(styles[slots[atom]]) &&
                   styles[slots[atom]] != Style::ellipsoids;
        };
        if (!ring.aromatic || !std::all_of(ring.atoms.begin(), ring.atoms.end(), seen)) continue;
        const Style style = chooseStyle(ring.atoms[0], ring.atoms[1]);
        const BondStrands strands = makeStrands(4, true, style, appearance.sizes);
        drawing.addCircle(ring.atoms, strands.inner.radius);
    }
}

}  // namespace nacre
