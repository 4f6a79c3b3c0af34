#pragma once
// Where a sum of Gaussians crosses the edges of a grid.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/surface_field.h"

namespace nacre {

/// A ball's Gaussian is exp(s (1 - (d / radius)^2)), 0 from kGaussianReach radii on. The surface is where their sum
/// is 1.
constexpr double kGaussianSmoothness = 1.5;
constexpr double kGaussianReach = 2.5;  ///< exp(-1.5 * 6.25) is 1e-4 of the value at an atom's centre

/// Adds a point for each crossing of a block. Crossings in one brick of 4 x 4 x 4 cells share a list of the balls that
/// reach it, four balls at once.
/// @param sources  balls that reach into the block
void crossGaussians(const std::vector<SurfaceBall>& balls, const GridBlock& block,
                    std::span<const std::uint32_t> sources, std::span<const GridCrossing> crossings,
                    std::vector<SurfacePoint>& points);

}  // namespace nacre
