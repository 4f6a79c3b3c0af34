#pragma once
// CPU preparation of a bake: patch sizes, the texels that light can reach, and which copies share their tests.

#include <cstdint>
#include <stop_token>

#include "engine/gpu/caps.h"
#include "engine/occlusion/copies.h"
#include "engine/occlusion/depth_maps.h"
#include "engine/occlusion/occluder_mesh.h"
#include "engine/occlusion/open_texels.h"
#include "engine/occlusion/seen_texels.h"
#include "engine/scene/build/representation.h"
#include "engine/settings.h"

namespace nacre::occlusion {

struct BakeOptions {
    int directions = 128;
    std::uint64_t budgetBytes = 64ull << 20;  ///< device memory of the whole bake
    OcclusionMaps path = OcclusionMaps::encoded;
    std::uint32_t detail = 32;                        ///< maximum width of a sphere's patch, texels
    std::optional<ViewDirection> viewDirection = {};  ///< of the only view that shows the bake
    bool bounce = false;                              ///< the finished atlas becomes one with bounced light
    bool moving = false;                              ///< atoms move: another bake follows soon
};

/// The prepared data. Layout, texels and map width depend on the scene and the options, not on the path. They depend on
/// the device only if its images are too small for an atlas of more than the usual memory.
struct BakePreparation {
    DepthMapSizes maps;
    OcclusionLayout layout;
    OpenTexels open;
    OcclusionCopies copies;
    OccluderMeshes occluders;  ///< for maps drawn by the host
};

/// Thread-safe. @param stop  when requested, returns early with an unusable result
/// @throws Error if even one value per sphere exceeds the budget
BakePreparation prepareBake(const gpu::Caps& caps, const Representation& representation, const BakeOptions& options,
                            const std::stop_token& stop = {});

/// Device memory of a bake, without depth maps. @param words  atlas words that hold listed texels
std::uint64_t bakeBytes(const OcclusionLayout& layout, std::uint64_t openTexels, std::uint64_t words);
/// Device memory while an atlas with bounced light replaces the one without.
std::uint64_t bouncedBytes(const OcclusionLayout& layout);

}  // namespace nacre::occlusion
