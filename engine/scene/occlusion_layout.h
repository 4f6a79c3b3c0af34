#pragma once
// Where every primitive's patch lies in the occlusion atlas, how large the patches are, and which texels can be lit.

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <vector>

#include "engine/scene/representation.h"

namespace nacre {

struct OcclusionLayout {
    std::uint32_t sphereEdge = 0;  ///< texels across a sphere's octahedral patch: a multiple of 4, or 1 (one value)
    std::uint32_t around = 0;      ///< texels around a cylinder; a multiple of 4
    std::uint32_t along = 0;       ///< texels along a cylinder
    std::uint32_t width = 0, height = 0;  ///< of the atlas, texels
    std::uint32_t sphereRows = 0;         ///< rows of the atlas that sphere patches take
    std::uint32_t sphereCount = 0, cylinderCount = 0;

    /// Texels of all spheres, rounded up to whole words of four.
    std::uint64_t sphereTexels() const { return (std::uint64_t{sphereCount} * sphereEdge * sphereEdge + 3) & ~3ull; }
    std::uint64_t texelCount() const { return sphereTexels() + std::uint64_t{cylinderCount} * around * along; }
};

/// The largest patches whose atlas, sums and texel list (9 bytes a texel) fit a budget.
/// @param budgetBytes  device memory for them; @param maxSize  largest image side
/// @throws Error if one value a sphere does not fit
OcclusionLayout occlusionLayout(std::size_t spheres, std::size_t cylinders, std::uint64_t budgetBytes,
                                std::uint32_t maxSize);

/// Writes the patch addresses into the looks.
void assignPatches(const OcclusionLayout& layout, Representation& representation);

/// Texels outside every other primitive, in linear order (all sphere patches, then all cylinder patches): the only
/// ones that any direction can light.
std::vector<std::uint32_t> openTexels(const OcclusionLayout& layout, const Representation& representation);

/// Unit directions of equal area (spherical Fibonacci, González 2010, Math. Geosci. 42), each with a right-handed
/// frame as rows u, v, w (w: the direction itself), rolled so that no two depth maps share a pixel raster.
std::vector<glm::dmat3> occlusionDirections(int count);

}  // namespace nacre
