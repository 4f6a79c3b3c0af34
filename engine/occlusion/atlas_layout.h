#pragma once
// Where every primitive's patch lies in the occlusion atlas, and how large the patches are.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nacre {

struct OcclusionLayout {
    std::uint32_t sphereEdge = 0;  ///< texels across a sphere's octahedral patch: a multiple of 4, or 1 (one value)
    std::uint32_t around = 0;      ///< texels around a cylinder; a multiple of 4
    std::uint32_t along = 0;       ///< texels along a cylinder
    std::uint32_t width = 0, height = 0;  ///< of the atlas, texels
    std::uint32_t sphereRows = 0;         ///< rows of the atlas that sphere patches take
    std::uint32_t cylinderRows = 0;       ///< that cylinder patches take; those of vertices follow
    std::uint32_t sphereCount = 0, cylinderCount = 0, vertexCount = 0;

    /// Patches in a row of the atlas.
    std::uint32_t spherePatches() const { return width / sphereEdge; }
    std::uint32_t cylinderPatches() const { return width / around; }
    /// Texels of all spheres, rounded up to whole words of four.
    std::uint64_t sphereTexels() const { return (std::uint64_t{sphereCount} * sphereEdge * sphereEdge + 3) & ~3ull; }
    std::uint64_t cylinderTexels() const { return std::uint64_t{cylinderCount} * around * along; }
    /// Of spheres and cylinders.
    std::uint64_t patchTexels() const { return sphereTexels() + cylinderTexels(); }
    /// Vertices of meshes have two, side by side, without patches: of their outer and of their inner side.
    std::uint64_t texelCount() const { return patchTexels() + 2 * std::uint64_t{vertexCount}; }
};

/// Patch sizes from the finest to the coarsest, each laid out for a number of primitives and of vertices.
/// @param maxSize  largest image side; what does not fit it is left out
std::vector<OcclusionLayout> occlusionLayouts(std::size_t spheres, std::size_t cylinders, std::size_t vertices,
                                              std::uint32_t maxSize);

/// Whether every patch lies within the atlas, spheres' above cylinders', and that has at most `mostSide` texels a side:
/// so of all layouts above, and to be asked of one that comes from elsewhere.
bool holdsItsPatches(const OcclusionLayout& layout, std::uint32_t mostSide);

}  // namespace nacre
