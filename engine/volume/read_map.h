#pragma once
// Reads density maps from files. Callers need this header only.

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/volume/density_map.h"

namespace nacre {

struct MapLimits {
    /// Memory for the values of a map, including a crystal's whole cell; and for a file's text.
    std::size_t maxBytes = std::size_t{2} << 30;
    std::string channel = {};  ///< of a density server's file: the header of its data block; empty: the first
};

/// Whether a file is a density map, by its first bytes (inflated) or, if these are ambiguous, by its name.
/// @param start  the first 4 kB or so
bool looksLikeMap(std::string_view name, std::string_view start);
/// As above for a file, possibly compressed; false if it cannot be read. @param name  empty: its path
bool isMapFile(const std::string& path, const std::string& name = {});

/// Reads CCP4/MRC, OpenDX, Gaussian cube, DSN6/BRIX and the BinaryCIF of density servers; inflates gzip, xz, bzip2 and
/// zstd. A crystal's map is completed to the whole cell by its space group.
/// @param name  for messages and as a hint to the format; empty: the path @throws Error what, where, why
DensityMap readMapFile(const std::string& path, const MapLimits& limits = {}, const std::string& name = {});
DensityMap readMap(const std::string& name, std::string bytes, const MapLimits& limits = {});

/// A map from values in memory. @param origin  position of the first node, Å @param periodic  a crystal's whole cell
/// @param values  the first axis fastest @throws Error
DensityMap mapOfValues(const std::string& name, const glm::ivec3& size, const UnitCell& cell, const glm::dvec3& origin,
                       bool periodic, std::vector<float> values);

}  // namespace nacre
