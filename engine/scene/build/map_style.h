#pragma once

#include <cstdint>

namespace nacre {

/// Style of a density map's isosurface: the lines where it crosses the planes of the grid ("chicken wire"), the
/// surface, or its vertices; or of the map itself, a volume that one looks into.
enum class MapStyle : std::uint8_t { automatic, mesh, surface, dots, volume };

}  // namespace nacre
