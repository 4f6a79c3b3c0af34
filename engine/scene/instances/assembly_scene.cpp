#include "engine/scene/instances/assembly_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "engine/error.h"
#include "engine/scene/color/colors.h"

namespace nacre {
namespace {

/// Calls visit(list, first, count) for runs of equal lists.
template <typename FindList, typename Visit>
void eachRun(std::size_t size, const FindList& findList, const Visit& visit) {
    for (std::size_t first = 0; first < size;) {
        const std::uint32_t list = findList(first);
        std::size_t end = first + 1;
        while (end < size && findList(end) == list) ++end;
        visit(list, first, end - first);
        first = end;
    }
}

/// Primitives with the same copies. `visitBalls(i, add)` calls add(centre, radius).
template <typename VisitBalls>
PrimitiveRun makeRun(std::uint32_t list, std::size_t first, std::size_t count, const VisitBalls& visitBalls) {
    const Bounds bounds = boundsOfEach([&](const auto& add) {
        for (std::size_t i = first; i < first + count; ++i) visitBalls(i, add);
    });
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count), list, bounds.center, bounds.radius};
}

template <typename T>
std::vector<T> inOrder(const std::vector<T>& values, const std::vector<std::uint32_t>& order) {
    std::vector<T> sorted;
    sorted.reserve(values.size());
    for (const std::uint32_t i : order) sorted.push_back(values[i]);
    return sorted;
}

/// A stable sort by list.
template <typename FindList>
std::vector<std::uint32_t> orderBy(std::size_t size, const FindList& findList) {
    std::vector<std::uint32_t> order(size);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return findList(a) < findList(b); });
    return order;
}

/// The palette of "copy" or "copy-chain:muted".
Palette parsePalette(std::string_view scheme) {
    const std::size_t colon = scheme.find(':');
    const auto named = colon == std::string_view::npos ? std::nullopt : paletteFromName(scheme.substr(colon + 1));
    return named.value_or(kChainPalette);
}

/// A transform of the file's frame, for points relative to a centre.
glm::dmat4x3 about(const glm::dmat4x3& transform, const glm::dvec3& center) {
    glm::dmat4x3 moved = transform;
    moved[3] = transform * glm::dvec4(center, 1.0) - center;
    return moved;
}

}  // namespace

AssemblyScene::AssemblyScene(const Molecule& molecule, const std::string& id)
    : molecule_(molecule), id_(id), placement_(placeAssembly(molecule, id)), lists_(placement_.lists) {}

std::uint32_t AssemblyScene::copyList(std::uint32_t atom) const {
    return placement_.listOfSubchain[molecule_.residues[molecule_.atoms[atom].residue].subchain];
}

std::uint32_t AssemblyScene::findCommonList(std::uint32_t atomA, std::uint32_t atomB) {
    const std::uint32_t a = copyList(atomA), b = copyList(atomB);
    if (a == b) return a;
    const auto [known, added] = common_.emplace(std::minmax(a, b), 0);
    if (added) known->second = lists_.common(a, b);
    return known->second;
}

std::span<const std::uint32_t> AssemblyScene::place(std::span<const std::uint32_t> atoms) {
    atoms_.clear();
    for (const std::uint32_t atom : atoms)
        if (copyList(atom) != Placement::kNowhere) atoms_.push_back(atom);
    if (atoms_.empty()) throw Error("cannot draw assembly", id_, "none of its atoms is drawn");
    return atoms_;
}

/// Orders copies so that those of equal colour are far apart.
void AssemblyScene::spread(std::size_t colors) {
    glm::dvec3 middle(0);
    for (const std::uint32_t atom : atoms_)
        middle += glm::dvec3(molecule_.atoms[atom].position) / static_cast<double>(atoms_.size());
    std::vector<glm::dvec3> centers;
    for (const glm::dmat4x3& transform : placement_.transforms) centers.push_back(transform * glm::dvec4(middle, 1.0));
    const std::vector<std::uint32_t> order = spreadCopies(centers, colors);
    placement_.transforms = inOrder(placement_.transforms, order);
    std::vector<std::uint32_t> places(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) places[order[i]] = i;
    for (std::vector<std::uint32_t>& list : placement_.lists) {
        for (std::uint32_t& copy : list) copy = places[copy];
        std::sort(list.begin(), list.end());
    }
    lists_.index();
}

void AssemblyScene::colorByCopy(Appearance& appearance) {
    if (!appearance.anyByCopy()) return;
    const std::size_t count = placement_.transforms.size();
    const auto tint = [](const std::vector<std::uint32_t>& tints, std::vector<std::uint32_t>& colors) {
        for (std::size_t i = 0; i < colors.size(); ++i)
            if (tints[i]) colors[i] = withSurfaceFrom(tints[i], colors[i]);
    };
    tint(appearance.tints, appearance.colors);
    for (MeshAtoms* mesh : {&appearance.cartoon, &appearance.surface}) tint(mesh->tints, mesh->colors);
    for (Legend& legend : appearance.legends) {
        if (!legend.scheme.starts_with(colorSchemeName(ColorScheme::copy))) continue;
        if (copyColors_.empty()) {
            const Palette palette = parsePalette(legend.scheme);
            // The palette's darker tones would look like tints.
            const std::size_t tones = legend.entries.size() > 1 ? 1 : 2;
            for (std::size_t i = 0; i < std::min({count, tones * kindCount(palette), kMostCopyColors}); ++i)
                copyColors_.push_back(kindColor(i, palette));
            if (count > copyColors_.size()) spread(copyColors_.size());
        }
        const std::vector<LegendEntry> kinds(legend.entries.begin() + 1, legend.entries.end());
        legend.entries.clear();
        for (std::size_t i = 0; i < copyColors_.size() && count <= copyColors_.size(); ++i)
            legend.entries.push_back({"copy " + std::to_string(i + 1), copyColors_[i]});
        if (count > copyColors_.size())
            legend.entries.push_back(
                {std::to_string(count) + " copies in " + std::to_string(copyColors_.size()) + " colours",
                 copyColors_.front()});
        legend.entries.insert(legend.entries.end(), kinds.begin(), kinds.end());
    }
}

void AssemblyScene::sortByCopies(Appearance& appearance) const {
    const auto order = orderBy(appearance.atoms.size(), [&](std::size_t i) { return copyList(appearance.atoms[i]); });
    appearance.atoms = inOrder(appearance.atoms, order);
    appearance.styles = inOrder(appearance.styles, order);
    appearance.colors = inOrder(appearance.colors, order);
    appearance.tints = inOrder(appearance.tints, order);
    appearance.opacity = inOrder(appearance.opacity, order);
}

void AssemblyScene::sortByCopies(std::vector<Bond>& bonds) {
    std::vector<std::uint32_t> lists;
    std::size_t kept = 0;
    for (const Bond& bond : bonds) {
        std::uint32_t list = findCommonList(bond.a, bond.b);
        if (list == Placement::kNowhere) continue;
        // An atom on a special position of a crystal occurs in fewer copies than its bonds.
        if (molecule_.file.format == "cif-core")
            for (const std::uint32_t atom : {bond.a, bond.b})
                if (placement_.lists[copyList(atom)].size() > placement_.lists[list].size()) list = copyList(atom);
        lists.push_back(list);
        bondsOfCopies_ += placement_.lists[list].size();
        bonds[kept++] = bond;
    }
    bonds.resize(kept);
    const auto order = orderBy(kept, [&](std::size_t i) { return lists[i]; });
    bonds = inOrder(bonds, order);
}

/// A water that bridges two atoms may occur in fewer copies; the line between the atoms decides.
void AssemblyScene::placeContacts(const ContactFinder& finder, const Appearance& appearance,
                                  std::vector<PlacedContact>& contacts, std::vector<std::string>& warnings) {
    for (PlacedContact& contact : contacts) {
        contact.list = findCommonList(contact.interaction.a.atoms.front(), contact.interaction.b.atoms.front());
        if (contact.list != Placement::kNowhere) contact.copy = placement_.lists[contact.list].front();
    }
    std::erase_if(contacts, [](const PlacedContact& contact) { return contact.list == Placement::kNowhere; });
    if (placement_.transforms.size() > 1) addBetweenCopies(finder, appearance, contacts, warnings);
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const PlacedContact& l, const PlacedContact& r) { return l.list < r.list; });
    listOfContact_.clear();
    for (const PlacedContact& contact : contacts) listOfContact_.push_back(contact.list);
}

void AssemblyScene::addBetweenCopies(const ContactFinder& finder, const Appearance& appearance,
                                     std::vector<PlacedContact>& contacts, std::vector<std::string>& warnings) {
    constexpr double kReach = 8.2;  // Å, of a water bridge
    std::vector<glm::dvec4> points;
    for (const std::uint32_t atom : atoms_) points.emplace_back(molecule_.atoms[atom].position, 0.0f);
    const auto relations = copyRelations(placement_.transforms, computeBounds(points), kReach);
    if (!relations) {
        warnings.push_back("interactions between copies are left out: more than " + std::to_string(kMostRelatedCopies) +
                           " copies, or more than " + std::to_string(kMostRelations) +
                           " ways in which two copies meet");
        return;
    }
    const auto stands = [&](std::uint32_t atom, std::uint32_t copy) {
        if (copyList(atom) == Placement::kNowhere) return false;
        const std::vector<std::uint32_t>& list = placement_.lists[copyList(atom)];
        return std::binary_search(list.begin(), list.end(), copy);
    };
    for (const CopyRelation& relation : *relations)
        for (PlacedContact& contact : finder.findBetween(molecule_, appearance, relation.image)) {
            const InteractionEnd &a = contact.interaction.a, &b = contact.interaction.b;
            const std::uint32_t here = (a.image ? b : a).atoms.front(), there = (a.image ? a : b).atoms.front();
            std::vector<std::uint32_t> list;
            for (const auto& [first, second] : relation.pairs)
                if (stands(here, first) && stands(there, second)) list.push_back(first);
            if (list.empty()) continue;
            std::sort(list.begin(), list.end());
            contact.copy = list.front();
            contact.list = lists_.add(std::move(list));
            contacts.push_back(std::move(contact));
        }
}

void AssemblyScene::eachCopy(std::uint32_t atomA, std::uint32_t atomB, const glm::dvec3& center,
                             const std::function<void(const glm::dmat4x3&, std::uint32_t)>& visit) {
    const std::uint32_t list = findCommonList(atomA, atomB);
    if (list == Placement::kNowhere) return;
    for (const std::uint32_t copy : placement_.lists[list]) visit(about(placement_.transforms[copy], center), copy);
}

std::uint32_t AssemblyScene::tintColor(std::uint32_t tint, std::uint32_t copy) const {
    return copyColors_.empty() ? tint : tintedColor(copyColors_[copy % copyColors_.size()], tint);
}

std::size_t AssemblyScene::countCopies(std::span<const std::uint32_t> atoms) const {
    std::size_t count = 0;
    for (const std::uint32_t atom : atoms) count += placement_.lists[copyList(atom)].size();
    return count;
}

void AssemblyScene::eachBall(const SeenBalls& seen, const std::function<void(const glm::dvec3&, double)>& visit) const {
    eachRun(
        seen.balls.size(), [&](std::size_t i) { return copyList(seen.atoms[i]); },
        [&](std::uint32_t list, std::size_t first, std::size_t count) {
            for (const std::uint32_t copy : placement_.lists[list]) {
                const glm::dmat4x3& transform = placement_.transforms[copy];
                for (const glm::dvec4& ball : std::span(seen.balls).subspan(first, count))
                    visit(transform * glm::dvec4(glm::dvec3(ball), 1.0), ball.w);
            }
        });
}

Bounds AssemblyScene::bounds(const SeenBalls& seen, const std::optional<glm::dvec3>& about) const {
    constexpr std::uint64_t kMany = 100'000'000;
    if (seen.balls.size() * std::uint64_t{placement_.transforms.size()} > kMany)
        return movedTo(about, roughBounds(seen));
    return boundsOfEach([&](const auto& visit) { eachBall(seen, visit); }, about);
}

/// Bounds from one ball per set of copies: at most the ball's radius too large.
Bounds AssemblyScene::roughBounds(const SeenBalls& seen) const {
    std::vector<std::pair<Bounds, std::uint32_t>> parts;
    eachRun(
        seen.balls.size(), [&](std::size_t i) { return copyList(seen.atoms[i]); },
        [&](std::uint32_t list, std::size_t first, std::size_t count) {
            parts.emplace_back(computeBounds(std::span(seen.balls).subspan(first, count)), list);
        });
    return boundsOfEach([&](const auto& visit) {
        for (const auto& [ball, list] : parts)
            for (const std::uint32_t copy : placement_.lists[list])
                visit(placement_.transforms[copy] * glm::dvec4(ball.center, 1.0), ball.radius);
    });
}

void AssemblyScene::checkNumber(std::size_t primitives) const {
    // Every primitive of every copy needs a number (shaders/identify.frag); 0 means none.
    if (std::uint64_t{primitives} * placement_.transforms.size() < UINT32_MAX) return;
    throw Error("cannot draw assembly", id_,
                std::to_string(placement_.transforms.size()) + " copies of " + std::to_string(primitives) +
                    " spheres, sticks and triangles are more than " + std::to_string(UINT32_MAX - 1));
}

/// Levels replace meshes whose parts have the same copies: meshes with differing copies, such as a bond between two
/// chains, have none.
void AssemblyScene::keepWholeMeshes(Representation& r) {
    const std::vector<PrimitiveRun>& runs = r.copies.triangles;
    for (MeshRun& mesh : r.meshes) {
        const bool whole = std::any_of(runs.begin(), runs.end(), [&](const PrimitiveRun& run) {
            return run.first <= mesh.first && mesh.first + mesh.count <= run.first + run.count;
        });
        if (whole) continue;
        mesh.levels.clear();
        mesh.closed = false;
    }
}

void AssemblyScene::finish(Representation& r) {
    const std::size_t others = r.cylinders.size() + r.wires.size() + r.triangles.size() + r.coarseTriangles.size();
    if (others > 0) checkNumber(r.spheres.size() + others);  // spheres alone are drawn by levels (sphere_levels.h)
    Copies& copies = r.copies;
    const auto listOfLook = [&](std::uint32_t a, std::uint32_t b) {
        return r.findContact(a) ? listOfContact_[a - r.firstContact] : findCommonList(a - 1, b - 1);
    };
    eachRun(
        r.spheres.size(), [&](std::size_t i) { return listOfLook(r.sphereLooks[i].atom, r.sphereLooks[i].atom); },
        [&](std::uint32_t list, std::size_t first, std::size_t count) {
            copies.spheres.push_back(makeRun(list, first, count, [&](std::size_t i, const auto& add) {
                add(r.spheres[i].center, r.spheres[i].radius);
            }));
        });
    eachRun(
        r.cylinders.size(),
        [&](std::size_t i) { return listOfLook(r.cylinderLooks[i].atomA, r.cylinderLooks[i].atomB); },
        [&](std::uint32_t list, std::size_t first, std::size_t count) {
            copies.cylinders.push_back(makeRun(list, first, count, [&](std::size_t i, const auto& add) {
                add(r.cylinders[i].a, r.cylinders[i].radius);
                add(r.cylinders[i].b, r.cylinders[i].radius);
            }));
        });
    eachRun(
        r.triangles.size(),
        [&](std::size_t i) { return copyList(r.meshLooks[r.meshVertices[r.triangles[i].a].look].atom - 1); },
        [&](std::uint32_t list, std::size_t first, std::size_t count) {
            copies.triangles.push_back(makeRun(list, first, count, [&](std::size_t i, const auto& add) {
                const Triangle& t = r.triangles[i];
                for (const std::uint32_t v : {t.a, t.b, t.c}) add(decodePosition(r.meshVertices[v], t.step()), 0.0f);
            }));
        });
    keepWholeMeshes(r);
    // Moves instead of copying: millions of transforms are never in memory twice.
    for (glm::dmat4x3& transform : placement_.transforms) transform = about(transform, r.center);
    copies.transforms = std::move(placement_.transforms);
    copies.lists = std::move(placement_.lists);
    copies.colors = copyColors_;
    r.drawnBonds = bondsOfCopies_;
}

}  // namespace nacre
