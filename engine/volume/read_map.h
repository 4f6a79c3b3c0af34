#pragma once
// Reads density maps from files. This header is the only one that a caller needs.

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/volume/density_map.h"

namespace nacre {

struct MapLimits {
    /// That the values of a map may take, those of a crystal's whole cell counted; and what a file's text may.
    std::size_t maxBytes = std::size_t{2} << 30;
};

/// Whether a file is a density map, by its first bytes (inflated) or, for what they leave open, by its name.
/// @param start  the first 4 kB or so
bool looksLikeMap(std::string_view name, std::string_view start);
/// The same of a file, which may be compressed; no, where it can't be read.
bool isMapFile(const std::string& path);

/// Reads CCP4/MRC, OpenDX, Gaussian cube, DSN6/BRIX and the BinaryCIF of density servers; gzip, xz, bzip2 and zstd are
/// inflated. Of a crystal the whole cell is made by its space group. @throws Error what, where, why
DensityMap readMapFile(const std::string& path, const MapLimits& limits = {});
/// @param name  for messages and as a hint to the format
DensityMap readMap(const std::string& name, std::string bytes, const MapLimits& limits = {});

/// A map of values in memory. @param origin  place of the first node, Å @param periodic  a crystal's whole cell
/// @param values  the first axis fastest @throws Error
DensityMap mapOfValues(const std::string& name, const glm::ivec3& size, const UnitCell& cell, const glm::dvec3& origin,
                       bool periodic, std::vector<float> values);

}  // namespace nacre
