#include "engine/scene/view/uncover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

#include "engine/molecule/disjoint_sets.h"
#include "engine/scene/build/translucency.h"
#include "engine/scene/view/bounds.h"
#include "engine/scene/view/part_picture.h"

namespace nacre {
namespace {

/// Primitives of a scene in view space.
class Placed {
public:
    Placed(const Representation& scene, const View& view) : scene_(scene), rotation_(view.rotation) {}

    /// Calls visit(index, transform) for all primitives of a kind, or those of their first copy.
    template <typename Visit>
    void each(const std::vector<PrimitiveRun>& runs, std::size_t count, bool first, const Visit& visit) const {
        if (scene_.copies.transforms.empty()) {
            for (std::size_t i = 0; i < count; ++i) visit(i, glm::dmat4x3(1.0));
            return;
        }
        for (const PrimitiveRun& run : runs)
            for (const std::uint32_t copy : scene_.copies.lists[run.list]) {
                for (std::size_t i = run.first; i < std::size_t{run.first} + run.count; ++i)
                    visit(i, scene_.copies.transforms[copy]);
                if (first) break;
            }
    }
    template <typename Visit>
    void eachSphere(bool first, const Visit& visit) const {
        each(scene_.copies.spheres, scene_.spheres.size(), first, [&](std::size_t i, const glm::dmat4x3& place) {
            visit(i, at(place, scene_.spheres[i].center), static_cast<double>(scene_.spheres[i].radius));
        });
    }
    /// Visits sticks as strings of balls.
    template <typename Visit>
    void eachStick(bool first, const Visit& visit) const {
        each(scene_.copies.cylinders, scene_.cylinders.size(), first, [&](std::size_t i, const glm::dmat4x3& place) {
            const Cylinder& c = scene_.cylinders[i];
            const glm::dvec3 a = at(place, c.a), b = at(place, c.b);
            const int steps =
                std::max(1, static_cast<int>(std::ceil(glm::distance(a, b) / static_cast<double>(c.radius))));
            for (int step = 0; step <= steps; ++step)
                visit(i, glm::mix(a, b, static_cast<double>(step) / steps), static_cast<double>(c.radius));
        });
    }
    template <typename Visit>
    void eachTriangle(bool first, const Visit& visit) const {
        each(scene_.copies.triangles, scene_.triangles.size(), first, [&](std::size_t i, const glm::dmat4x3& place) {
            const Triangle& t = scene_.triangles[i];
            const auto corner = [&](std::uint32_t v) {
                return at(place, decodePosition(scene_.meshVertices[v], t.step()));
            };
            visit(i, std::array{corner(t.a), corner(t.b), corner(t.c)});
        });
    }

private:
    glm::dvec3 at(const glm::dmat4x3& place, const glm::vec3& p) const {
        return rotation_ * (place * glm::dvec4(p, 1.0));
    }

    const Representation& scene_;
    glm::dmat3 rotation_;
};

/// The part's primitives, those that cover it, and those to be removed.
class Covers {
public:
    Covers(const Representation& scene, const std::vector<bool>& chosen)
        : scene_(scene), chosen_(chosen), through_(!translucentParts(scene).triangles.empty()) {}

    /// A contact's dashes belong to no atom and cover nothing: they go with its atoms.
    bool isContact(std::uint32_t number) const { return number > chosen_.size(); }
    bool isPart(std::uint32_t atom) const { return !isContact(atom) && chosen_[atom - 1]; }
    std::array<std::uint32_t, 3> triangleAtoms(const Triangle& t) const {
        const auto atom = [&](std::uint32_t v) { return scene_.meshLooks[scene_.meshVertices[v].look].atom; };
        return {atom(t.a), atom(t.b), atom(t.c)};
    }
    /// Sticks and triangles between the part and its neighbours neither belong to it nor cover it.
    std::size_t countChosen(const Triangle& t) const {
        std::size_t count = 0;
        for (const std::uint32_t atom : triangleAtoms(t)) count += isPart(atom);
        return count;
    }
    std::size_t countChosen(const CylinderLook& look) const {
        return std::size_t{isPart(look.atomA)} + std::size_t{isPart(look.atomB)};
    }

    /// Whether a triangle covers the part: a translucent one does not.
    bool covers(const Triangle& t) const {
        return countChosen(t) == 0 && (!through_ || classifyTranslucency(scene_, t) == Translucency::opaque);
    }

    void count(const Placed& placed, const PartPicture& picture, double nearest);
    /// @param most  cells that may stay covered @returns upper bound of those that do
    std::size_t choose(std::size_t most);
    /// Also removes primitives whose centre is nearer than a plane.
    void peel(const Placed& placed, double nearest);
    /// Removes sticks with their atoms, and an atom with its last stick.
    void settle();
    /// Removes small pieces that are no longer connected to the rest.
    void dropScraps();

    bool isGone(const SphereLook& look) const { return atomsGone_.contains(look.atom); }
    bool isGone(std::size_t stick) const { return sticksGone_.contains(static_cast<std::uint32_t>(stick)); }
    bool isGone(const Triangle& t) const {
        const auto atoms = triangleAtoms(t);
        return std::any_of(atoms.begin(), atoms.end(), [&](std::uint32_t atom) { return atomsGone_.contains(atom); });
    }
    std::size_t covered() const { return covered_; }

private:
    const Representation& scene_;
    const std::vector<bool>& chosen_;
    bool through_;                                                     // some triangles are translucent
    std::unordered_map<std::uint32_t, std::size_t> byAtom_, byStick_;  // cells that each covers
    std::size_t covered_ = 0;                                          // cells that anything covers
    std::unordered_set<std::uint32_t> atomsGone_, sticksGone_;
};

void Covers::count(const Placed& placed, const PartPicture& picture, double nearest) {
    std::vector<bool> covered(picture.size());
    const auto note = [&](std::unordered_map<std::uint32_t, std::size_t>& counts, std::size_t of) {
        return [&, of](std::size_t cell, double front, double back) {
            // Primitives cut by a plane have their cap there.
            if (back > nearest || !picture.isCoveredBy(cell, std::min(front, nearest))) return;
            ++counts[static_cast<std::uint32_t>(of)];
            covered[cell] = true;
        };
    };
    placed.eachSphere(false, [&](std::size_t i, const glm::dvec3& center, double radius) {
        const std::uint32_t atom = scene_.sphereLooks[i].atom;
        if (!isPart(atom) && !isContact(atom) && classifyTranslucency(scene_.sphereLooks[i]) == Translucency::opaque)
            picture.eachOfBall(center, radius, note(byAtom_, atom));
    });
    placed.eachStick(false, [&](std::size_t i, const glm::dvec3& center, double radius) {
        const CylinderLook& look = scene_.cylinderLooks[i];
        if (countChosen(look) == 0 && !isContact(look.atomA) && classifyTranslucency(look) == Translucency::opaque)
            picture.eachOfBall(center, radius, note(byStick_, i));
    });
    placed.eachTriangle(false, [&](std::size_t i, const std::array<glm::dvec3, 3>& corners) {
        const Triangle& t = scene_.triangles[i];
        if (covers(t)) picture.eachOfTriangle(corners, note(byAtom_, triangleAtoms(t)[0]));
    });
    covered_ = static_cast<std::size_t>(std::count(covered.begin(), covered.end(), true));
}

void Covers::peel(const Placed& placed, double nearest) {
    placed.eachSphere(false, [&](std::size_t i, const glm::dvec3& center, double) {
        const std::uint32_t atom = scene_.sphereLooks[i].atom;
        const bool opaque = classifyTranslucency(scene_.sphereLooks[i]) == Translucency::opaque;
        if (center.z > nearest && !isPart(atom) && !isContact(atom) && opaque) atomsGone_.insert(atom);
    });
    placed.eachTriangle(false, [&](std::size_t i, const std::array<glm::dvec3, 3>& corners) {
        const Triangle& t = scene_.triangles[i];
        const bool before = (corners[0].z + corners[1].z + corners[2].z) / 3 > nearest;
        if (before && covers(t)) atomsGone_.insert(triangleAtoms(t)[0]);
    });
}

std::size_t Covers::choose(std::size_t most) {
    struct Cover {
        std::size_t cells;
        bool stick;
        std::uint32_t number;
    };
    std::vector<Cover> covers;
    for (const auto& [atom, cells] : byAtom_) covers.push_back({cells, false, atom});
    for (const auto& [stick, cells] : byStick_) covers.push_back({cells, true, stick});
    std::sort(covers.begin(), covers.end(), [](const Cover& a, const Cover& b) {
        return std::tie(a.cells, a.stick, a.number) < std::tie(b.cells, b.stick, b.number);
    });
    std::size_t kept = 0;
    for (const Cover& cover : covers)
        if (!cover.stick && atomsGone_.contains(cover.number))
            continue;
        else if (kept + cover.cells <= most)
            kept += cover.cells;
        else
            (cover.stick ? sticksGone_ : atomsGone_).insert(cover.number);
    return std::min(kept, covered_);
}

void Covers::settle() {
    std::unordered_map<std::uint32_t, std::size_t> sticksLeft;
    for (std::uint32_t i = 0; i < scene_.cylinderLooks.size(); ++i) {
        const CylinderLook& look = scene_.cylinderLooks[i];
        if (atomsGone_.contains(look.atomA) || atomsGone_.contains(look.atomB)) sticksGone_.insert(i);
        const bool stays = !sticksGone_.contains(i);
        sticksLeft[look.atomA] += stays;
        sticksLeft[look.atomB] += stays;
    }
    for (const auto& [atom, left] : sticksLeft)
        if (left == 0 && !isPart(atom)) atomsGone_.insert(atom);
    for (std::uint32_t i = 0; i < scene_.contacts.size(); ++i) {
        const Interaction& contact = scene_.contacts[i].interaction;
        for (const InteractionEnd* end : {&contact.a, &contact.b})
            if (atomsGone_.contains(end->atoms.front() + 1)) atomsGone_.insert(scene_.firstContact + i);
    }
}

/// Sets of connected atoms, by number: through sticks, triangles, and coinciding mesh vertices.
class Connections {
public:
    explicit Connections(std::size_t atoms) : sets_(atoms + 1) {}
    /// Ignores 0, which is no atom, and numbers of contacts.
    void join(std::uint32_t a, std::uint32_t b) {
        const auto isAtom = [&](std::uint32_t number) { return number > 0 && number < sets_.count(); };
        if (isAtom(a) && isAtom(b)) sets_.join(a, b);
    }
    std::uint32_t findRoot(std::uint32_t atom) { return sets_.findRoot(atom); }

private:
    DisjointSets sets_;
};

void Covers::dropScraps() {
    constexpr double kShort = 10;   // Å, the diagonal of a piece's box
    constexpr double kSmall = 0.2;  // of the original piece's atoms
    if (atomsGone_.empty() && sticksGone_.empty()) return;
    Connections before(chosen_.size()), after(chosen_.size());
    const auto join = [&](std::uint32_t a, std::uint32_t b, bool stays) {
        before.join(a, b);
        if (stays) after.join(a, b);
    };
    const auto stays = [&](std::uint32_t atom) { return !atomsGone_.contains(atom); };
    for (std::uint32_t i = 0; i < scene_.cylinderLooks.size(); ++i) {
        const CylinderLook& look = scene_.cylinderLooks[i];
        join(look.atomA, look.atomB, !sticksGone_.contains(i) && stays(look.atomA) && stays(look.atomB));
    }
    std::unordered_map<std::uint64_t, std::uint32_t> atomAt, leftAt;  // by vertex position
    for (const Triangle& t : scene_.triangles) {
        const auto atoms = triangleAtoms(t);
        const bool left = !isGone(t);
        join(atoms[0], atoms[1], left);
        join(atoms[1], atoms[2], left);
        for (const std::uint32_t v : {t.a, t.b, t.c}) {
            const MeshVertex& vertex = scene_.meshVertices[v];
            const std::uint64_t place = std::uint64_t{vertex.xz} << 32 | vertex.yz;
            const std::uint32_t atom = scene_.meshLooks[vertex.look].atom;
            before.join(atom, atomAt.emplace(place, atom).first->second);
            if (left) after.join(atom, leftAt.emplace(place, atom).first->second);
        }
    }
    std::unordered_map<std::uint32_t, std::size_t> sizesBefore, sizesAfter;
    std::unordered_set<std::uint32_t> seen, holdPart;
    const auto count = [&](std::uint32_t atom) {
        if (atom == 0 || atom > chosen_.size() || !seen.insert(atom).second) return;
        ++sizesBefore[before.findRoot(atom)];
        if (!stays(atom)) return;
        ++sizesAfter[after.findRoot(atom)];
        if (chosen_[atom - 1]) holdPart.insert(after.findRoot(atom));
    };
    for (const SphereLook& look : scene_.sphereLooks) count(look.atom);
    for (const SphereLook& look : scene_.meshLooks) count(look.atom);
    std::unordered_map<std::uint32_t, Box> boxes;  // by the roots of the remaining sets
    const auto widen = [&](std::uint32_t atom, const glm::dvec3& place) {
        if (seen.contains(atom) && stays(atom)) boxes[after.findRoot(atom)].add(place);
    };
    for (std::size_t i = 0; i < scene_.spheres.size(); ++i) widen(scene_.sphereLooks[i].atom, scene_.spheres[i].center);
    for (const Triangle& t : scene_.triangles)
        for (const std::uint32_t v : {t.a, t.b, t.c}) {
            const MeshVertex& vertex = scene_.meshVertices[v];
            widen(scene_.meshLooks[vertex.look].atom, decodePosition(vertex, t.step()));
        }
    for (const std::uint32_t atom : seen) {
        if (!stays(atom)) continue;
        const std::uint32_t root = after.findRoot(atom);
        const std::size_t size = sizesAfter[root], whole = sizesBefore[before.findRoot(atom)];
        if (size < whole && glm::distance(boxes[root].low, boxes[root].high) < kShort &&
            static_cast<double>(size) < kSmall * static_cast<double>(whole) && !holdPart.contains(root))
            atomsGone_.insert(atom);
    }
}

/// The remainder of some runs. @param before  number of kept primitives before each
template <typename Run>
void shorten(std::vector<Run>& runs, const std::vector<std::uint32_t>& before) {
    for (Run& run : runs) {
        const std::uint32_t end = before[run.first + run.count];
        run.first = before[run.first];
        run.count = end - run.first;
    }
    std::erase_if(runs, [](const Run& run) { return run.count == 0; });
}

/// @returns the number of kept primitives before each one, and in all
template <typename Gone>
std::vector<std::uint32_t> staying(std::size_t count, const Gone& gone) {
    std::vector<std::uint32_t> before(count + 1, 0);
    for (std::size_t i = 0; i < count; ++i) before[i + 1] = before[i] + (gone(i) ? 0 : 1);
    return before;
}

template <typename T>
void keep(std::vector<T>& items, const std::vector<std::uint32_t>& before) {
    for (std::size_t i = 0; i < items.size(); ++i)
        if (before[i + 1] != before[i]) items[before[i]] = items[i];
    items.resize(before.back());
}

/// Removes the marked primitives from the streams.
void remove(const Covers& covers, Representation& scene, Uncovered& result) {
    const auto spheres =
        staying(scene.spheres.size(), [&](std::size_t i) { return covers.isGone(scene.sphereLooks[i]); });
    const auto sticks = staying(scene.cylinders.size(), [&](std::size_t i) {
        return covers.isGone(i) || covers.isGone(SphereLook{0, scene.cylinderLooks[i].atomA});
    });
    const auto ofTriangles = [&](const std::vector<Triangle>& triangles) {
        return staying(triangles.size(), [&](std::size_t i) { return covers.isGone(triangles[i]); });
    };
    const auto triangles = ofTriangles(scene.triangles), coarse = ofTriangles(scene.coarseTriangles);
    result.spheres = scene.spheres.size() - spheres.back();
    result.cylinders = scene.cylinders.size() - sticks.back();
    result.triangles = scene.triangles.size() - triangles.back();
    if (!scene.ellipsoids.empty()) {
        scene.ellipsoids.resize(scene.spheres.size());
        keep(scene.ellipsoids, spheres);
    }
    keep(scene.spheres, spheres);
    keep(scene.sphereLooks, spheres);
    keep(scene.cylinders, sticks);
    keep(scene.cylinderLooks, sticks);
    keep(scene.triangles, triangles);
    keep(scene.coarseTriangles, coarse);
    shorten(scene.sphereModels, spheres);
    shorten(scene.copies.spheres, spheres);
    shorten(scene.cylinderModels, sticks);
    shorten(scene.copies.cylinders, sticks);
    shorten(scene.triangleModels, triangles);
    shorten(scene.copies.triangles, triangles);
    for (MeshRun& mesh : scene.meshes) {
        shorten(mesh.levels, coarse);
        mesh.closed = false;
    }
    shorten(scene.meshes, triangles);
}

/// Draws the part alone. @returns whether it has anything to draw
bool draw(const Placed& placed, const Representation& scene, const Covers& covers, PartPicture& picture) {
    // Twice: to find its extent, and its frontmost points.
    const auto eachOfPart = [&](const auto& ball, const auto& triangle) {
        placed.eachSphere(true, [&](std::size_t i, const glm::dvec3& center, double radius) {
            if (covers.isPart(scene.sphereLooks[i].atom)) ball(center, radius);
        });
        placed.eachStick(true, [&](std::size_t i, const glm::dvec3& center, double radius) {
            if (covers.countChosen(scene.cylinderLooks[i]) == 2) ball(center, radius);
        });
        placed.eachTriangle(true, [&](std::size_t i, const std::array<glm::dvec3, 3>& corners) {
            if (covers.countChosen(scene.triangles[i]) == 3) triangle(corners);
        });
    };
    bool any = false;
    const auto reach = [&](const glm::dvec3& center, double radius) {
        picture.reachBall(center, radius);
        any = true;
    };
    eachOfPart(reach, [&](const std::array<glm::dvec3, 3>& corners) {
        for (const glm::dvec3& corner : corners) reach(corner, 0);
    });
    if (!any) return false;
    picture.begin();
    const auto set = [&](std::size_t cell, double front, double) { picture.draw(cell, front); };
    eachOfPart([&](const glm::dvec3& center, double radius) { picture.eachOfBall(center, radius, set); },
               [&](const std::array<glm::dvec3, 3>& corners) { picture.eachOfTriangle(corners, set); });
    return picture.cells() > 0;
}

}  // namespace

Uncovered uncover(Representation& scene, const std::vector<bool>& chosen, const View& view, double clipNear) {
    Uncovered result;
    const Placed placed(scene, view);
    Covers covers(scene, chosen);
    PartPicture picture(view);
    if (!draw(placed, scene, covers, picture)) return result;
    covers.count(placed, picture, -clipNear);
    const double cells = static_cast<double>(picture.cells());
    result.before = 1 - static_cast<double>(covers.covered()) / cells;
    if (scene.copies.transforms.empty() && result.before <= 1 - kBuried) covers.peel(placed, picture.nearest());
    result.after = 1 - static_cast<double>(covers.choose(static_cast<std::size_t>(kStillCovered * cells))) / cells;
    covers.settle();
    covers.dropScraps();
    covers.settle();
    remove(covers, scene, result);
    return result;
}

}  // namespace nacre
