#pragma once
// What is decided before a bake starts, on the processor: how fine the patches are, which of their texels light can
// reach, and which copies ask together.

#include <cstdint>
#include <stop_token>

#include "engine/gpu/caps.h"
#include "engine/occlusion/copies.h"
#include "engine/occlusion/open_texels.h"
#include "engine/scene/representation.h"
#include "engine/settings.h"

namespace nacre::occlusion {

struct BakeOptions {
    int directions = 128;
    std::uint64_t budgetBytes = 64ull << 20;  ///< device memory of everything that the bake holds
    OcclusionMaps path = OcclusionMaps::encoded;
    std::uint32_t detail = 32;  ///< texels across a sphere's patch, at most
};

/// What a bake needs to know before it starts, and what takes the host its time.
struct BakePreparation {
    OcclusionLayout layout;
    OpenTexels open;
    OcclusionCopies copies;
};

/// For any thread. @param stop  what is prepared is of no use once it is asked for: returns early, with anything
/// @throws Error if even one value a sphere does not fit the budget
BakePreparation prepareBake(const gpu::Caps& caps, const Representation& representation, const BakeOptions& options,
                            const std::stop_token& stop = {});

/// Of a bake's memory what its depth maps may have: a half, less where vertices of meshes need more than the other.
std::uint64_t mapBudget(std::uint64_t bytes, const Representation& representation);

/// Device memory that a bake holds, but for its depth maps.
/// @param words  of the atlas, that hold texels of the list
std::uint64_t bakeBytes(const OcclusionLayout& layout, std::uint64_t openTexels, std::uint64_t words);

}  // namespace nacre::occlusion
