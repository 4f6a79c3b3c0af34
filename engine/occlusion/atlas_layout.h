#pragma once
// Sizes and positions of the primitives' patches in the occlusion atlas.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nacre {

struct OcclusionLayout {
    std::uint32_t sphereEdge = 0;         ///< width of a sphere's octahedral patch, texels: 3 or more, or 1 (one value)
    std::uint32_t around = 0;             ///< texels around a cylinder; a multiple of 4
    std::uint32_t along = 0;              ///< texels along a cylinder
    std::uint32_t width = 0, height = 0;  ///< of the atlas, texels
    std::uint32_t sphereRows = 0;         ///< atlas rows of sphere patches
    std::uint32_t cylinderRows = 0;       ///< atlas rows of cylinder patches; vertices follow
    std::uint32_t sphereCount = 0, cylinderCount = 0, vertexCount = 0;

    /// Patches per atlas row.
    std::uint32_t spherePatches() const { return width / sphereEdge; }
    std::uint32_t cylinderPatches() const { return width / around; }
    /// Texels of all spheres, rounded up to whole words of four texels.
    std::uint64_t sphereTexels() const { return (std::uint64_t{sphereCount} * sphereEdge * sphereEdge + 3) & ~3ull; }
    std::uint64_t cylinderTexels() const { return std::uint64_t{cylinderCount} * around * along; }
    /// Texels of spheres and cylinders.
    std::uint64_t patchTexels() const { return sphereTexels() + cylinderTexels(); }
    /// Mesh vertices have no patches but two adjacent texels each: for the outer and the inner side.
    std::uint64_t texelCount() const { return patchTexels() + 2 * std::uint64_t{vertexCount}; }
};

/// Patch sizes from finest to coarsest, each laid out for these numbers of primitives and vertices.
/// @param maxWidth, maxHeight  layouts that exceed them are left out
std::vector<OcclusionLayout> occlusionLayouts(std::size_t spheres, std::size_t cylinders, std::size_t vertices,
                                              std::uint32_t maxWidth, std::uint32_t maxHeight);

/// Whether all patches lie within the atlas, sphere patches above cylinder patches, with at most `mostSide` texels per
/// side. True for the layouts above; check stored layouts.
bool holdsItsPatches(const OcclusionLayout& layout, std::uint32_t mostSide);

}  // namespace nacre
