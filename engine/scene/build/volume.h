#pragma once
// A density map drawn as a volume, by rays: its values in bricks, and a transfer function.

#include <array>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "engine/mesh/isosurface.h"

namespace nacre {

/// The look of a value. Between levels, colour (in linear light) and opacity are interpolated; beyond the first and
/// last they are constant.
struct VolumeLevel {
    double value = 0;
    std::array<float, 3> color{};  ///< sRGB-coded, 0..1
    double opacity = 0;            ///< share of light that 1 Å hides, 0..1
};
constexpr std::size_t kMostVolumeLevels = 8;

/// A box of nodes in one texture. Neighbours share the nodes on their border.
struct VolumeBrick {
    glm::ivec3 place{};  ///< in the lattice of bricks
    glm::ivec3 first{};  ///< its first node, among those of the region
    glm::ivec3 size{};   ///< nodes
    bool masked = false;
    /// Half floats, the first axis fastest: the value and, if masked, a second number: 1 where it is shown, 0 beyond
    /// the reach of the places, very negative where it is unknown.
    std::vector<std::uint16_t> texels;
};

struct Volume {
    std::vector<VolumeBrick> bricks;  ///< visible ones, cropped to their visible part
    std::vector<VolumeLevel> levels;  ///< ascending, in the unit of the texels
    glm::dmat4x3 toNode{};            ///< position about the scene's centre, Å -> node of the region
    double step = 0;                  ///< half a voxel, Å
    int brickCells = 0;               ///< along an edge of the lattice
    double radius = 0;                ///< of the visible part, about the scene's centre, Å
};

/// Cells along a brick's edge: its nodes fit the guaranteed size of three-dimensional textures.
constexpr int kBrickCells = 248;
/// Of all bricks together, in device memory.
constexpr std::size_t kMostVolumeBytes = std::size_t{1} << 30;

/// @param levels  1 to kMostVolumeLevels, in any order, in the map's unit @param center  of the scene, Å
/// @param brickCells  a multiple of MapRegion::kBlock @returns null if nothing is visible
/// @throws Error if it is too large
std::shared_ptr<const Volume> makeVolume(const MapRegion& region, std::span<const VolumeLevel> levels,
                                         const glm::dvec3& center, int brickCells = kBrickCells);

}  // namespace nacre
