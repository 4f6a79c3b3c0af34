#include "engine/scene/mesh_levels.h"

#include <algorithm>
#include <limits>
#include <map>

namespace nacre {
namespace {

/// Where a mesh is drawn from at an error.
struct Drawn {
    std::uint32_t first = 0, count = 0;
};
Drawn drawnOf(const Representation& r, const MeshRun& mesh, double error) {
    Drawn drawn{mesh.first, mesh.count};
    for (const MeshRun::Level& level : mesh.levels)
        if (static_cast<double>(level.error) <= error)
            drawn = {static_cast<std::uint32_t>(r.triangles.size()) + level.first, level.count};
    return drawn;
}

/// Puts triangles behind others of the same list, or begins a run of their own.
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

/// Of all meshes that have one with the least error.
void dropFinestLevel(Representation& r) {
    float finest = std::numeric_limits<float>::max();
    for (const MeshRun& mesh : r.meshes)
        if (!mesh.levels.empty()) finest = std::min(finest, mesh.levels[0].error);
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
            addDrawn(run, mesh.levels.empty() ? Drawn{first, end - first} : drawnOf(r, mesh, error), runs);
        }
    return runs;
}

std::uint64_t shapeBytes(const Representation& r) {
    return r.spheres.size() * sizeof(Sphere) + r.cylinders.size() * sizeof(Cylinder) +
           (r.triangles.size() + r.coarseTriangles.size()) * sizeof(Triangle) +
           r.meshVertices.size() * sizeof(MeshVertex);
}

void fitBuffer(Representation& r, std::uint64_t bytes) {
    while (shapeBytes(r) > bytes && !r.coarseTriangles.empty()) dropFinestLevel(r);
}

std::vector<MeshLevelCount> levelsOf(const Representation& r, std::span<const TriangleCall> calls) {
    struct Part {
        std::uint32_t first, count;
        float error;
    };
    std::vector<Part> parts;
    for (const MeshRun& mesh : r.meshes) {
        parts.push_back({mesh.first, mesh.count, 0});
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
