#include "engine/mesh/carve.h"

#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <vector>

#include "engine/threads.h"

namespace nacre {
namespace {

/// Distance of points from the nearest of some places, limited to 1.5 times `reach`.
class Reach {
public:
    Reach(std::span<const glm::dvec3> places, double reach) : reach_(reach), side_(std::max(reach, 0.5)) {
        for (const glm::dvec3& place : places) cells_[makeKey(findCell(place))].push_back(place);
    }
    /// Distance minus reach: negative inside, at most half the reach outside.
    double beyond(const glm::dvec3& p) const {
        const glm::ivec3 middle = findCell(p);
        double least = 1.5 * reach_;
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z) {
                    const auto cell = cells_.find(makeKey(middle + glm::ivec3(x, y, z)));
                    if (cell == cells_.end()) continue;
                    for (const glm::dvec3& place : cell->second) least = std::min(least, glm::distance(p, place));
                }
        return least - reach_;
    }

private:
    glm::ivec3 findCell(const glm::dvec3& p) const { return glm::floor(p / side_); }
    static std::uint64_t makeKey(const glm::ivec3& cell) {
        constexpr std::uint64_t kMask = (1u << 21) - 1;
        return (static_cast<std::uint64_t>(cell.x) & kMask) << 42 | (static_cast<std::uint64_t>(cell.y) & kMask) << 21 |
               (static_cast<std::uint64_t>(cell.z) & kMask);
    }

    double reach_, side_;
    std::unordered_map<std::uint64_t, std::vector<glm::dvec3>> cells_;
};

class Carver {
public:
    Carver(Isosurface& surface, const Reach& reach) : surface_(surface), reach_(reach) {
        constexpr std::size_t kChunk = 4096;
        const std::size_t count = surface.positions.size();
        inside_.resize(count);
        inParallel((count + kChunk - 1) / kChunk, [&](std::size_t chunk) {
            for (std::size_t i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i)
                inside_[i] = reach.beyond(surface.positions[i]) <= 0;
        });
    }

    void cutTriangles() {
        std::vector<glm::uvec3> kept;
        for (const glm::uvec3& t : surface_.triangles) {
            const int count = int{inside_[t.x]} + int{inside_[t.y]} + int{inside_[t.z]};
            if (count == 3) kept.push_back(t);
            if (count == 0 || count == 3) continue;
            // Rotates the corners so that the one alone on its side comes first.
            glm::uvec3 turned = t;
            const std::uint8_t lone = count == 1;
            while (inside_[turned.x] != lone) turned = {turned.y, turned.z, turned.x};
            const std::uint32_t first = crossing(turned.x, turned.y), second = crossing(turned.x, turned.z);
            if (count == 1) {
                kept.emplace_back(turned.x, first, second);
            } else {
                kept.emplace_back(first, turned.y, turned.z);
                kept.emplace_back(first, turned.z, second);
            }
        }
        surface_.triangles = std::move(kept);
    }

    void cutLines() {
        std::vector<glm::uvec2> kept;
        for (const glm::uvec2& line : surface_.lines) {
            const bool first = inside_[line.x] != 0, second = inside_[line.y] != 0;
            if (first && second) kept.push_back(line);
            if (first != second) kept.emplace_back(first ? line.x : line.y, crossing(line.x, line.y));
        }
        surface_.lines = std::move(kept);
    }

    /// Drops original vertices out of reach, and renumbers the others. Vertices on cuts stay.
    void dropVertices() {
        std::vector<std::uint32_t> places(surface_.positions.size());
        std::uint32_t count = 0;
        for (std::uint32_t i = 0; i < places.size(); ++i) {
            places[i] = count;
            if (i < inside_.size() && !inside_[i]) continue;
            surface_.positions[count] = surface_.positions[i];
            if (!surface_.normals.empty()) surface_.normals[count] = surface_.normals[i];
            ++count;
        }
        surface_.positions.resize(count);
        if (!surface_.normals.empty()) surface_.normals.resize(count);
        for (glm::uvec3& t : surface_.triangles) t = {places[t.x], places[t.y], places[t.z]};
        for (glm::uvec2& line : surface_.lines) line = {places[line.x], places[line.y]};
    }

private:
    /// The vertex where an edge crosses the distance.
    std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t low = std::min(a, b), high = std::max(a, b);
        const auto [found, isNew] = crossings_.try_emplace(std::uint64_t{low} << 32 | high,
                                                           static_cast<std::uint32_t>(surface_.positions.size()));
        if (!isNew) return found->second;
        double in = inside_[low] != 0 ? 0 : 1, out = 1 - in;
        const glm::dvec3 from(surface_.positions[low]), to(surface_.positions[high]);
        for (int step = 0; step < 14; ++step) {
            const double middle = (in + out) / 2;
            (reach_.beyond(glm::mix(from, to, middle)) <= 0 ? in : out) = middle;
        }
        surface_.positions.emplace_back(glm::mix(from, to, in));
        if (!surface_.normals.empty()) {
            const glm::vec3 normal = glm::mix(surface_.normals[low], surface_.normals[high], static_cast<float>(in));
            const float length = glm::length(normal);
            surface_.normals.push_back(length > 0 ? normal / length : surface_.normals[low]);
        }
        return found->second;
    }

    Isosurface& surface_;
    const Reach& reach_;
    std::vector<std::uint8_t> inside_;  // 1 or 0, by original vertex
    std::unordered_map<std::uint64_t, std::uint32_t> crossings_;
};

}  // namespace

void carve(Isosurface& surface, std::span<const glm::dvec3> places, double reach) {
    const Reach near(places, reach);
    Carver carver(surface, near);
    carver.cutTriangles();
    carver.cutLines();
    carver.dropVertices();
}

}  // namespace nacre
