#pragma once
// Finished occlusion bakes on disk, keyed by a hash of their inputs.

#include <optional>
#include <string>
#include <string_view>

#include "engine/occlusion/finished_occlusion.h"
#include "engine/scene/build/representation.h"
#include "engine/storage/disk_cache.h"

namespace nacre {

/// Increase it whenever the result of bakes changes: patch sizes, directions, open texels, shaders.
constexpr std::uint32_t kOcclusionVersion = 12;
/// Maximum size of the cache.
constexpr std::uint64_t kOcclusionCacheBytes = 512ull << 20;

/// @param folder  empty: no cache
DiskCache occlusionCache(const std::string& folder);

/// File name of a bake: a hash (XXH3, 128 bits) of the spheres and cylinders, of `how`, and of kOcclusionVersion.
/// Colours and atom numbers do not count.
/// @param how  everything else that affects texels: directions, budget, path, device, driver
std::string occlusionCacheName(const Representation& representation, std::string_view how);

/// File name of an atlas with bounced light, on which colours count. @param name  of the bake that it is made of
std::string bouncedCacheName(const Representation& representation, std::string_view name);

/// The stored bake of this name. Empty if it is missing or damaged, or does not fit the representation or the device's
/// largest image side `mostSide`.
std::optional<FinishedOcclusion> readOcclusion(const DiskCache& cache, const std::string& name,
                                               const Representation& representation, std::uint32_t mostSide = 1 << 16);

/// @returns false if it could not be stored
bool writeOcclusion(const DiskCache& cache, const std::string& name, const FinishedOcclusion& finished);

}  // namespace nacre
