#include "engine/passes/placed_copies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "engine/scene/instances/mesh_levels.h"

namespace nacre::passes {
namespace {

/// Points farther than `at` along the unit vector `out` are beyond one of the picture's edges.
struct Edge {
    glm::dvec3 out;
    double at = 0;
};
using Edges = std::array<Edge, 4>;

/// The edges of one view, or of two eyes' views.
struct Borders {
    Edges edges;
    std::optional<Edges> other;
};

/// The planes through the eye and the edges of a picture that is larger by `room` pixels on each side.
Edges makeEdges(const View& view, double room) {
    const double slope = view.eyeDistance > 0 ? 1.0 / view.eyeDistance : 0.0;
    const auto edge = [&](glm::dvec3 out, std::uint32_t pixels, double pan) {
        const double half = (pixels / 2.0 + room) / view.pixelsPerAngstrom + pan;  // on the plane z = 0
        const double length = std::sqrt(1.0 + half * slope * half * slope);
        out.z = half * slope;
        return Edge{out / length, half / length};
    };
    return {edge({1, 0, 0}, view.width, -view.pan.x), edge({-1, 0, 0}, view.width, view.pan.x),
            edge({0, 1, 0}, view.height, -view.pan.y), edge({0, -1, 0}, view.height, view.pan.y)};
}

/// @param room  as for makeEdges()
Borders makeBorders(const View& view, double room) {
    Borders borders{makeEdges(view, room), {}};
    if (view.other) borders.other = makeEdges(otherView(view), room);
    return borders;
}

/// The same edges before a transform is applied.
Edges before(const Edges& edges, const glm::dmat3& turn, const glm::dvec3& shift) {
    Edges moved = edges;
    for (Edge& e : moved) e = {glm::transpose(turn) * e.out, e.at - glm::dot(e.out, shift)};
    return moved;
}
Borders before(const Borders& borders, const View& view, const glm::dmat4x3& place) {
    const glm::dmat3 turn = view.rotation * glm::dmat3(place[0], place[1], place[2]);
    const glm::dvec3 shift = view.seen(place[3]);
    Borders moved{before(borders.edges, turn, shift), {}};
    if (borders.other) moved.other = before(*borders.other, turn, shift + glm::dvec3(view.other->shift, 0, 0));
    return moved;
}

/// Whether a ball may show in the picture.
bool mayShow(const Edges& edges, const glm::dvec3& center, double radius) {
    return std::all_of(edges.begin(), edges.end(),
                       [&](const Edge& e) { return glm::dot(e.out, center) - e.at <= radius; });
}

bool mayShow(const Borders& borders, const glm::dvec3& center, double radius) {
    return mayShow(borders.edges, center, radius) || (borders.other && mayShow(*borders.other, center, radius));
}

/// Whether all of a ball is inside of the picture's edges.
bool showsWhole(const Edges& edges, const glm::dvec3& center, double radius) {
    return std::all_of(edges.begin(), edges.end(),
                       [&](const Edge& e) { return glm::dot(e.out, center) - e.at <= -radius; });
}

bool showsWhole(const Borders& borders, const glm::dvec3& center, double radius) {
    return showsWhole(borders.edges, center, radius) && (!borders.other || showsWhole(*borders.other, center, radius));
}

std::uint64_t total(const std::vector<PlacedCopies::Call>& calls) {
    std::uint64_t sum = 0;
    for (const PlacedCopies::Call& call : calls) sum += call.count;
    return sum;
}

void addRows(const View& view, const glm::dmat4x3& transform, PlacedCopies& placed) {
    const glm::dmat3 turn = view.rotation * glm::dmat3(transform[0], transform[1], transform[2]);
    const glm::dvec3 shift = view.seen(transform[3]);
    for (int i = 0; i < 3; ++i) placed.rows.emplace_back(turn[0][i], turn[1][i], turn[2][i], shift[i]);
    if (view.other) placed.otherShifts.push_back(static_cast<float>(shift.x + view.other->shift));
}

/// Chunks of a copy that may be visible; one call for consecutive ones.
void addChunks(const std::vector<Chunk>& chunks, const Borders& edges, const PlacedCopies::Call& all,
               std::vector<PlacedCopies::Call>& calls) {
    const std::uint32_t end = all.first + all.count;
    bool goesOn = false;
    for (std::uint32_t first = all.first; first < end;) {
        const Chunk& chunk = chunks[first / Chunk::kPrimitives];
        const std::uint32_t next = std::min(end, (first / Chunk::kPrimitives + 1) * Chunk::kPrimitives);
        const bool shows = mayShow(edges, chunk.center, chunk.radius);
        if (shows && goesOn)
            calls.back().count += next - first;
        else if (shows)
            calls.push_back({all.copy, first, next - first});
        goesOn = shows;
        first = next;
    }
}

void addCalls(const Copies& copies, const std::vector<PrimitiveRun>& runs, const View& view, const Borders& edges,
              const std::vector<Chunk>* chunks, std::vector<PlacedCopies::Call>& calls) {
    for (const PrimitiveRun& run : runs)
        for (const std::uint32_t copy : copies.lists[run.list]) {
            const Borders here = before(edges, view, copies.transforms[copy]);
            if (!mayShow(here, run.center, run.radius)) continue;
            const PlacedCopies::Call call{copy, run.first, run.count};
            if (chunks && !showsWhole(here, run.center, run.radius))
                addChunks(*chunks, here, call, calls);
            else
                calls.push_back(call);
        }
}

}  // namespace

std::uint64_t PlacedCopies::sphereCount() const { return total(spheres); }
std::uint64_t PlacedCopies::cylinderCount() const { return total(cylinders); }
std::uint64_t PlacedCopies::triangleCount() const { return total(triangles); }

std::vector<MeshLevelCount> PlacedCopies::triangleLevels(const Representation& r) const {
    if (r.meshes.empty()) return {};  // true in each frame of most scenes
    std::vector<TriangleCall> calls;
    for (const Call& call : triangles) calls.push_back({call.first, call.count});
    return countLevels(r, calls);
}

PlacedCopies placeCopies(const Representation& r, const View& view, const Chunks* chunks, double room, double error,
                         bool wires) {
    PlacedCopies placed;
    placeCopies(placed, r, view, chunks, room, error, wires);
    return placed;
}

void placeCopies(PlacedCopies& placed, const Representation& r, const View& view, const Chunks* chunks, double room,
                 double error, bool wires) {
    placed.clear();
    // Impostors reach a little beyond their spheres.
    const Borders edges = makeBorders(view, 2.0 + room);
    const auto* spheres = chunks ? &chunks->spheres : nullptr;
    const auto* cylinders = chunks ? &chunks->cylinders : nullptr;
    const auto* triangles = chunks ? &chunks->triangles : nullptr;
    std::vector<PrimitiveRun> meshes;
    if (!r.triangles.empty()) meshes = drawnRuns(r, error);
    if (r.copies.transforms.empty()) {
        addRows(view, glm::dmat4x3(1.0), placed);
        const Borders here = before(edges, view, glm::dmat4x3(1.0));
        const auto add = [&](std::size_t first, std::size_t count, const std::vector<Chunk>* of,
                             std::vector<PlacedCopies::Call>& calls) {
            const PlacedCopies::Call all{0, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)};
            if (count > 0 && of)
                addChunks(*of, here, all, calls);
            else if (count > 0)
                calls.push_back(all);
        };
        add(0, r.spheres.size(), spheres, placed.spheres);
        add(0, r.cylinders.size() + (wires ? r.wires.size() : 0), cylinders, placed.cylinders);
        for (const PrimitiveRun& run : meshes) add(run.first, run.count, triangles, placed.triangles);
        return;
    }
    placed.rows.reserve(3 * r.copies.transforms.size());
    for (const glm::dmat4x3& transform : r.copies.transforms) addRows(view, transform, placed);
    addCalls(r.copies, r.copies.spheres, view, edges, spheres, placed.spheres);
    addCalls(r.copies, r.copies.cylinders, view, edges, cylinders, placed.cylinders);
    addCalls(r.copies, meshes, view, edges, triangles, placed.triangles);
    if (!wires || r.wires.empty()) return;
    const auto still = static_cast<std::uint32_t>(placed.rows.size() / 3);
    addRows(view, glm::dmat4x3(1.0), placed);
    placed.cylinders.push_back(
        {still, static_cast<std::uint32_t>(r.cylinders.size()), static_cast<std::uint32_t>(r.wires.size())});
}

}  // namespace nacre::passes
