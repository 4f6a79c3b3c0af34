#pragma once
// Density maps as they are needed again and again: read once.

#include <memory>
#include <string>

#include "engine/volume/read_map.h"

namespace nacre::app {

/// A map by its file, or by the name that it was kept under. Read once, and read again when the file has changed.
/// @throws Error
std::shared_ptr<const DensityMap> mapOf(const std::string& path);

/// Keeps a map under a name that is no file: a download, or values in memory.
void keepMap(const std::string& name, std::shared_ptr<const DensityMap> map);
/// The one that was read from a file, or kept under a name, last; null: none is at hand.
std::shared_ptr<const DensityMap> keptMap(const std::string& name);

}  // namespace nacre::app
