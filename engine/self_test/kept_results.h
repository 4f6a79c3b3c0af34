#pragma once
// The folder DeviceOptions::selfTests: results of tested paths, and the note of starts.

#include <string>

#include "engine/storage/disk_cache.h"

namespace nacre {

constexpr const char* kTestedPaths = "paths-";  ///< begins the names of results
constexpr const char* kStartNote = "start";

inline DiskCache keptResults(const std::string& folder) { return {folder, 1 << 20, {kTestedPaths, kStartNote}}; }

}  // namespace nacre
