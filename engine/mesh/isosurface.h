#pragma once
// Isosurfaces of density maps, as triangles and as lines where they cross the planes of the grid.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/volume/density_map.h"

namespace nacre {

struct Isosurface {
    std::vector<glm::vec3> positions;   ///< Å, relative to the requested origin
    std::vector<glm::vec3> normals;     ///< unit vectors, outward; same length
    std::vector<glm::uvec3> triangles;  ///< counter-clockwise seen from outside
    std::vector<glm::uvec2> lines;      ///< the "chicken wire"
};

enum class IsosurfaceParts : std::uint8_t { triangles, lines, vertices };

constexpr std::size_t kMostIsoTriangles = 20'000'000, kMostIsoLines = 10'000'000;

/// A box of a map's nodes (of any unit cell of a crystal), prepared for many levels. The map outlives it.
class MapRegion {
public:
    /// The nodes from `first` to `last`, inclusive; clamped to the map unless it is periodic. @throws Error if it is
    /// too large
    MapRegion(const DensityMap& map, glm::ivec3 first, glm::ivec3 last);
    /// The nodes within `reach` (Å) of these positions (Å); surfaces are cut at that distance (carve.h).
    MapRegion(const DensityMap& map, std::span<const glm::dvec3> places, double reach);

    /// The isosurface of a level, which encloses higher or lower values. Marching cubes (marching_cubes.h) with linear
    /// interpolation between nodes and normals from the gradient, in blocks of 8 x 8 x 8 cells by several threads;
    /// skips blocks that the level does not cross. The result does not depend on the number of threads.
    /// @param above  encloses higher values; false: lower ones
    /// @throws Error if it has too many triangles or lines
    Isosurface at(double level, bool above, IsosurfaceParts parts, const glm::dvec3& origin) const;

    /// Values of the nodes, along a first.
    const float* values() const { return own_.empty() ? map_.values.data() : own_.data(); }
    /// Lowest and highest known value of a block of cells and the nodes on its border; low > high: none is known.
    struct Range {
        float low, high;
    };
    static constexpr int kBlock = 8;  ///< cells along a block's edge
    Range blockRange(const glm::ivec3& block) const {
        return ranges_[(static_cast<std::size_t>(block.z) * blocks_.y + block.y) * blocks_.x + block.x];
    }
    const glm::ivec3& blocks() const { return blocks_; }
    /// Positions (Å) that the region is limited to, within `reach`; none: the region is a box.
    std::span<const glm::dvec3> places() const { return places_; }
    double reach() const { return reach_; }

    bool empty() const { return size_.x < 2 || size_.y < 2 || size_.z < 2; }
    const glm::ivec3& first() const { return first_; }
    const glm::ivec3& size() const { return size_; }
    const DensityMap& map() const { return map_; }

private:
    friend class IsosurfaceSlab;
    void begin(glm::ivec3 first, glm::ivec3 last);
    void copyValues();
    void findRanges();

    const DensityMap& map_;
    glm::ivec3 first_{}, size_{}, blocks_{};
    std::vector<float> own_;     ///< copied values; empty: the map's own
    std::vector<Range> ranges_;  ///< per block
    std::vector<glm::dvec3> places_;
    double reach_ = 0;  ///< largest distance of surfaces from the places, if there are any
};

}  // namespace nacre
