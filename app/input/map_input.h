#pragma once
// Cache of density maps in memory.

#include <memory>
#include <string>

#include "app/picture/input_options.h"
#include "engine/volume/read_map.h"

namespace nacre::app {

/// Whether INPUT is a density map.
bool isMap(const InputOptions& input);
/// The name of a map INPUT for loadMap(): its path; for an open file, a name derived from its content.
std::string mapName(const InputOptions& input);
/// Reads a map INPUT. @throws Error
DensityMap readMapInput(const InputOptions& input);
/// As above for an open file. loadMap() finds it by mapName() as long as the result is held. @throws Error
std::shared_ptr<const DensityMap> openMap(const InputOptions& input);

/// A map by its file, or by a name from keepMap() or mapName(). Read once, and again if the file changes.
/// @throws Error
std::shared_ptr<const DensityMap> loadMap(const std::string& path, const MapLimits& limits);

/// Keeps a map under a name that is not a file's: a download, or values in memory.
void keepMap(const std::string& name, std::shared_ptr<const DensityMap> map);
/// The map last read from a file or kept under a name; null: none.
std::shared_ptr<const DensityMap> keptMap(const std::string& name);

}  // namespace nacre::app
