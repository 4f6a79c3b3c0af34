#pragma once
// Finished occlusion bakes on disk, by the content that decides them.

#include <optional>
#include <string>
#include <string_view>

#include "engine/occlusion/finished_occlusion.h"
#include "engine/scene/representation.h"
#include "engine/storage/disk_cache.h"

namespace nacre {

/// Most bytes of bakes that are kept.
constexpr std::uint64_t kOcclusionCacheBytes = 512ull << 20;

/// @param folder  empty: nothing is kept
DiskCache occlusionCache(const std::string& folder);

/// The name of a bake's file: a hash (XXH3, 128 bits) of the spheres and cylinders, of `how`, and of the version of
/// what the engine does with them. Colours and atom numbers do not count.
/// @param how  everything else that decides a texel: directions, budget, path, device, driver
std::string occlusionCacheName(const Representation& representation, std::string_view how);

/// What was kept under a name. Empty if there is nothing, or nothing whole, or nothing that fits the representation and
/// a device whose images have at most `mostSide` texels a side.
std::optional<FinishedOcclusion> readOcclusion(const DiskCache& cache, const std::string& name,
                                               const Representation& representation, std::uint32_t mostSide = 1 << 16);

/// False if it could not be kept.
bool writeOcclusion(const DiskCache& cache, const std::string& name, const FinishedOcclusion& finished);

}  // namespace nacre
