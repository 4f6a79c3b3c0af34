#include "engine/mesh/mesh_levels.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

namespace nacre {

std::vector<MeshLevel> cartoonLevels() {
    // The finest is a tenth of a coil's width. The last two make bases thin, and coils triangular.
    constexpr float kErrors[] = {0.0475f, 0.095f, 0.19f, 0.38f, 0.76f};
    std::vector<MeshLevel> levels;
    for (const float error : kErrors) levels.push_back({error, {}});
    return levels;
}

void dropFineLevels(Mesh& mesh) {
    std::size_t together = 0, kept = 0;
    while (kept < mesh.coarser.size()) {
        together += mesh.coarser[mesh.coarser.size() - 1 - kept].triangles.size();
        if (together > mesh.triangles.size()) break;
        ++kept;
    }
    mesh.coarser.erase(mesh.coarser.begin(), mesh.coarser.end() - static_cast<std::ptrdiff_t>(kept));
}

Picks allPicks(std::size_t count) {
    Picks all(count);
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

std::vector<Picks> makePolygons(std::size_t count) {
    std::vector<Picks> polygons;
    for (std::size_t corners = 3; corners <= 8 && corners < count; ++corners) {
        Picks picks;
        for (std::size_t i = 0; i < corners; ++i)
            picks.push_back(static_cast<std::uint32_t>((i * count + corners / 2) / corners));
        polygons.push_back(std::move(picks));
    }
    polygons.push_back(allPicks(count));
    return polygons;
}

double sideError(std::span<const glm::dvec2> outline, const Picks& picks, const glm::dvec2& axes) {
    double most = 0;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        const std::size_t from = picks[i], to = i + 1 < picks.size() ? picks[i + 1] : picks[0] + outline.size();
        const glm::dvec2 a = outline[from] * axes, along = outline[to % outline.size()] * axes - a;
        for (std::size_t k = from + 1; k < to; ++k) {
            const glm::dvec2 p = outline[k % outline.size()] * axes - a;
            const double t = std::clamp(glm::dot(p, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
            most = std::max(most, glm::length(p - along * t));
        }
    }
    return most;
}

Picks circlePicks(std::size_t count, double radius, double most) {
    for (Picks& picks : makePolygons(count)) {
        std::size_t gap = picks[0] + count - picks.back();
        for (std::size_t i = 1; i < picks.size(); ++i) gap = std::max<std::size_t>(gap, picks[i] - picks[i - 1]);
        const double half = std::numbers::pi * static_cast<double>(gap) / static_cast<double>(count);
        const double error = gap > 1 ? radius * (1 - std::cos(half)) : 0;
        if (error <= most || gap == 1) return std::move(picks);
    }
    return allPicks(count);
}

}  // namespace nacre
