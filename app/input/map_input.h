#pragma once
// Cache of density maps in memory.

#include <memory>
#include <string>

#include "engine/volume/read_map.h"

namespace nacre::app {

/// A map by its file, or by a name from keepMap(). Read once, and again when the file has changed. @throws Error
std::shared_ptr<const DensityMap> mapOf(const std::string& path, const MapLimits& limits);

/// Keeps a map under a name that is no file: a download, or values in memory.
void keepMap(const std::string& name, std::shared_ptr<const DensityMap> map);
/// The map last read from a file or kept under a name; null: none.
std::shared_ptr<const DensityMap> keptMap(const std::string& name);

}  // namespace nacre::app
