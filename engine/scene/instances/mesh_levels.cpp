#include "engine/scene/instances/mesh_levels.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace nacre {
namespace {

/// The triangles of a mesh that are drawn for an error.
struct Drawn {
    std::uint32_t first = 0, count = 0;
};
Drawn pickLevel(const Representation& r, const MeshRun& mesh, double error) {
    Drawn drawn{mesh.first, mesh.count};
    for (const MeshRun::Level& level : mesh.levels)
        if (static_cast<double>(level.error) <= error)
            drawn = {static_cast<std::uint32_t>(r.triangles.size()) + level.first, level.count};
    return drawn;
}

/// Extends a run of the same list by these triangles, or begins a new run.
void addDrawn(const PrimitiveRun& bounds, const Drawn& drawn, std::vector<PrimitiveRun>& runs) {
    if (drawn.count == 0) return;
    if (!runs.empty() && runs.back().list == bounds.list && runs.back().first + runs.back().count == drawn.first) {
        runs.back().count += drawn.count;
        return;
    }
    runs.push_back(bounds);
    runs.back().first = drawn.first;
    runs.back().count = drawn.count;
}

/// The smallest error of any level.
float finestLevel(const Representation& r) {
    float finest = std::numeric_limits<float>::max();
    for (const MeshRun& mesh : r.meshes)
        if (!mesh.levels.empty()) finest = std::min(finest, mesh.levels[0].error);
    return finest;
}

/// Drops the finest level of all meshes that have it.
void dropFinestLevel(Representation& r) {
    const float finest = finestLevel(r);
    std::vector<Triangle> kept;
    for (MeshRun& mesh : r.meshes) {
        if (!mesh.levels.empty() && mesh.levels[0].error == finest) mesh.levels.erase(mesh.levels.begin());
        for (MeshRun::Level& level : mesh.levels) {
            const auto first = static_cast<std::uint32_t>(kept.size());
            const auto from = r.coarseTriangles.begin() + level.first;
            kept.insert(kept.end(), from, from + level.count);
            level.first = first;
        }
    }
    r.coarseTriangles = std::move(kept);
}

std::uint64_t finestBytes(const Representation& r) {
    return shapeBytes(r) - r.coarseTriangles.size() * sizeof(Triangle);
}

/// Drops vertices that no triangle uses.
void dropVertices(Representation& r) {
    std::vector<std::uint32_t> places(r.meshVertices.size() + 1);
    for (const auto* stream : {&r.triangles, &r.coarseTriangles})
        for (const Triangle& t : *stream) places[t.a + 1] = places[t.b + 1] = places[t.c + 1] = 1;
    for (std::size_t v = 0; v < r.meshVertices.size(); ++v) {
        if (places[v + 1]) r.meshVertices[places[v]] = r.meshVertices[v];
        places[v + 1] += places[v];
    }
    r.meshVertices.resize(places.back());
    for (auto* stream : {&r.triangles, &r.coarseTriangles})
        for (Triangle& t : *stream) t.a = places[t.a], t.b = places[t.b], t.c = places[t.c];
    for (MeshRun& mesh : r.meshes) {
        mesh.firstVertex = places[mesh.firstVertex];
        mesh.endVertex = places[mesh.endVertex];
        for (MeshRun::Level& level : mesh.levels) level.endVertex = places[level.endVertex];
    }
}

/// Keeps only the finest level of each mesh that has several.
void dropFinestMeshes(Representation& r) {
    const float finest = finestLevel(r);
    std::vector<Triangle> kept;
    // Maps old to new positions of triangles, in the order of meshes. Runs begin and end with meshes that have levels.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> moved;
    for (MeshRun& mesh : r.meshes) {
        const auto first = static_cast<std::uint32_t>(kept.size());
        moved.emplace_back(mesh.first, first);
        auto from = r.triangles.begin() + mesh.first;
        if (!mesh.levels.empty() && mesh.levels[0].error == finest) {
            from = r.coarseTriangles.begin() + mesh.levels[0].first;
            mesh.count = mesh.levels[0].count;
            mesh.error = finest;
        }
        kept.insert(kept.end(), from, from + mesh.count);
        mesh.first = first;
    }
    moved.emplace_back(static_cast<std::uint32_t>(r.triangles.size()), static_cast<std::uint32_t>(kept.size()));
    const auto newNumber = [&](std::uint32_t number) {
        const auto after = std::upper_bound(moved.begin(), moved.end(), std::pair{number, ~0u});
        const auto& [was, is] = *(after - 1);
        return is + number - was;
    };
    const auto move = [&](auto& runs) {
        for (auto& run : runs) {
            const std::uint32_t end = newNumber(run.first + run.count);
            run.first = newNumber(run.first);
            run.count = end - run.first;
        }
    };
    move(r.copies.triangles);
    move(r.triangleModels);
    r.triangles = std::move(kept);
    dropFinestLevel(r);
    dropVertices(r);
}

}  // namespace

double errorInSpace(const View& view, double pixels) {
    const double nearest =
        view.projection == Projection::perspective ? view.eyeDistance / (view.eyeDistance - view.radius) : 1;
    return pixels / (view.pixelsPerAngstrom * nearest);
}

std::vector<PrimitiveRun> drawnRuns(const Representation& r, double error) {
    std::vector<PrimitiveRun> whole = r.copies.triangles;
    if (r.copies.transforms.empty()) whole = {{0, static_cast<std::uint32_t>(r.triangles.size()), 0, {}, 0}};
    const bool any = std::any_of(r.meshes.begin(), r.meshes.end(), [&](const MeshRun& mesh) {
        return !mesh.levels.empty() && static_cast<double>(mesh.levels[0].error) <= error;
    });
    if (!any) return whole;
    std::vector<PrimitiveRun> runs;
    for (const PrimitiveRun& run : whole)
        for (const MeshRun& mesh : r.meshes) {
            const std::uint32_t first = std::max(run.first, mesh.first),
                                end = std::min(run.first + run.count, mesh.first + mesh.count);
            if (first >= end) continue;
            // A mesh that is drawn in parts has no levels.
            addDrawn(run, mesh.levels.empty() ? Drawn{first, end - first} : pickLevel(r, mesh, error), runs);
        }
    return runs;
}

std::uint64_t shapeBytes(const Representation& r) {
    return r.spheres.size() * sizeof(Sphere) + (r.cylinders.size() + r.wires.size()) * sizeof(Cylinder) +
           (r.triangles.size() + r.coarseTriangles.size()) * sizeof(Triangle) +
           r.meshVertices.size() * sizeof(MeshVertex) +
           (r.ellipsoids.empty() ? 0 : r.spheres.size() * sizeof(EllipsoidRows));
}

void fitBuffer(Representation& r, std::uint64_t bytes) {
    while (finestBytes(r) > bytes && !r.coarseTriangles.empty()) dropFinestMeshes(r);
    while (shapeBytes(r) > bytes && !r.coarseTriangles.empty()) dropFinestLevel(r);
}

std::vector<MeshLevelCount> countLevels(const Representation& r, std::span<const TriangleCall> calls) {
    struct Part {
        std::uint32_t first, count;
        float error;
    };
    std::vector<Part> parts;
    for (const MeshRun& mesh : r.meshes) {
        parts.push_back({mesh.first, mesh.count, mesh.error});
        for (const MeshRun::Level& level : mesh.levels)
            parts.push_back({static_cast<std::uint32_t>(r.triangles.size()) + level.first, level.count, level.error});
    }
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.first < b.first; });
    std::map<float, MeshLevelCount> levels;
    for (const Part& part : parts) {
        MeshLevelCount& level = levels[part.error];
        level.error = static_cast<double>(part.error);
        level.triangles += part.count;
    }
    for (const TriangleCall& call : calls) {
        const std::uint32_t end = call.first + call.count;
        auto part = std::upper_bound(parts.begin(), parts.end(), call.first,
                                     [](std::uint32_t first, const Part& p) { return first < p.first; });
        if (part != parts.begin()) --part;
        for (; part != parts.end() && part->first < end; ++part) {
            const std::uint32_t from = std::max(call.first, part->first), to = std::min(end, part->first + part->count);
            if (from < to) levels[part->error].drawn += to - from;
        }
    }
    std::vector<MeshLevelCount> list;
    for (const auto& [error, level] : levels) list.push_back(level);
    return list;
}

}  // namespace nacre
